#!/bin/bash
# Draws the strips of docs/distance.md, one for every control of the distance method: a row
# of hillshades in which one thing changes from left to right. Needs oiiotool
# (openimageio-tools). CYDONIA names the program.
#
#     bench/controls.sh [NAME...]     # all strips, or only these
set -euo pipefail
cd "$(dirname "$0")/.."

pictures=$PWD/docs/pictures/distance
. bench/strips.sh

# scene NAME: a land with one distance stage; the rest of it is read from the input.
scene() {
    { printf '[terrain]\nsamples = 240\n[[terrain.stage]]\nmethod = "distance"\n'; cat; } > "$1.toml"
}

# to_scale LAND: how land slopes to the north-west, in greys that mean the same in every
# tile; a preview evens that out.
to_scale() {
    oiiotool "$1/terrain.exr" "$1/terrain.exr" --origin +1+1 --sub --cut 239x239+1+1 --mulc 0.006 \
        --addc 0.5 --clamp:min=0:max=1 --ch 0,0,0 -d uint8 -o "$1/preview.png"
}

# What becomes of a tile of strip NAME before it is put beside the others.
finished() {
    [[ " mean-edge-weight sea-level-scale vertical-scale " != *" $1 "* ]] || to_scale "$2"
}

drawing ridge << 'SVG'
<path d="M35 150 C80 60 120 200 205 90" fill="none" stroke="black" stroke-width="1.5"/>
SVG
drawing pair << 'SVG'
<path d="M30 70 C90 50 150 110 210 80 M30 150 C90 170 150 120 210 160" fill="none" stroke="black" stroke-width="1.5"/>
SVG
drawing ring << 'SVG'
<circle cx="120" cy="120" r="62" fill="none" stroke="black" stroke-width="1.5"/>
SVG
drawing east << 'SVG'
<path d="M120 0h120v240h-120z"/>
SVG
drawing strokes << 'SVG'
<path d="M30 60 C90 30 150 110 210 50" fill="none" stroke="#d02020" stroke-width="1.5" shape-rendering="crispEdges"/>
<path d="M30 170 C90 220 150 130 210 190" fill="none" stroke="#2040d0" stroke-width="1.5" shape-rendering="crispEdges"/>
SVG
drawing river << 'SVG'
<path d="M0 130 C70 60 130 190 240 110" fill="none" stroke="black" stroke-width="3"/>
SVG
drawing lake << 'SVG'
<path d="M60 120 C60 60 120 70 140 95 S200 100 190 150 S100 190 80 165 S60 140 60 120z"/>
SVG
drawing ramp << 'SVG'
<linearGradient id="ramp"><stop offset="0"/><stop offset="1" stop-color="white"/></linearGradient>
<path d="M0 0h240v240h-240z" fill="url(#ramp)"/>
SVG
drawing spots << 'SVG'
<radialGradient id="spot"><stop offset="0"/><stop offset="1" stop-color="white"/></radialGradient>
<path d="M0 0h240v240h-240z" fill="white"/>
<circle cx="75" cy="80" r="60" fill="url(#spot)"/><circle cx="165" cy="155" r="70" fill="url(#spot)"/>
SVG
drawing shapes << 'SVG'
<path d="M0 0h240v240h-240z" fill="white"/>
<circle cx="65" cy="70" r="40" fill="#000000"/><path d="M135 35h70v70h-70z" fill="#606060"/>
<path d="M65 140l45 70h-90z" fill="#909090"/><circle cx="170" cy="170" r="38" fill="#c0c0c0"/>
SVG

