#!/bin/bash
# Draws docs/pictures/lights.jpg, at final quality (QUALITY=draft: to look): one valley at
# golden hour, at noon, under an overcast and by the moon. Needs oiiotool
# (openimageio-tools). bench/lights.sh [SCENE]; CYDONIA names the program.
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-scenes/alpine-valley/scene.toml}
cydonia=${CYDONIA:-./cydonia}
quality=${QUALITY:-final}
picture=${PICTURE:-docs/pictures/lights.jpg}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$(dirname "$scene")/." "$folder"
awk '/^\[\[render.camera\]\]/ { n++ } n < 2' "$scene" > "$folder/scene.toml" # its first camera
tiles=()
# light NAME AZIMUTH ELEVATION [key=value...]
light() {
    local name=$1 keys=(--set "render.sun={azimuth=$2,elevation=$3}")
    shift 3
    for key in "$@"; do keys+=(--set "$key"); done
    "$cydonia" render "$folder/scene.toml" --quality "$quality" --quiet \
        --set 'render.camera[0].size=[960,540]' "${keys[@]}" -o "$folder/out"
    oiiotool "$folder"/out/frames/*.png --resize 600x0 -o "$folder/$name.png"
    tiles+=("$folder/$name.png")
}
light golden 280 10
light noon 200 58
light overcast 200 40 'render.sky.clouds="overcast"'
light moonlit 235 35 render.sky.moon=1.0
oiiotool "${tiles[@]}" --mosaic:pad=6 2x2 --compression jpeg:65 -o "$picture"
