#!/bin/sh
# test.sh ISECT ROOT: holds what emscripten compiled in ROOT/build/web to the native program. Exit status 77: it is not built.
set -eu
isect=$1 root=$2
command -v emcc >/dev/null || { echo "skipped: no emscripten here; on Debian: apt install emscripten"; exit 77; }
[ -f "$root/build/web/replay.js" ] ||
  { echo "skipped: build it first: emcmake cmake -S web -B build/web -G Ninja && cmake --build build/web"; exit 77; }
told=$(cmake --build "$root/build/web" 2>&1) || { echo "$told"; exit 1; }
command -v node >/dev/null || { echo "skipped: no node here; on Debian: apt install nodejs"; exit 77; }
exec node "$root/web/replay.mjs" "$root/build/web" "$root" "$isect" "$root/../shared/peer-cases"
