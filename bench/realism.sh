#!/bin/bash
# Prints how real land made of real land is, as a Markdown table: six exemplars, three
# seeds each, 512 x 512 cells, no constraints, against a judge that knows nothing of us.
# Needs the bench build, or BENCH; PYTHON runs the judge (default python3); LAND names a
# folder that keeps the land and the databases; SEEDS (default 3) how many of each.
#   bench/realism.sh FOLDER JUDGE [NAME...]
# FOLDER holds the exemplars, <name>.tif; JUDGE is a program with the arguments `A.tif
# B.tif --json` that prints, as JSON, how far A is from B beside how far parts of B are
# from each other ("geomorphon_chi2", "slope_emd_deg", "height_emd_m", each with a
# "ratio") and facts of both ("a", "b": "beta_low", "beta_high", "pits_per_1000").
#
# Columns: geomorphon, slope, height: the judge's ratios, 1 where A is as far from B as
# quarters of B are from each other. Slope and height, parts: the same against parts of the
# exemplar of the land's size (bench/land_figures.h). Spectrum: slope of the land's less
# the exemplar's, low and high band. Pits: the land's over the exemplar's. Used, repeated:
# bench/texture.cpp.
set -euo pipefail

program=${BENCH-$(dirname "$0")/../build/bench/bench/texture}
if [[ ! -x $program ]]; then
    echo "no $program: cmake --preset bench && cmake --build --preset bench" >&2
    exit 2
fi
if [[ $# -lt 2 ]]; then
    sed -n '2,18s/^# \{0,1\}//p' "$0"
    exit 2
fi
exemplars=$1 judge=$2 python=${PYTHON:-python3} seeds=${SEEDS:-3}
shift 2
names=("$@")
[[ $# -gt 0 ]] || names=(pyrenees_andorra southern_uplands san_gabriel moon_farside
    thuringian_slate catalan_ranges)

land=${LAND:-}
if [[ -z $land ]]; then
    land=$(mktemp -d)
    trap 'rm -rf "$land"' EXIT
fi
mkdir -p "$land"
files=()
for name in "${names[@]}"; do files+=("$exemplars/$name.tif"); done
"$program" --seeds "$seeds" -o "$land" "${files[@]}" >&2

# Two judges at a time.
for name in "${names[@]}"; do
    for ((seed = 1; seed <= seeds; ++seed)); do
        printf '%s\0' "$land/$name-$seed.tif" "$exemplars/$name.tif" "$land/$name-$seed.json"
    done
done | xargs -0 -n 3 -P 2 sh -c '"$0" "$1" "$2" "$3" --json > "$4"' "$python" "$judge"

"$python" - "$land" <<'PYTHON'
import csv, json, sys
land = sys.argv[1]
columns = ["geomorphon", "slope", "slope, parts", "height", "height, parts",
           "spectrum low", "spectrum high", "pits", "used", "coherent", "repeated 32",
           "repeated 64"]

def figures(row):
    with open(f"{land}/{row['exemplar']}-{row['seed']}.json") as file:
        judged = json.load(file)
    a, b = judged["a"], judged["b"]
    return [judged["geomorphon_chi2"]["ratio"], judged["slope_emd_deg"]["ratio"],
            float(row["slopes"]), judged["height_emd_m"]["ratio"], float(row["heights"]),
            a["beta_low"] - b["beta_low"], a["beta_high"] - b["beta_high"],
            a["pits_per_1000"] / max(b["pits_per_1000"], 1e-3), float(row["used"]),
            float(row["coherent"]), float(row["repeated_32"]), float(row["repeated_64"])]

def line(name, values):
    print("| " + " | ".join([name] + [f"{value:.2f}" for value in values]) + " |")

with open(f"{land}/figures.csv") as file:
    rows = list(csv.DictReader(file))
table = [figures(row) for row in rows]
print("| land | " + " | ".join(columns) + " |")
print("|---|" + "---:|" * len(columns))
for row, values in zip(rows, table):
    line(f"{row['exemplar']} {row['seed']}", values)
line("mean", [sum(column) / len(table) for column in zip(*table)])
# The least for shares used and coherent, else the furthest from 0.
line("worst", [min(column) if name in ("used", "coherent") else max(column, key=abs)
               for name, column in zip(columns, zip(*table))])
print()
print("asked: geomorphon mean 0.5, worst 1.2; slope, parts 1.2; height, parts 1.5; "
      "spectrum within 0.3; pits 1.5; used 0.6 or more")
PYTHON
