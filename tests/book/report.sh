#!/bin/sh
# report.sh ISECT SCRATCH: changes figures, makes the report of a check, and reviews it in a headless Chromium. Exit status
# 77: there is no Chromium.
set -eu
isect=$1 scratch=$2
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
for program in node "${CHROMIUM:-chromium}"; do
  command -v "$program" >/dev/null || { echo "skipped: no $program here; on Debian: apt install chromium nodejs"; exit 77; }
done
rm -rf "$scratch"
mkdir -p "$scratch/figs"
cd "$scratch"

# preset NAME PARAMETER VALUE
preset() {
  printf '{"lesson": "intervals", "preset": "touching", "parameters": {"%s": %s}}\n' "$2" "$3" >"figs/$1.json"
}
for name in a b c; do preset "$name" b_max 4; done
preset other a_min 0.5
"$isect" check --dir figs --update=missing >/dev/null
for name in a b c; do preset "$name" b_max 5; done
preset other a_min 0.25
status=0
"$isect" check --dir figs --report report.html >/dev/null || status=$?
[ "$status" = 1 ] || { echo "the check of changed figures ended with $status"; exit 1; }
exec node "$here/report.mjs" "$scratch" "$isect"
