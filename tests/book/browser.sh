#!/bin/sh
# browser.sh ISECT SCRATCH: makes the book and looks at its pages in a headless Chromium. Exit status 77: none is there.
set -eu
isect=$1 scratch=$2
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
for program in node "${CHROMIUM:-chromium}"; do
  command -v "$program" >/dev/null || { echo "skipped: no $program here; on Debian: apt install chromium nodejs"; exit 77; }
done
rm -rf "$scratch"
"$isect" book --out "$scratch/site" >/dev/null
exec node "$here/pages.mjs" "$scratch/site"
