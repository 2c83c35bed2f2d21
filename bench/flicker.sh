#!/bin/bash
# Prints how much the light of a slow orbit (half a degree a frame) flickers, with radiosity
# (preview and final quality) and without (draft): bench/flicker.sh BUILD_FOLDER [SCENE]
set -euo pipefail
cd "$(dirname "$0")/.."

flicker=$1/bench/flicker
scene=${2:-scenes/cinder-cone/scene.toml}
cydonia=${CYDONIA:-./cydonia}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for quality in draft preview final; do
    $cydonia film "$scene" --quality $quality --size 960x540 --frames 3 --quiet \
        --set 'render.camera[0].azimuth={keys=[[0,240.0],[2,241.0]]}' \
        --set 'render.passes.which=["depth","motion"]' -o "$work/$quality"
    echo "$quality: $("$flicker" "$work/$quality/frames" film)"
done
