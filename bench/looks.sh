#!/bin/bash
# Draws the pictures of docs/looks.md, at final quality (QUALITY=draft: to look), of scenes
# that ship with the program: all looks, or those named. Prints how long each took.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${CYDONIA:-./cydonia}
quality=${QUALITY:-final}
pictures=${PICTURES:-docs/pictures/looks}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$pictures"

# look scene [key=value...]
draw() {
    local look=$1 scene=$2
    shift 2
    # The first camera alone; the others are of no use here.
    mkdir -p "$folder/$look"
    cp -r "scenes/$scene/." "$folder/$look"
    awk '/^\[\[render.camera\]\]/ { n++ } n < 2' "scenes/$scene/scene.toml" >"$folder/$look/scene.toml"
    local keys=(--set "render.look=$look" --set 'render.camera[0].size=[960,540]')
    for key in "$@"; do keys+=(--set "$key"); done
    local begin
    begin=$(date +%s.%N)
    "$program" render "$folder/$look/scene.toml" --quality "$quality" --quiet \
        -o "$folder/out" "${keys[@]}"
    printf '%-12s %-14s %6.1f s\n' "$look" "$scene" \
        "$(echo "$(date +%s.%N) $begin" | awk '{ print $1 - $2 }')"
    oiiotool "$folder"/out/frames/*.png --resize 600x0 --compression jpeg:80 \
        -o "$pictures/$look.jpg"
    rm -rf "$folder/out" "${folder:?}/$look"
}

all() {
    draw natural coast
    draw alpine alpine-valley
    draw winter u-valley render.sun.elevation=22 render.sun.azimuth=215
    draw green hills render.sun.azimuth=240 render.sun.elevation=20 \
        'render.camera[0].elevation=9'
    draw autumn v-valley render.sun.elevation=20
    draw tundra hills render.sun.elevation=14 'render.camera[0].elevation=9'
    draw storm alpine-valley
    draw karst tower-karst
    draw desert mesa
    draw canyon grand-canyon
    draw volcanic cinder-cone
    draw moon lunar
    draw mars crater
    draw print-white musgrave
}

if (($# == 0)); then
    all
else
    wanted=" $* "
    eval "$(declare -f draw | sed '1s/draw/drawn/')"
    draw() { if [[ $wanted == *" $1 "* ]]; then drawn "$@"; fi; }
    all
fi
