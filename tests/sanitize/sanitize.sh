#!/bin/bash
# The unit and message tests, random scenes and damaged files under the address and undefined-behaviour
# sanitizers: the first finding ends it. Not part of `./qs test`: the build alone takes half an hour.
#
#   tests/sanitize/sanitize.sh [SECONDS [SCENES [SEED]]]     damaged files of each kind for 60 s; 50 scenes; 1
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
scenes=${2:-50}
seed=${3:-1}
export OMP_NUM_THREADS=1
# gmsh, HDF5 and VTK keep memory until the program ends
export ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1

tests=(solver_unit_tests geometry_unit_tests io_unit_tests app_unit_tests
  geometry_message_tests io_message_tests app_message_tests)
cmake --preset sanitize
cmake --build --preset sanitize --target quicksand mutated_inputs "${tests[@]}"
for test in "${tests[@]}"; do
  echo "== $test"
  "$(find build/sanitize -type f -name "$test")" --gtest_brief=1
done

echo "== damaged files, $seconds s each, seed $seed"
"$(find build/sanitize -type f -name mutated_inputs)" "$seconds" "$seed"

echo "== $scenes random scenes, seed $seed"
results=$(mktemp -d)
# a scene that blows up ends the laboratory with 3, which is no finding here
build/sanitize/bin/quicksand stress random --random "$scenes" --seed "$seed" --limit 1200 -o "$results" || [ $? -eq 3 ]
if grep -E ',crashed,' "$results/stress.csv"; then
  echo "rows that crashed are in $results"
  exit 1
fi
rm -r "$results"
echo "no finding"
