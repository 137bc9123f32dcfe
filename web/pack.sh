#!/bin/sh
# pack.sh FOLDER NAME LIVE: FOLDER/NAME.js and NAME.wasm as one script, FOLDER/LIVE.
set -eu
cd "$1"
{
  cat "$2.js"
  printf 'isect_module.packed = "'
  gzip -9 -n <"$2.wasm" | base64 -w 0
  printf '";\n'
} >"$3.new"
mv "$3.new" "$3"
