#!/bin/bash
# Draws docs/pictures/styles.jpg: a scene in every style of the preview. Needs oiiotool
# (openimageio-tools). bench/styles.sh [SCENE]; CYDONIA names the program.
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-scenes/cinder-cone/scene.toml}
cydonia=${CYDONIA:-./cydonia}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp -r "$(dirname "$scene")/." "$folder"
awk '/^\[\[render.camera\]\]/ { n++ } n < 2' "$scene" > "$folder/scene.toml" # its first camera
tiles=()
for style in grey height slope ink contours radiance; do
    "$cydonia" render "$folder/scene.toml" --engine embree --style "$style" --quiet \
        --set 'render.camera[0].size=[720,405]' -o "$folder/out"
    oiiotool "$folder"/out/frames/*."$style".png --ch R,G,B -o "$folder/$style.png"
    tiles+=("$folder/$style.png")
done
oiiotool "${tiles[@]}" --mosaic:pad=6 2x3 --compression jpeg:60 -o docs/pictures/styles.jpg
