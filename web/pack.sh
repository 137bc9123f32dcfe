#!/bin/sh
# pack.sh FOLDER NAME LIVE: FOLDER/NAME.js and NAME.wasm as one script, FOLDER/LIVE.js; and NAME.wasm as it is, LIVE.wasm.
set -eu
cd "$1"
# zopfli writes what gzip does, a twentieth smaller.
if command -v zopfli >/dev/null; then zopfli --gzip -c "$2.wasm"; else gzip -9 -n -c "$2.wasm"; fi >"$2.wasm.gz"
{
  cat "$2.js"
  printf 'isect_module.packed = "'
  base64 -w 0 "$2.wasm.gz"
  printf '";\n'
} >"$3.js.new"
cp "$2.wasm" "$3.wasm"
mv "$3.js.new" "$3.js"
