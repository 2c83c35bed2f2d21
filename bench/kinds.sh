#!/bin/bash
# Prints what the "thirds" map of real kinds of land takes and how good it is, against
# Saunders 2006, table VI.1: at 30 m, and at 10 m with the models read as land three times
# as small, so that there are real samples of that level. Needs the bench build, or BENCH;
# PYTHON runs the judge (default python3).
#   bench/kinds.sh FOLDER JUDGE [LAND]
# FOLDER holds the models san_gabriel, olympic_coast and lapland_fell (.tif); JUDGE is that
# of bench/realism.sh. LAND keeps the lands.
#
# geomorphon, slope, height: how far the largest square within each type is from the type's
# largest sample, over how far squares as large out of its other samples are; 1 is as if
# it were one of them.
set -euo pipefail

root=$(dirname "$0")/..
program=${BENCH-$root/build/bench/bench/evolution}
if [[ ! -x $program ]]; then
    echo "no $program: cmake --preset bench && cmake --build --preset bench" >&2
    exit 2
fi
if [[ $# -lt 2 ]]; then
    sed -n '2,14s/^# \{0,1\}//p' "$0"
    exit 2
fi
models=$(realpath "$1") judge=$2 python=${PYTHON:-python3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
land=${3:-$scratch/land}

# library SCALE: three kinds of land by windows of models
library() {
    echo 'levels = [30.0]'
    while read -r type model window; do
        [[ $type == "${last-}" ]] || printf '[[type]]\nname = "%s"\n' "$type"
        last=$type
        printf '[[type.example]]\nsource = "%s/%s.tif"\nwindow = [%s]\nscale = %s\nvertical_scale = %s\n' \
            "$models" "$model" "$window" "$1" "$1"
    done <<'WINDOWS'
mountains san_gabriel 0.05, 0.0, 0.37, 0.6
mountains san_gabriel 0.37, 0.0, 0.69, 0.6
mountains san_gabriel 0.68, 0.3, 1.0, 1.0
mountains san_gabriel 0.3, 0.4, 0.68, 1.0
hills olympic_coast 0.3, 0.0, 0.65, 0.4
hills olympic_coast 0.65, 0.0, 1.0, 0.4
hills olympic_coast 0.5, 0.3, 0.8, 0.65
hills olympic_coast 0.0, 0.6, 0.25, 0.9
plain lapland_fell 0.0, 0.0, 1.0, 0.3
plain lapland_fell 0.6, 0.0, 1.0, 1.0
plain lapland_fell 0.0, 0.2, 0.5, 0.5
plain olympic_coast 0.0, 0.0, 0.3, 0.2
WINDOWS
}

for level in "30 326 1.0" "10 978 0.3333333"; do
    read -r spacing samples scale <<<"$level"
    echo "== $samples x $samples at $spacing m"
    mkdir -p "$land/$spacing"
    library "$scale" >"$scratch/kinds.toml"
    "$program" "$scratch/kinds.toml" "$root/scenes/thirds/thirds.map" "$samples" "$spacing" \
        "$land/$spacing"
    "$python" - "$judge" "$land/$spacing" <<'PYTHON'
import glob, json, os, subprocess, sys
judge, folder = sys.argv[1:]
keys = ("geomorphon_chi2", "slope_emd_deg", "height_emd_m")
def far(a, b):
    said = subprocess.run([sys.executable, judge, a, b, "--json"], capture_output=True, text=True)
    found = json.loads(said.stdout)
    return [found[key]["distance"] for key in keys]
for kind in ("mountains", "hills", "plain"):
    model = os.path.join(folder, kind + ".tif")
    parts = [far(part, model) for part in glob.glob(os.path.join(folder, kind + "-part-*.tif"))]
    if not parts:
        print(f"{kind}: no sample is as large as its square")
        continue
    usual = [sum(p[i] for p in parts) / len(parts) for i in range(3)]
    for optimiser in ("texture", "evolution"):
        for seed in (1, 2, 3):
            own = far(os.path.join(folder, f"{optimiser}-{seed}-{kind}.tif"), model)
            ratios = "  ".join(f"{key.split('_')[0]} {o / u:.2f}" for key, o, u in zip(keys, own, usual))
            print(f"  {kind:10} {optimiser:10} seed {seed}  {ratios}")
PYTHON
done
