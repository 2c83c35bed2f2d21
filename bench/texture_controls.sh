#!/bin/bash
# Draws the strips of docs/your-own-mountains.md, one for every control of the texture
# method. Needs oiiotool (openimageio-tools). CYDONIA names the program.
#
#     bench/texture_controls.sh [NAME...]     # all strips, or only these
set -euo pipefail
cd "$(dirname "$0")/.."
pictures=$PWD/docs/pictures/texture
. bench/strips.sh

finished() { :; }

# scene NAME [METRES]: land of Jacksboro's cells; the rest of it is read from the input.
scene() {
    { printf 'seed = 5\n[terrain]\nextent = [%d, %d]\nsamples = 240\n' "${2:-20000}" "${2:-20000}"
      printf '[[terrain.stage]]\nmethod = "texture"\nexemplars = "package:jacksboro"\n'
      cat; } > "$1.toml"
}

drawing paint << 'SVG'
<path d="M0 0h240v240h-240z" fill="#2850dc"/><circle cx="120" cy="120" r="75" fill="#c83c28"/>
SVG
drawing band << 'SVG'
<path d="M0 200 L240 40" stroke="#c83c28" stroke-width="24" shape-rendering="crispEdges"/>
<path d="M0 0h150L0 100z M240 240h-150L240 140z" fill="#2850dc" shape-rendering="crispEdges"/>
SVG

scene plain < /dev/null
scene point << 'TOML'
[[terrain.stage.point]]
at = ["50 %", "50 %"]
height = 1000.0
radius = "20 %"
TOML
scene curve << 'TOML'
[[terrain.stage.curve]]
points = [["0 %", "30 %"], ["35 %", "60 %"], ["65 %", "40 %"], ["100 %", "70 %"]]
height = 300.0
area = ["8 %", "8 %"]
TOML
scene types 40000 << 'TOML'
automatic_types = true
[[terrain.stage.type]]
name = "valleys"
colour = "#2850dc"
[[terrain.stage.type]]
name = "plateau"
colour = "#c83c28"
TOML
scene paste << 'TOML'
[[terrain.stage.paste]]
exemplar = 1
from = [0.75, 0.3]
to = ["50 %", "50 %"]
radius = 4000.0
TOML

strip exemplars plain "" 'exemplars="package:topography"' \
    'exemplars=["package:topography","package:jacksboro"]'
strip scale plain "" "scale=0.5" "scale=2.0"
strip levels plain "levels=3" "levels=4" "levels=5" "levels=6"
strip orientations plain "orientations=1" "orientations=2" "orientations=4" "orientations=8"
strip jitter plain "jitter=0" "jitter=0.4" "jitter=1.5" "jitter=4"
strip kappa plain "kappa=1" "kappa=1.5" "kappa=2" "kappa=4"

strip height point "point[0].height=250" "point[0].height=1000" \
    "point[0].height=300|point[0].relative=true" 'point[0].height=1000|point[0].radius="8 %"'
strip gradient point "" "point[0].gradient=[0.5, 0.0]" "point[0].gradient=[0.5, 0.5]" \
    "point[0].gradient=[0.0, -1.0]"
strip curve curve "" "curve[0].gradient=[0.2, 0.2]" \
    "curve[0].height=900|curve[0].gradient=[-0.4, -0.4]" "curve[0].height=600|curve[0].gradient=[0.0, -1.0]"
strip handle curve "curve[0].handle=[{at=0, height=300}, {at=1, height=900}]" \
    "curve[0].handle=[{at=0, height=300}, {at=0.5, height=900}, {at=1, height=300}]" \
    'curve[0].area=["2 %", "20 %"]' \
    'curve[0].handle=[{at=0, area=["2 %", "2 %"]}, {at=1, area=["20 %", "20 %"]}]'
strip types types "" 'paint="paint.svg"' 'paint="band.svg"'
strip paste paste "" "paste[0].turn=90" "paste[0].raise=300" "paste[0].from=[0.2, 0.7]|paste[0].mirror=true"
