#!/bin/bash
# Prints what issue-sized sequences take on this machine: a turntable of a 512x512 scene by
# POV-Ray at draft quality and by Embree at 480x270, the share of the first that is not
# drawing, how right its time left is from the fifth frame on, how much faster frames side
# by side are than one frame on all cores, and what is left to do after kill -9 at random
# moments. bench/sequences.sh [SCENE [FRAMES]]
set -euo pipefail
cd "$(dirname "$0")/.."

scene=${1:-scenes/text/scene.toml}
frames=${2:-48}
cydonia=${CYDONIA:-./cydonia}
$cydonia --version
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

now() { date +%s.%N; }
# Seconds that a command takes.
seconds() {
    local begin end
    begin=$(now)
    "$@" > "$work/log" 2>&1 || { cat "$work/log" >&2; return 1; }
    end=$(now)
    echo "$begin $end" | awk '{ printf "%.2f", $2 - $1 }'
}
pixels() { # a hash of what every frame shows, dates and names of programs left out
    for frame in "$1"/frames/turntable-*.png; do
        oiiotool --no-autopremult "$frame" --printstats
    done | md5sum
}

echo "== $scene, $frames frames"
$cydonia synth "$scene" --quiet -o "$work/a" > /dev/null
look=$(seconds $cydonia turntable "$scene" --engine embree --size 480x270 \
    --frames "$frames" -o "$work/a")
echo "embree 480x270, from the finished land      $look s"

begin=$(now)
$cydonia turntable "$scene" --quality draft --size 640x360 --frames "$frames" \
    -o "$work/a" 2> >(while IFS= read -r line; do echo "$(now) $line"; done > "$work/lines")
end=$(now)
echo "$begin $end" | awk '{ printf "draft 640x360, whole command                %.2f s\n", $2 - $1 }'
sleep 1
# "film turntable: 40%, 31 s left": against the moment at which the step was done.
awk -v frames="$frames" '
    function left(text,   n, p) {
        n = split(text, p, " "); s = 0
        for (i = 1; i < n; ++i) {
            if (p[i + 1] ~ /^min/) s += 60 * p[i]
            if (p[i + 1] ~ /^s/) s += p[i]
        }
        return s
    }
    /film turntable: / {
        match($0, /[0-9]+%/); done = substr($0, RSTART, RLENGTH - 1)
        if (done * frames < 500 || done > 90) next
        at[++n] = $1; said[n] = left(substr($0, index($0, ",") + 2))
    }
    /film turntable  / { end = $1 }
    END {
        for (i = 1; i <= n; ++i)
            printf "time left, said and true                    %d s, %.0f s (%+.0f %%)\n",
                said[i], end - at[i], 100 * (said[i] / (end - at[i]) - 1)
    }' "$work/lines"

# What POV-Ray spends on a frame of one pixel is not drawing.
cd "$work/a/pov"
one() { povray "$1.ini" +W"$2" +H"$3" +WT"$4" +FE +O"$work/x.exr" -D -P; }
start=$(seconds one turntable-0001 1 1 1)
cd - > /dev/null
preview=$work/p
$cydonia emit "$scene" --quality preview --quiet -o "$preview" > /dev/null
$cydonia turntable "$scene" --quality preview --frames 2 --quiet -o "$preview" > /dev/null
cd "$preview/pov"
whole=$(seconds one turntable-0001 1280 720 1)
idle=$(seconds one turntable-0001 1 1 1)
both=$(seconds one turntable-0001 1280 720 "$(nproc)")
side=$(seconds bash -c '
    for i in $(seq '"$(nproc)"'); do
        povray turntable-0001.ini +W1280 +H720 +WT1 +FE +O'"$work"'/y$i.exr -D -P & done; wait')
cd - > /dev/null
echo "$start $whole $idle $both $side $(nproc)" | awk '{
    printf "draft: POV-Ray before it draws              %.2f s\n", $1
    printf "preview: POV-Ray before it draws            %.2f of %.2f s (%.0f %%)\n", $3, $2, 100 * $3 / $2
    printf "preview: a frame on all cores, its own threads  %.2f s; side by side  %.2f s each\n", $4, $5 / $6 }'

echo "== kill -9 at 10 random moments"
short=$((frames < 12 ? frames : 12))
film() { $cydonia turntable "$scene" --quality draft --size 320x180 --frames "$short" --quiet -o "$1"; }
film "$work/whole" > /dev/null
full=$(seconds film "$work/timed")
for i in $(seq 10); do
    film "$work/killed" > /dev/null 2>&1 &
    pid=$!
    sleep "$(awk -v full="$full" -v seed="$i" 'BEGIN { srand(seed); print (0.05 + 0.5 * rand()) * full }')"
    pkill -9 -P $pid 2> /dev/null || true
    kill -9 $pid 2> /dev/null || true
    wait $pid 2> /dev/null || true
    ls --full-time "$work/killed/frames" 2> /dev/null | awk '/turntable-[0-9]*.png/ { print $9, $7 }' > "$work/seen.$i" || true
done
film "$work/killed" > /dev/null
ls --full-time "$work/killed/frames" | awk '/turntable-[0-9]*.png/ { print $9, $7 }' > "$work/last"
echo "frames: $(wc -l < "$work/last") of $short; finished before the last run and written again: $(comm -23 <(sort "$work/seen.10") <(sort "$work/last") | wc -l)"
[ "$(pixels "$work/whole")" = "$(pixels "$work/killed")" ] && echo "pixels: those of the undisturbed run" || echo "pixels: NOT those of the undisturbed run"
cmp -s "$work/whole/terrain.exr" "$work/killed/terrain.exr" && echo "heights: those of the undisturbed run, byte by byte" || echo "heights: differ in bytes (the file's date, else a fault)"

# As much space as all but half of the frames take.
if [ "$(id -u)" = 0 ]; then
    echo "== a full disk"
    kilobytes() { cat "$@" | wc -c | awk '{ print int($1 / 1024) }'; }
    space=$(($(du -sk "$work/whole" | cut -f1) - $(du -sk "$work/whole/frames" | cut -f1) \
        - $(kilobytes "$work/whole/report.html") - $(kilobytes "$work"/whole/pov/turntable-*.exr) / 2))
    mkdir "$work/small"
    mount -t tmpfs -o size=${space}k tmpfs "$work/small"
    trap 'umount "$work/small"; rm -rf "$work"' EXIT
    film "$work/small/out" > "$work/log" 2>&1 && code=0 || code=$?
    echo "exit $code: $(tail -1 "$work/log")"
    echo "whole frames then: $(ls "$work/small/out/frames" 2> /dev/null | grep -c 'turntable-[0-9]*.png' || true)"
    mount -o remount,size=400m "$work/small"
    film "$work/small/out" > /dev/null && echo "after space was made: $(ls "$work/small/out/frames/" | grep -c 'turntable-[0-9]*.png') frames"
fi
