#!/bin/sh
# bench/run.sh [BUILD_DIR]: runs every benchmark, medians of nine repetitions, and the ratios, into
# bench/results/<machine>/<date>/. Exit code 1 if a ratio misses.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/release}/bench
results=bench/results/$(uname -n)/$(date +%Y-%m-%d)
mkdir -p "$results"
for bench in "$build"/*_bench; do
  "$bench" --benchmark_repetitions=9 --benchmark_report_aggregates_only=true \
    --benchmark_out="$results/$(basename "$bench").json" --benchmark_out_format=json
done
status=0
"$build"/ratios > "$results/ratios.txt" || status=$?
if [ -x "$build"/mujoco_wrapping ]; then
  "$build"/mujoco_wrapping >> "$results/ratios.txt" || status=$?
fi
"$build"/peer_ratios >> "$results/ratios.txt" || status=$?
cat "$results/ratios.txt"
exit $status