scene cones << 'TOML'
sea_level_scale = 8.0
neighbours = 16
[[terrain.stage.group]]
peaks = { count = 7 }
cost = { kind = "random", range = ["2 %", "4 %"] }
TOML
scene hills << 'TOML'
neighbours = 16
[[terrain.stage.group]]
peaks = { count = 16 }
ridges = { count = 20 }
profile = "alpine"
TOML
scene ridge << 'TOML'
sea_level_scale = 2.5
neighbours = 16
[[terrain.stage.group]]
strokes = { image = "ridge.svg" }
cost = { kind = "noise", range = ["3 %", "5 %"] }
profile = "own"
[[terrain.stage.profile]]
name = "own"
like = "alpine"
reach = "22 %"
TOML
scene pair << 'TOML'
sea_level_scale = 2.5
neighbours = 16
edge_weight_deviation = 0.6
[[terrain.stage.group]]
strokes = { image = "pair.svg" }
cost = { kind = "random", range = ["3 %", "6 %"] }
profile = "wide"
[[terrain.stage.profile]]
name = "wide"
like = "alpine"
reach = "40 %"
TOML
scene colours << 'TOML'
sea_level_scale = 2.5
neighbours = 16
[[terrain.stage.group]]
name = "red"
strokes = { image = "strokes.svg", colour = "#d02020" }
cost = { kind = "noise", range = ["2 %", "4 %"] }
profile = "alpine"
[[terrain.stage.group]]
name = "blue"
strokes = { image = "strokes.svg", colour = "#2040d0" }
cost = { kind = "noise", range = ["2 %", "4 %"] }
profile = "alpine"
TOML
scene many << 'TOML'
sea_level_scale = 1.2
neighbours = 16
[[terrain.stage.group]]
peaks = { count = 90 }
cost = { range = [0.0, "8 %"] }
profile = "cone"
TOML
scene rim << 'TOML'
sea_level_scale = 1.5
neighbours = 16
[[terrain.stage.group]]
name = "rim"
strokes = { image = "ring.svg" }
cost = { range = [0.0, "4 %"] }
profile = "crater-rim"
[[terrain.stage.group]]
name = "hills"
peaks = { count = 70 }
cost = { range = ["3 %", "6 %"] }
profile = "dome"
TOML
scene crater << 'TOML'
sea_level_scale = 5.0
neighbours = 16
[[terrain.stage.group]]
name = "rim"
strokes = { image = "ring.svg" }
cost = { range = ["2 %", "3 %"] }
profile = "crater-rim"
TOML
scene circles << 'TOML'
neighbours = 16
[[terrain.stage.group]]
circles = { count = 12, radius = ["3 %", "5 %"], roughness = 0.0 }
profile = "crater-rim"
TOML
scene edges << 'TOML'
neighbours = 16
[[terrain.stage.group]]
edges = { image = "shapes.svg" }
cost = { range = [0.0, "3 %"] }
profile = "cone"
TOML
scene terraces << 'TOML'
mean_edge_weight = 1.0
edge_weight_deviation = 0.5
blending_bias = 8.0
neighbours = 16
[[terrain.stage.group]]
terraces = { image = "river.svg", level = [{ range = [0.5, 1.0], cost = 0.0 }] }
profile = "terrace"
TOML
scene lip << 'TOML'
neighbours = 16
[[terrain.stage.group]]
lip = { image = "river.svg", distance = "4 %" }
cost = { range = [0.0, "3 %"] }
profile = "cliff"
TOML
scene lake << 'TOML'
neighbours = 16
sea_level_scale = 1.4
[[terrain.stage.group]]
peaks = { count = 30 }
ridges = { count = 30 }
profile = "hill"
[[terrain.stage.water]]
image = "lake.svg"
TOML
scene second << 'TOML'
sea_level_scale = 2.0
[[terrain.stage.group]]
strokes = { image = "ridge.svg" }
cost = { range = [0.0, "5 %"] }
profile = "alpine"
[[terrain.stage]]
method = "distance"
sea_level_scale = 2.0
[[terrain.stage.group]]
strokes = { image = "ring.svg" }
cost = { range = [0.0, "5 %"] }
profile = "dome"
TOML

# Where features are.
strip colours colours '' 'group[1].profile=dome' 'group[1].profile=mesa' \
    'group[1].cost={kind="random", range=["7 %", "7 %"]}'
strip keep-out-apart-away rim '' 'group[1].peaks.keep_out="east.svg"' \
    'group[1].peaks.apart="9 %"' 'group[1].peaks.away=[{from="rim", distance="14 %"}]'
strip circles circles '' 'group[0].circles.radius=["3 %", "12 %"]' \
    'group[0].circles={count=12, radius=["3 %", "12 %"], roughness=0.1}' \
    'group[0].circles={count=12, radius=["3 %", "12 %"], roughness=0.4}'
strip edges edges 'group[0].edges.threshold='{0.15,0.3,0.5,0.8}
strip terraces terraces \
    'group[0].terraces.level=[{range=[0.5,1.0],cost=0.0},{range=[0.2,0.5],cost="6 %"}]' \
    'group[0].terraces.level=[{range=[0.7,1.0],cost=0.0},{range=[0.4,0.7],cost="5 %"},{range=[0.15,0.4],cost="10 %"}]'
strip lip lip 'group[0].lip.distance="'{2,4,8,12}' %"'
strip ridges ridge '' 'group[0].ridges.count=15' 'group[0].ridges.count=60' \
    'group[0].ridges={count=60, reach="8 %"}'
