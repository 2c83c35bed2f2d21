#!/bin/bash
# Times our pass with all features against GRASS r.cost on the same random costs and the
# same 64 starts at 2048 x 2048, and compares what they find. Needs the bench build; where
# GRASS (package grass-core) is missing it says so and does nothing.
#   bench/r_cost.sh [r_cost program]
set -euo pipefail

if [[ ${1-} == --inside ]]; then # a GRASS session
    folder=$2
    export GRASS_VERBOSE=0
    g.region n=2048 s=0 w=0 e=2048 rows=2048 cols=2048
    r.in.bin -f input="$folder/costs.bin" output=costs bytes=4 \
        n=2048 s=0 w=0 e=2048 rows=2048 cols=2048
    starts=$(<"$folder/starts.txt")
    begin=$(date +%s.%N)
    r.cost input=costs output=least start_coordinates="$starts" memory=4000
    end=$(date +%s.%N)
    r.out.bin -f input=least output="$folder/grass.bin" bytes=8
    awk -v begin="$begin" -v end="$end" 'BEGIN { print end - begin }' >"$folder/seconds"
    exit
fi

here=$(dirname "$0")
program=${1-$here/../build/bench/bench/r_cost}
if ! command -v grass >/dev/null; then
    echo "skipped: no GRASS here (package grass-core)"
    exit 0
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" write "$folder"
TMPDIR=$folder grass --tmp-location XY --exec bash "$0" --inside "$folder" \
    >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
"$program" compare "$folder" "$(<"$folder/seconds")"
