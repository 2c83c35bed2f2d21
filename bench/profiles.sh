#!/bin/bash
# Draws the pictures of docs/profiles.md from config/profiles. Needs rsvg-convert
# (librsvg2-bin) and the bench build: cmake --preset bench && cmake --build --preset bench
set -euo pipefail
cd "$(dirname "$0")/.."

sheet=${1:-build/bench/bench/profile_sheet}
pictures=docs/pictures
"$sheet" config/profiles/*.csv | rsvg-convert -o $pictures/profiles.png
"$sheet" --cut config/profiles/alpine.csv | rsvg-convert -o $pictures/profiles-cut.png
