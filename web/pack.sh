#!/bin/sh
# pack.sh FOLDER: FOLDER/isect.js and isect.wasm as one script, FOLDER/live.js.
set -eu
cd "$1"
{
  cat isect.js
  printf 'isect_module.packed = "'
  gzip -9 -n <isect.wasm | base64 -w 0
  printf '";\n'
} >live.js.new
mv live.js.new live.js
