#!/bin/sh
# Builds the fuzz targets with clang and libFuzzer, and runs each for a while.
#
#   tests/fuzz/run.sh [SECONDS] [TARGET...]     60 s of every target if nothing is said
#
# An input that breaks a target is kept under build/fuzz, and replayed by giving it to the target's program.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=$root/build/fuzz
seconds=${1:-60}
[ $# -eq 0 ] || shift

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_COMPILER=clang++ \
  -DISECT_VIZ=OFF -DISECT_BENCH=OFF -DBUILD_TESTING=OFF -DISECT_FUZZ=ON >/dev/null
cmake --build "$build" --target fuzz >&2
cd "$build"
mkdir -p seeds/query_fuzz
split -l 1 "$root/tests/app/query_examples.jsonl" seeds/query_fuzz/example-

# seed FILE BEFORE REPEATED COUNT AFTER: deep or wide lines, that no short input grows into
seed() {
  awk -v before="$2" -v part="$3" -v count="$4" -v after="$5" \
    'BEGIN { printf "%s", before; for (i = 0; i < count; i++) printf part, i, i; printf "%s", after }' >"seeds/query_fuzz/$1"
}
seed deep-id '{"id":' '[' 75000 ''
seed deep-object '' '{"a":' 65 ''
seed closed "{\"id\":$(printf '[%.0s' $(seq 100))" ']' 100 ',"kind":"orient2d","a":[0,0],"b":[1,0],"c":[0,1]}'
seed wide-keys '{"kind":"orient2d"' ',"k%d":%d' 40000 '}'
seed wide-then-deep "{$(seq -s ' ' 3000 | sed 's/[0-9]*/"&":0,/g')\"z\":$(printf '[%.0s' $(seq 63))" '[],' 75000 '[]'
seed wide-points '{"kind":"convex_hull2d","points":[[0,0]' ',[%d,0.%d]' 20000 ']}'
seed wide-ring '{"kind":"pip","variant":"trapezoids","point":[1,1],"rings":[[[0,9]' ',[%d,0.%d]' 5000 ']]}'
seed long-text '{"id":"' 'abcdefgh' 60000 '"}'

# Each file of every dialect, behind the number of its reader.
mkdir -p seeds/files_fuzz
for file in "$root"/tests/files/*.*; do
  case ${file##*.} in
    csv | tsv | txt) reader=0 ;; xyz) reader=1 ;; obj | OBJ) reader=2 ;; stl | STL) reader=3 ;; ply | PLY) reader=4 ;;
    off) reader=5 ;; geojson | json) reader=6 ;; wkt) reader=7 ;; *) continue ;;
  esac
  { printf "\\00$reader"; cat "$file"; } >"seeds/files_fuzz/${file##*/}"
done
for target in ${*:-query_fuzz cases_fuzz polygon_fuzz files_fuzz}; do
  mkdir -p "corpus/$target" "seeds/$target"
  echo "fuzz: $target for $seconds s" >&2
  size=4096 words=-verbosity=1  # the others draw numbers from the bytes, and need no more
  [ "$target" != query_fuzz ] || size=1000000 words=-dict=$root/tests/fuzz/query.dict
  "tests/fuzz/$target" -max_total_time="$seconds" -timeout=20 -max_len=$size "$words" -print_final_stats=1 \
    -artifact_prefix="$target-" "corpus/$target" "seeds/$target" 2>"$target.log" || { tail -n 40 "$target.log" >&2; exit 1; }
  grep -E 'number_of_executed_units|cov:.*DONE|DONE' "$target.log" >&2
done
