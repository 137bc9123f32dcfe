#!/bin/sh
# browser.sh ISECT SCRATCH [LIVE]: makes the book and looks at its pages in a headless Chromium; with LIVE, the compiled
# lessons, at what they do there. Exit status 77: there is no Chromium, or no LIVE.
set -eu
isect=$1 scratch=$2 live=${3:-}
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
for program in node "${CHROMIUM:-chromium}"; do
  command -v "$program" >/dev/null || { echo "skipped: no $program here; on Debian: apt install chromium nodejs"; exit 77; }
done
[ -z "$live" ] || [ -f "$live" ] ||
  { echo "skipped: no $live: ./run book makes it, where Debian's emscripten is or can be installed"; exit 77; }
rm -rf "$scratch"
playlist=$here/../../examples/playlists/ray-and-ball.json
if [ -n "$live" ]; then
  ! command -v emcc >/dev/null || told=$(cmake --build "$(dirname "$live")" --target isect scenes 2>&1) ||
    { echo "$told"; exit 1; }
  "$isect" book --live "$live" --live-scenes "$(dirname "$live")/live_scenes.js" --out "$scratch/site" >/dev/null
  node "$here/told.mjs" "$scratch/site"
  node "$here/light.mjs" "$scratch/site"
  node "$here/scene.mjs" "$scratch/site" "$isect"
  node "$here/sizes.mjs" "$scratch/site"
  node "$here/progress.mjs" "$scratch/site"
  node "$here/habits.mjs" "$scratch/site" "$isect"
  node "$here/hands.mjs" "$scratch/site" "$isect"
  node "$here/live.mjs" "$scratch/site" "$isect"
  "$isect" book --live "$live" --playlist "$playlist" --out "$scratch/hour" >/dev/null
  exec node "$here/hour.mjs" "$scratch/hour"
fi
"$isect" book --out "$scratch/site" >/dev/null
node "$here/light.mjs" "$scratch/site"
node "$here/sizes.mjs" "$scratch/site"
node "$here/progress.mjs" "$scratch/site"
node "$here/pages.mjs" "$scratch/site"
"$isect" book ray-sphere --scorm --out "$scratch/scorm" >/dev/null
python3 -m zipfile -e "$scratch/scorm/ray-sphere.scorm.zip" "$scratch/scorm/package"
node "$here/scorm.mjs" "$scratch/scorm/package"
"$isect" book --playlist "$playlist" --out "$scratch/hour" >/dev/null
exec node "$here/hour.mjs" "$scratch/hour"
