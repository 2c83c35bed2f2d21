#!/bin/bash
# Prints how well details by example restore real land that was coarsened four times, as a
# Markdown table: means over real models, each with details of its other half. Needs the
# bench build, or BENCH; PYTHON runs the judge (default python3); LAND names a folder that
# keeps the land.
#   bench/detail.sh FOLDER JUDGE [NAME...]
# FOLDER holds the models, <name>.tif; JUDGE is as for bench/realism.sh. Columns are those
# of bench/detail.cpp, decibels as mean and farthest from the truth, and the judge's
# geomorphon ratio (0: the landforms of the truth).
set -euo pipefail

program=${BENCH-$(dirname "$0")/../build/bench/bench/detail}
if [[ ! -x $program ]]; then
    echo "no $program: cmake --preset bench && cmake --build --preset bench" >&2
    exit 2
fi
if [[ $# -lt 2 ]]; then
    sed -n '2,9s/^# \{0,1\}//p' "$0"
    exit 2
fi
models=$1 judge=$2 python=${PYTHON:-python3}
shift 2
names=("$@")
[[ $# -gt 0 ]] || names=(pyrenees_andorra southern_uplands san_gabriel thuringian_slate
    catalan_ranges andes_aconcagua canberra_hills)

land=${LAND:-}
if [[ -z $land ]]; then
    land=$(mktemp -d)
    trap 'rm -rf "$land"' EXIT
fi
for name in "${names[@]}"; do
    "$program" "$models/$name.tif" "$land/$name" | grep '^| [^b]\|^| bicubic' |
        while IFS='|' read -r _ by rest; do
            by=${by# } by=${by% }
            forms=$("$python" "$judge" "$land/$name/$by.tif" "$land/$name/truth.tif" --json |
                "$python" -c 'import json, sys; print(json.load(sys.stdin)["geomorphon_chi2"]["ratio"])')
            echo "$name|$by|$rest$forms"
        done
done | "$python" -c '
import sys
from collections import OrderedDict
rows = OrderedDict()
for line in sys.stdin:
    model, by, rmse, four, two, level, seconds, forms = (part.strip() for part in line.split("|"))
    rows.setdefault(by, []).append([float(x) for x in (rmse, four, two, level, forms)])
base = [row[0] for row in rows["subdivision"]]
print("| by | RMSE, of subdivision | 4 to 8 cells, dB | 2 to 4, dB | level ground | landforms |")
print("|---|---|---|---|---|---|")
mean = lambda values: sum(values) / len(values)
for by, of in rows.items():
    if by == "truth":
        continue
    spread = lambda i: "%+.1f (%+.1f)" % (mean([r[i] for r in of]), max((r[i] for r in of), key=abs))
    print("| %s | %.2f | %s | %s | %.2f (%.2f) | %.3f |" % (
        by, mean([r[0] / b for r, b in zip(of, base)]), spread(1), spread(2),
        mean([r[3] for r in of]), max(r[3] for r in of), mean([r[4] for r in of])))
'
