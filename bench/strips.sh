# For scripts that draw the strips of a page of the guide, rows of hillshades in which one
# thing changes from left to right: they set `pictures` and define `finished NAME LAND`.
# Leaves them in a temporary folder. Needs oiiotool (openimageio-tools). CYDONIA names the
# program.
# shellcheck shell=bash disable=SC2154 # pictures
set -e
if ! command -v oiiotool > /dev/null; then
    echo "${0##*/}: skipped: oiiotool (package openimageio-tools) is missing"
    exit 0
fi
cydonia=$(realpath "${CYDONIA:-./cydonia}")
wanted=("$@")
mkdir -p "$pictures"
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"

# drawing NAME: an SVG 240 units wide; its shapes are read from the input.
drawing() {
    { echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 240 240" width="240" height="240">'
      cat; echo '</svg>'; } > "$1.svg"
}

# strip NAME SCENE TILE...: a tile is "KEY=VALUE|KEY=VALUE", keys of the last stage; "" is
# the scene as it is.
strip() {
    local name=$1 scene=$2 out=$tmp/out-$2 tiles=() keys=() set=() stage
    shift 2
    [[ ${#wanted[@]} -eq 0 || " ${wanted[*]} " == *" $name "* ]] || return 0
    stage=$(($(grep -c '^\[\[terrain.stage\]\]' "$scene.toml") - 1))
    for tile in "$@"; do
        IFS='|' read -ra keys <<< "$tile"
        set=()
        for key in "${keys[@]}"; do set+=(--set "terrain.stage[$stage].$key"); done
        "$cydonia" synth "$scene.toml" ${set[@]+"${set[@]}"} -o "$out" --quiet
        finished "$name" "$out"
        tiles+=("$tmp/$name-${#tiles[@]}.png")
        mv "$out/preview.png" "${tiles[-1]}"
    done
    for quality in 80 70 60 50 40; do # the first that stays below 30 KB
        oiiotool "${tiles[@]}" --mosaic:pad=0 "$#x1" --compression "jpeg:$quality" \
            -o "$pictures/$name.jpg"
        [[ $(wc -c < "$pictures/$name.jpg") -gt 30000 ]] || break
    done
    echo "$name"
}
