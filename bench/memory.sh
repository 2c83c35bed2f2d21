#!/bin/bash
# Predicted against measured peak memory, for a scene (default: the demo) at several sizes:
#   bench/memory.sh [scene.toml [goal [samples...]]]
set -euo pipefail
scene=${1-scenes/text/scene.toml}
goal=${2-check}
[[ $# -gt 2 ]] && sizes=("${@:3}") || sizes=(256 512 1024 2048)
cydonia=$(dirname "$0")/../cydonia

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
printf '%8s  %-14s %s\n' samples predicted measured
for samples in "${sizes[@]}"; do
    making=("$goal" "$scene" --set "terrain.samples=$samples" -o "$out/$samples")
    predicted=$("$cydonia" "${making[@]}" --dry-run | sed -n 's/^memory: \(.*\) at most.*/\1/p')
    "$cydonia" "${making[@]}" --quiet --force
    measured=$("$cydonia" info "$out/$samples/manifest.json" | sed -n 's/^ *peak memory *//p')
    printf '%8s  %-14s %s\n' "$samples" "$predicted" "$measured"
done
