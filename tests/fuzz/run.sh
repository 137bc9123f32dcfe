#!/bin/sh
# Builds fuzz targets with clang and libFuzzer, and runs each for a while.
#
#   tests/fuzz/run.sh [SECONDS] [TARGET...]     60 s of every target if nothing is said
#
# An input that breaks a target is kept in build/fuzz/findings/TARGET, and replayed by giving it to the target's
# program, build/fuzz/tests/fuzz/TARGET. The next target runs all the same. Exit: 0 nothing was found; 1 something was,
# or a target does not build; 2 there is no such target, or no clang.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=$root/build/fuzz
all="query_fuzz cases_fuzz polygon_fuzz files_fuzz scene_file_fuzz scenes_fuzz state_fuzz figure_fuzz results_fuzz
  theme_fuzz trace_fuzz"

refuse() { printf 'fuzz: %s\n' "$*" >&2; exit 2; }
seconds=${1:-60}
case $seconds in '' | *[!0-9]*) refuse "give a number of seconds first, not '$seconds'" ;; esac
[ $# -eq 0 ] || shift
targets=${*:-$all}
for target in $targets; do
  case " $(echo $all) " in *" $target "*) ;; *) refuse "there is no target '$target'; there are:" $all ;; esac
done
command -v clang++ >/dev/null || refuse "there is no clang++ here; on Debian: apt install clang"

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1 -DNDEBUG" -DCMAKE_CXX_COMPILER=clang++ \
  -DISECT_VIZ=OFF -DISECT_BENCH=OFF -DBUILD_TESTING=OFF -DISECT_FUZZ=ON >/dev/null
cd "$build"

# ---- seeds

# seed FILE BEFORE REPEATED COUNT AFTER: deep or wide texts, that no short input grows into
seed() {
  awk -v before="$2" -v part="$3" -v count="$4" -v after="$5" \
    'BEGIN { printf "%s", before; for (i = 0; i < count; i++) printf part, i, i; printf "%s", after }' \
    >"seeds/$target/$1"
}
seeds_of_query_fuzz() {
  split -l 1 "$root/tests/app/query_examples.jsonl" seeds/query_fuzz/example-
  seed deep-id '{"id":' '[' 75000 ''
  seed deep-object '' '{"a":' 65 ''
  seed closed "{\"id\":$(printf '[%.0s' $(seq 100))" ']' 100 ',"kind":"orient2d","a":[0,0],"b":[1,0],"c":[0,1]}'
  seed wide-keys '{"kind":"orient2d"' ',"k%d":%d' 40000 '}'
  seed wide-then-deep "{$(seq -s ' ' 3000 | sed 's/[0-9]*/"&":0,/g')\"z\":$(printf '[%.0s' $(seq 63))" '[],' 75000 '[]'
  seed wide-points '{"kind":"convex_hull2d","points":[[0,0]' ',[%d,0.%d]' 20000 ']}'
  seed wide-ring '{"kind":"pip","variant":"trapezoids","point":[1,1],"rings":[[[0,9]' ',[%d,0.%d]' 5000 ']]}'
  seed long-text '{"id":"' 'abcdefgh' 60000 '"}'
}

# Each file of every dialect, behind the number of its reader.
seeds_of_files_fuzz() {
  for file in "$root"/tests/files/*.*; do
    case ${file##*.} in
      csv | tsv | txt) reader=0 ;; xyz) reader=1 ;; obj | OBJ) reader=2 ;; stl | STL) reader=3 ;; ply | PLY) reader=4 ;;
      off) reader=5 ;; geojson | json) reader=6 ;; wkt) reader=7 ;; *) continue ;;
    esac
    { printf "\\00$reader"; cat "$file"; } >"seeds/files_fuzz/${file##*/}"
  done
}

