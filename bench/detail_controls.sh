#!/bin/bash
# Draws the strips of docs/detail.md, one for every control of the detail method. Needs
# oiiotool (openimageio-tools). CYDONIA names the program.
#
#     bench/detail_controls.sh [NAME...]     # all strips, or only these
set -euo pipefail
cd "$(dirname "$0")/.."
pictures=$PWD/docs/pictures/detail
base=$PWD/scenes/by-example/base.asc
. bench/strips.sh

finished() { :; }

# scene NAME: details on a base of 20 x 20; the rest of it is read from the input.
scene() {
    { printf 'seed = 5\n[terrain]\nextent = [4800, 4800]\nsamples = 240\n'
      printf '[[terrain.stage]]\nmethod = "dem"\nsource = "%s"\n' "$base"
      printf '[[terrain.stage]]\nmethod = "detail"\nscale = 0.24\nlevels = 4\n'
      printf 'targets = "package:jacksboro"\nsearch = "exhaustive"\n'
      printf 'strength = 0.7\norientations = 8\n'
      cat; } > "$1.toml"
}

drawing paint << 'SVG'
<path d="M0 0h110L130 240H0z" fill="#c83c28"/><path d="M140 0h100v240h-80z" fill="#2850dc"/>
SVG

scene plain < /dev/null
scene mapped << 'TOML'
[[terrain.stage.mapping]]
to = [0.35, 0.6]
size = [0.5, 0.5]
TOML
scene outlined << 'TOML'
[[terrain.stage.mapping]]
outline = [[0.1, 0.2], [0.6, 0.3], [0.9, 0.9], [0.3, 0.8]]
TOML
cat > painted.toml << 'TOML'
seed = 5
[terrain]
extent = [4800, 4800]
samples = 240
[[terrain.stage]]
method = "dem"
source = "BASE"
[[terrain.stage]]
method = "detail"
levels = 4
strength = 0.7
orientations = 8
[[terrain.stage.target]]
source = "package:jacksboro"
scale = 0.24
colour = "#c83c28"
[[terrain.stage.target]]
source = "package:topography"
colour = "#2850dc"
TOML
sed -i "s|BASE|$base|" painted.toml
cat > real.toml << 'TOML'
seed = 5
[terrain]
extent = [5000, 5000]
samples = 240
[[terrain.stage]]
method = "dem"
source = "package:jacksboro"
position = [0.5, 0.72]
[[terrain.stage]]
method = "detail"
targets = "package:jacksboro"
scale = 0.25
levels = 2
search = "exhaustive"
TOML

strip kind plain strength=0 "" 'kind="multifractal"' 'kind="fractal"'
strip targets plain "" 'targets="package:topography"|scale=1'
strip scale plain scale=0.12 "" scale=0.5
strip levels plain levels=1 levels=2 levels=3 ""
strip strength plain strength=0 strength=0.35 "" strength=1.4
strip search plain 'search="random"|orientations=1' 'search="random"' 'search="patchmatch"' ""
strip block plain block=0.3 block=0.15 "" block=0.04
strip filter plain "" 'filter="haar"' 'filter="faber"' 'filter="cubic"'
strip adapt real strength=0 "" adapt=true 'kind="fractal"'
strip mapping mapped "" 'mapping[0].from=[0.3,0.7]' 'mapping[0].size=[0.9,0.3]'
strip outline outlined "" strength=1.4
strip paint painted 'paint="paint.svg"'