strip ridges-cost ridge 'group[0].ridges={count=40, cost_factor='{0.0,0.4,1.0}'}'

# How high they are.
strip cost-kinds many '' \
    'group[0].cost={kind="noise", noise={kind="ridged", grid=8, h=1, octaves=6}, range=[0.0, "8 %"]}' \
    'group[0].cost={kind="random", range=[0.0, "8 %"]}' \
    'group[0].cost={kind="distance", range=[0.0, "8 %"]}'
strip cost-more ridge \
    'group[0].cost={kind="painted", image="ramp.svg", range=[0.0, "12 %"]}|sea_level_scale=1.2' \
    'group[0].cost={kind="drawn", points=[[0,0],[1,1],[2,0],[3,1],[4,0]], range=[0.0, "12 %"]}|sea_level_scale=1.2' \
    'group[0].strokes.image=ring.svg|group[0].cost={kind="gaussian", range=[0.0, "12 %"]}|sea_level_scale=1.2' \
    'group[0].cost={kind="minimum", of=[{kind="painted", image="ramp.svg", range=[0.0, "12 %"]}, {kind="painted", image="ramp.svg", range=[0.0, "12 %"], inverted=true}]}|sea_level_scale=1.2'
strip range-share-inverted rim 'group[1].cost={kind="distance", range=[0.0, "3 %"]}' \
    'group[1].cost={kind="distance", range=[0.0, "8 %"]}' \
    'group[1].cost={kind="distance", range=[0.0, "8 %"], inverted=true}' \
    'group[1].cost={kind="distance", share=[1.4, 1.5], share_of="rim"}'
strip sea-level-scale hills sea_level_scale={0.5,1,1.33,2}
strip vertical-scale second vertical_scale={0.5,1,2} combine=replace

# What shape they have.
strip profile ridge 'sea_level_scale=5|group[0].profile='{cone,dome,mesa,glacial}
strip strata ridge '' 'profile[0].strata={layers=4, hardness=0.9}' 'profile[0].strata={layers=10, hardness=0.9}' \
    'profile[0].strata={layers=4, hardness=0.4}'
strip detail ridge 'sea_level_scale=4|profile[0].reach="30 %"|profile[0].detail='{0.0,0.3,0.6,1.0}
strip other-side ridge 'sea_level_scale=4|group[0].profile='{cone,'cone|group[0].other_side=cliff','cliff|group[0].other_side=cone',cliff}

# How rough they are.
strip mean-edge-weight cones mean_edge_weight={1.1,2,3,4}
strip edge-weight-deviation cones edge_weight_deviation={0,0.5,1,1.9}
strip grain cones 'edge_weight_deviation=1.5|grain="'{0.4,1,3,8}' %"'
strip neighbours-metric cones 'edge_weight_deviation=0.0|neighbours=8|metric=thesis' \
    'edge_weight_deviation=0.0|neighbours=8' 'edge_weight_deviation=0.0'
strip maps ridge 'sea_level_scale=8|group[0].profile=[]' \
    'sea_level_scale=8|group[0].profile=[]|mean_edge_weight_map={image="ramp.svg", range=[1.1, 6.0]}' \
    'sea_level_scale=8|group[0].profile=[]|edge_weight_deviation_map={image="ramp.svg", range=[0.0, 1.9]}'
strip blending-bias-map pair blending_bias={0,15} 'blending_bias_map={image="ramp.svg", range=[0.0, 15.0]}'
strip edge-weights cones edge_weight_deviation=0.0 'edge_weights={image="spots.svg", range=[0.8, 4.0]}' \
    'edge_weights={image="shapes.svg", range=[0.8, 4.0]}'

# How they meet.
strip blending-bias pair blending_bias={0,2,4,8}
strip thresholds hills '' approximate_threshold=0.9 'sea_level_threshold="2 %"' \
    'sea_level_threshold="4 %"'

# Parts of the land, the layout.
strip region-profile crater '' 'region=[{inside="rim", profile="cone"}]' \
    'region=[{inside="rim", profile="dome"}]' 'region=[{image="east.svg", profile="dome"}]'
strip region-only rim '' 'region=[{inside="rim", profile="crater-bowl", only=["rim"]}]' \
    'region=[{inside="rim", profile="crater-bowl", only=["rim"], feather="15 %"}]' \
    'region=[{image="east.svg", only=["rim"]}]'
strip water lake '' 'water[0].depth="15 %"' 'water[0].level=150' 'water[0].shore_slope=3.0'
strip preview pair 'blending_bias=1|preview='{false,true}
