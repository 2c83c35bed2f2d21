#!/bin/bash
# Times the demo at draft quality, from an empty output folder: wall time, the time of each
# step and the peak memory, the last two as the run's manifest has them.
set -euo pipefail
cd "$(dirname "$0")/.."

./cydonia --version # builds it when needed, before the clock starts
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

begin=$(date +%s.%N)
./cydonia render scenes/text/scene.toml --quality draft --quiet -o "$out"
end=$(date +%s.%N)
./cydonia render scenes/text/scene.toml --quality draft --quiet -o "$out"
again=$(date +%s.%N)

./cydonia info "$out/manifest.json"
./cydonia info "$out/manifest.json" | awk -v begin="$begin" -v end="$end" -v again="$again" '
    $NF == "s" && ($1 ~ /^[0-9]+$/ || $1 == "check") { land += $(NF - 1) }
    END {
        printf "synthesis and check          %8.2f s\n", land
        printf "wall time of the demo        %8.2f s\n", end - begin
        printf "the same again, all done     %8.2f s\n", again - end
    }'