# The examples, whose meshes and tables are those of named_files.cpp, and some of the hard cases.
seeds_of_scene_file_fuzz() {
  for file in "$root"/examples/*.json; do
    sed 's/[a-z-]*\.obj/mesh.obj/; s/[a-z-]*\.csv/points.csv/' "$file" >"seeds/scene_file_fuzz/${file##*/}"
  done
  echo '{"objects": [{"polygon": "P", "file": "rings.wkt"}, {"point": "q", "at": [1, 2]}], "ask": "all pairs"}' \
    >seeds/scene_file_fuzz/rings.json
  for file in plane space; do
    awk 'NR % 10 == 0 && length($0) < 2000' "$root/tests/cases/scenes/$file.jsonl" |
      sed 's/^{"id": [0-9]*, "note": "[^"]*", /{/; s/, "expected": .*/}/' |
      split -l 1 -a 3 - "seeds/scene_file_fuzz/$file-"
  done
}

# The examples, and every value of a theme.
seeds_of_theme_fuzz() {
  cp "$root"/examples/themes/*.json seeds/theme_fuzz/
  echo '{"based on": "dark", "lines": 1.2, "hatch": true, "colours": ["#0af", "#fa0"], "roles": {"panel": "#000"}}' \
    >seeds/theme_fuzz/short.json
}

seeds_of_results_fuzz() {
  cp "$root/bench/proof.json" seeds/results_fuzz/
  # The first lines of each list are enough, and quicker to change.
  awk '/^"(rows|growths|duties|notes|targets)": \[/ { n = 0; print; next }
       /^\]/ { print; next }
       /^{"/ && !/^{"machine"/ { if (++n > 2) next; sub(/},?$/, "}"); if (n > 1) printf ","; print; next }
       { print }' "$root/bench/results.json" >seeds/results_fuzz/few.json
}

seeds_of_trace_fuzz() {
  cp "$root/examples/snapshots/scene/exact-touch/trace.json" seeds/trace_fuzz/
  seed deep '{"format": 3, "steps": [' '[' 100000 ''
  seed deep-and-whole '{"format": 3, "steps": [], "made with": {"font": ' '[' 100000 \
    "$(awk 'BEGIN { for (i = 0; i < 100000; i++) printf "]" }')}}"
}

# Some targets write seeds themselves, in the format of the day.
own_seeds() { ISECT_FUZZ_SEEDS=seeds/$1 "tests/fuzz/$1" -runs=0 2>/dev/null; }

# The option for a dictionary of the quoted words in a target's seeds.
words_of() {
  cat "seeds/$1"/* | grep -aoE '"[A-Za-z_][A-Za-z0-9_. -]{0,30}"' | sort -u | sed 's/.*/"\\&/; s/"$/\\""/' >"$1.dict"
  echo "-dict=$1.dict"
}

# ---- runs

failed=
for target in $targets; do
  echo "fuzz: $target for $seconds s" >&2
  rm -rf "seeds/$target" && mkdir -p "corpus/$target" "seeds/$target" "findings/$target"
  cmake --build . --target "$target" >"$target.log" 2>&1 ||
    { tail -n 40 "$target.log" >&2; failed="$failed $target"; continue; }
  export LSAN_OPTIONS="suppressions=$root/tests/lsan.supp:print_suppressions=0"
  size=4096 words=-verbosity=1  # those that draw numbers from the bytes need no more
  case $target in
    query_fuzz) seeds_of_query_fuzz; size=1000000 words=-dict=$root/tests/fuzz/query.dict ;;
    files_fuzz) seeds_of_files_fuzz ;;
    scene_file_fuzz | results_fuzz | theme_fuzz) "seeds_of_$target"; size=16384 words=$(words_of "$target") ;;
    trace_fuzz) seeds_of_trace_fuzz; size=1000000 words=$(words_of "$target") ;;
    state_fuzz) own_seeds "$target"; words=$(words_of "$target") ;;
    figure_fuzz) own_seeds "$target"; size=16384 ;;
  esac
  "tests/fuzz/$target" -max_total_time="$seconds" -timeout=20 -max_len=$size "$words" -print_final_stats=1 \
    -artifact_prefix="findings/$target/" "corpus/$target" "seeds/$target" 2>"$target.log" || {
    tail -n 40 "$target.log" >&2
    echo "fuzz: $target found something; the input is in build/fuzz/findings/$target" >&2
    failed="$failed $target"
    continue
  }
  grep -E 'number_of_executed_units|cov:.*DONE|DONE' "$target.log" >&2
done
[ -z "$failed" ] || { echo "fuzz: to be mended:$failed" >&2; exit 1; }
echo "fuzz: nothing was found" >&2
