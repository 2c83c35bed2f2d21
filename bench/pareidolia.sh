#!/bin/bash
# Prints every figure of the shadow images for a folder of black-on-white pictures: each
# hidden in a mountain range of the distance method, and in any elevation models given;
# then pairs of them under two suns. Needs the bench build, or BENCH.
#   bench/pareidolia.sh FOLDER [SAMPLES] [--base DEM.tif]... [--times] [--look FOLDER]
#                       [--only PART]... [--no-two] [--no-features]
set -euo pipefail

program=${BENCH-$(dirname "$0")/../build/bench/bench/pareidolia}
if [[ ! -x $program ]]; then
    echo "no $program: cmake --preset bench && cmake --build --preset bench" >&2
    exit 2
fi
if [[ $# -eq 0 ]]; then
    sed -n '2,6s/^# \{0,1\}//p' "$0"
    exit 2
fi
exec "$program" "$@"
