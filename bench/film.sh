#!/bin/bash
# Prints what frames of a finished land take on this machine: a draft of 640x360 over 512
# samples, a preview of 1280x720 and a final frame of 1920x1080 over 1024, and a look by
# Embree of 960x540: the whole command, and of it what a sequence does once.
# bench/film.sh [SCENE]; CYDONIA names the program. bench/passes has the passes.
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-scenes/mountain-range/scene.toml}
cydonia=${CYDONIA:-./cydonia}
$cydonia --version
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The first camera alone; the scene's own files lie beside it.
cp -r "$(dirname "$scene")/." "$folder"
awk '/^\[\[render.camera\]\]/ { n++ } n < 2' "$scene" > "$folder/scene.toml"

now() { date +%s.%N; }
# frame NAME SAMPLES WIDTH HEIGHT OPTION...
frame() {
    local name=$1 keys=(--set "terrain.samples=$2" --set "render.camera[0].size=[$3,$4]")
    local out=$folder/out-$2 begin
    shift 4
    [[ -d $out ]] || "$cydonia" synth "$folder/scene.toml" "${keys[@]}" --quiet -o "$out" > /dev/null
    begin=$(now)
    "$cydonia" render "$folder/scene.toml" "${keys[@]}" "$@" -o "$out" 2> "$folder/log" > /dev/null ||
        { cat "$folder/log" >&2; return 1; }
    echo "$(now) $begin" | awk -v name="$name" '
        NR == FNR { whole = $1 - $2; next }
        # Steps end in their time: "trace low      1.83 s".
        $NF == "s" && $1 == "emit" && $2 == "land" || $1 ~ /^(check|report)$/ { once += $(NF - 1) }
        END { printf "%-8s %6.2f s, %5.2f s of it once\n", name, whole, once }' - "$folder/log"
}

echo "== $scene"
frame draft 512 640 360 --quality draft
frame preview 1024 1280 720 --quality preview
frame final 1024 1920 1080 --quality final
frame embree 1024 960 540 --engine embree
