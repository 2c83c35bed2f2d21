#!/bin/bash
# Prints how long POV-Ray's trace of a frame was said to take on, and how long it did: one
# line each ten seconds of each frame. CYDONIA names the program.
#
#     bench/progress.sh [SCENE [OPTION...]]   # default: scenes/text at 640x360, final
set -euo pipefail
cd "$(dirname "$0")/.."

program=${CYDONIA:-./cydonia}
scene=${1:-scenes/text/scene.toml}
shift || true
[[ $# -gt 0 ]] || set -- --quality final --size 640x360
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Lines of a log, each with the seconds at which it came. "trace oblique: 36%, 1 min 02 s left".
"$program" render "$scene" -o "$folder/out" --force "$@" 2>&1 |
    while IFS= read -r line; do printf '%s\t%s\n' "$(date +%s.%N)" "$line"; done > "$folder/log"

awk -F'\t' '
    function seconds(text,   words, n, i, sum) {
        n = split(text, words, " ")
        for (i = 1; i < n; i += 2)
            sum += words[i] * (words[i + 1] == "h" ? 3600 : words[i + 1] == "min" ? 60 : 1)
        return sum
    }
    BEGIN { print "frame                elapsed, s   said left, s   left, s   error" }
    match($2, /^trace [^:]*: [0-9]+%, .* left/) {
        frame = $2; sub(/:.*/, "", frame); sub(/^trace /, "", frame)
        said = $2; sub(/^[^,]*, /, "", said); sub(/ left.*/, "", said)
        n++; at[n] = $1; left[n] = seconds(said); of[n] = frame
        next
    }
    match($2, /^trace [^ ]+ +[0-9]/) {      # the step is done: its name and its time
        frame = $2; sub(/^trace /, "", frame); sub(/ .*/, "", frame)
        took = $2; sub(/^trace [^ ]+ +/, "", took); took = seconds(took)
        for (i = 1; i <= n; i++) if (of[i] == frame)
            printf "%-20s %10.1f %14.1f %9.1f %+6.0f%%\n", frame, took - ($1 - at[i]),
                   left[i], $1 - at[i], 100 * (left[i] / ($1 - at[i]) - 1)
        n = 0
    }' "$folder/log"
