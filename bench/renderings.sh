#!/bin/bash
# Draws docs/pictures/detail/renderings.jpg: both trials of Brosz 2007 as scenes, by
# example and by fBm, in the four renderings of its section 6. Needs oiiotool
# (openimageio-tools). CYDONIA names the program.
set -euo pipefail
cd "$(dirname "$0")/.."

cydonia=${CYDONIA:-./cydonia}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tiles=()
for scene in by-example sharper; do
    mkdir "$folder/$scene"
    cp -r "scenes/$scene/." "$folder/$scene"
    awk '/^\[\[render.camera\]\]/ { n++ } n < 2' "scenes/$scene/scene.toml" > "$folder/$scene/scene.toml"
    for kind in copied fractal; do
        for style in grey height slope ink; do
            "$cydonia" render "$folder/$scene/scene.toml" --engine embree --style "$style" --quiet \
                --set "terrain.stage[1].kind=\"$kind\"" --set 'render.camera[0].size=[720,405]' \
                -o "$folder/out-$scene"
            tiles+=("$folder/$scene-$kind-$style.png")
            oiiotool "$folder/out-$scene"/frames/*."$style".png --ch R,G,B --resize 360x0 -o "${tiles[-1]}"
        done
    done
done
oiiotool "${tiles[@]}" --mosaic:pad=4 4x4 --compression jpeg:40 \
    -o docs/pictures/detail/renderings.jpg
