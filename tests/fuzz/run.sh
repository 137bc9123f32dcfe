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
split -l 1 "$root/tests/program/query_examples.jsonl" seeds/query_fuzz/example-
for target in ${*:-query_fuzz cases_fuzz polygon_fuzz}; do
  mkdir -p "corpus/$target" "seeds/$target"
  echo "fuzz: $target for $seconds s" >&2
  "tests/fuzz/$target" -max_total_time="$seconds" -timeout=20 -max_len=4096 -print_final_stats=1 \
    -artifact_prefix="$target-" "corpus/$target" "seeds/$target" 2>"$target.log" || { tail -n 40 "$target.log" >&2; exit 1; }
  grep -E 'number_of_executed_units|cov:.*DONE|DONE' "$target.log" >&2
done
