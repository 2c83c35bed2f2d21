#!/bin/bash
# Films a turntable on a farm of two nodes that this script starts on this machine, kills one
# of them while frames are traced, and holds what comes out against a run without a farm.
# As root, with slurm-wlm and munge. bench/farm.sh [SCENE [FRAMES]]
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-scenes/text/scene.toml}
frames=${2:-24}
cydonia=${CYDONIA:-./cydonia}
$cydonia --version
work=$(mktemp -d)
trap 'tests/slurm/cluster.sh stop "$work/slurm" > /dev/null 2>&1; rm -rf "$work"' EXIT
export SLURM_CONF=$work/slurm/slurm.conf

seconds_since() { echo "$1 $(date +%s.%N)" | awk '{ printf "%.1f s", $2 - $1 }'; }
film=("$scene" --quality draft --size 320x180 --frames "$frames")
pixels() { # a hash of what every frame shows, dates and names of programs left out
    for frame in "$1"/frames/turntable-*.png "$1"/frames/turntable-*.exr; do
        oiiotool --no-autopremult "$frame" --printstats | sed 1d
    done | md5sum
}

begin=$(date +%s.%N)
$cydonia turntable "${film[@]}" --quiet -o "$work/local"
echo "here, all cores                 $(seconds_since "$begin")"

tests/slurm/cluster.sh start "$work/slurm"
begin=$(date +%s.%N)
$cydonia farm "${film[@]}" --chunk 2 --quiet -o "$work/farm"
# Those that a task has recorded: POV-Ray may still be at work on a file that is there.
traced() {
    local frame
    for frame in $(grep -oh '"trace turntable-[0-9]*"' "$work"/farm/.cache/steps/*.jsonl 2> /dev/null | tr -dc 'a-z0-9\n-' | sed 's/^trace//' | sort -u); do
        stat --format='%n %y' "$work/farm/pov/$frame.exr"
    done
}
until (($(traced | wc -l) >= frames / 3)); do sleep 0.2; done
tests/slurm/cluster.sh kill "$work/slurm" n1
echo "n1 killed after                 $(seconds_since "$begin"), with $(traced | wc -l) of $frames frames traced"
traced > "$work/then"
logs() { tail -n +1 "$work"/farm/farm/*.log "$work/slurm/slurmctld.log" >&2; }
until [[ -z $(squeue --noheader) ]]; do
    sleep 1
    (($(date +%s) < ${begin%.*} + 1800)) || { logs; exit 1; }
done
echo "farm, 2 nodes of 1 core         $(seconds_since "$begin"), its nodes' death missed for 10 s and more included"
$cydonia farm status "$scene" -o "$work/farm"
stat --format='%n %y' "$work"/farm/pov/turntable-*.exr > "$work/last"
echo "frames                          $(find "$work/farm/frames" -name 'turntable-*.png' | wc -l) of $frames"
echo "traced before, and again        $(comm -23 <(sort "$work/then") <(sort "$work/last") | wc -l)"
if [[ $(pixels "$work/local") == $(pixels "$work/farm") ]]; then
    echo "pixels                          those of the run here"
else
    echo "pixels                          NOT those of the run here"
    logs
fi
ls "$work/farm/frames/turntable.mp4" "$work/farm/report.html" > /dev/null && echo "video and report                there"
