#!/bin/bash
# Makes one land whole and in tiles, each tile also alone in its own process, and compares
# heights, byte for byte. Needs gdal_translate (gdal-bin).
#   bench/tiles.sh [SCENE [SAMPLES [TILE]]]      default scenes/large/scene.toml 2048 1024
# Exit code 1 when anything differs.
set -euo pipefail

cydonia=${CYDONIA:-$(dirname "$0")/../cydonia}
scene=${1:-scenes/large/scene.toml} samples=${2:-2048} tile=${3:-1024}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

heights() {  # of a GeoTIFF as plain numbers, whatever its layout
    gdal_translate -q -of ENVI "$1/terrain.tif" "$1/heights" && sha256sum < "$1/heights"
}
run() {
    "$cydonia" synth "$scene" -o "$folder/$1" --set "terrain.samples=$samples" "${@:2}" \
        > /dev/null
}

run whole
run tiles --set "terrain.tiles=$tile"
count=$(((samples + tile - 1) / tile))
for ((row = count - 1; row >= 0; --row)); do
    for ((column = 0; column < count; ++column)); do
        run alone --set "terrain.tiles=$tile" --tile "$column,$row"
    done
done
whole=$(heights "$folder/whole") tiles=$(heights "$folder/tiles")
run alone --set "terrain.tiles=$tile"
alone=$(heights "$folder/alone")
echo "$scene, $samples samples, tiles of $tile"
echo "whole  $whole"
echo "tiles  $tiles"
echo "alone  $alone"
[[ $whole == "$tiles" && $whole == "$alone" ]] && echo equal || { echo different; exit 1; }
