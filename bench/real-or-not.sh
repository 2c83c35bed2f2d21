#!/bin/bash
# Can a fresh pair of eyes tell land made of real land from real land? The paper's study
# (Gain, Merry and Marais 2015, section 6), with pictures to look at. Needs the bench
# build, or BENCH.
#   bench/real-or-not.sh FOLDER EXEMPLAR...      makes 40 pairs, or PAIRS
#   bench/real-or-not.sh --score FOLDER
# FOLDER/pair-01.png shows A, left, and B, each from above over close up: one is a piece of
# a real model, the other as much land made of that model, both equally turned, lit and
# seen. Write into FOLDER/answers.txt which is real, "01 A", and look at nothing else:
# `key` tells who knows how to read it. Exit code 3 when more than 60 % were right.
set -euo pipefail

program=${BENCH-$(dirname "$0")/../build/bench/bench/real_or_not}
if [[ ! -x $program ]]; then
    echo "no $program: cmake --preset bench && cmake --build --preset bench" >&2
    exit 2
fi
if [[ $# -lt 2 ]]; then
    sed -n '2,10s/^# \{0,1\}//p' "$0"
    exit 2
fi
[[ $1 != --score ]] || exec "$program" --score "$2"
folder=$1
shift
exec "$program" "$folder" "${PAIRS:-40}" "$@"
