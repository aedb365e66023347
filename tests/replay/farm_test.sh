#!/usr/bin/env bash
# A reference and a chart on a Slurm cluster of two nodes, of which one is lost on the way: the reference is that of this machine to the bit,
# and the chart has its errors.
#   farm_test.sh LANTHORN REPOSITORY      77: skipped, Slurm is not installed
set -euo pipefail
lanthorn=$1
repository=$2
source "$repository/tests/replay/two_nodes.sh"
if ! why=$(cluster_programs); then
    echo "skipped: $why"
    exit 77
fi
work=$(mktemp -d)
driver=
cleanup() {
    [ -z "$driver" ] || kill -9 "$driver" 2> /dev/null || true
    stop_cluster
    rm -rf "$work"
}
trap cleanup EXIT
cd "$work"
reference=(render "$repository/assets/cornell.glb" --technique path --aov indirect --size 160x120 --spp 512 --seed 5)
chart=(trade "$repository/assets/cornell.glb" --technique none,drm --preset low --presets-only --size 96x64 --frames 2 --warmup 1 --reference-spp 70)
farm=(--executor slurm --slice-seconds 5)

"$lanthorn" "${reference[@]}" -o here.exr
"$lanthorn" "${chart[@]}" -o here > /dev/null

start_cluster "$work/cluster"
pieces() { find "$work/there.exr.pieces" -name '*.sums' 2> /dev/null | wc -l; }
more_than() { [ "$(pieces)" -gt "$1" ]; }
"$lanthorn" "${reference[@]}" -o there.exr "${farm[@]}" --pieces 64 &
driver=$!
until_true more_than 2
echo "node n2 is killed, with $(pieces) pieces there"
kill -9 "${node[n2]}"
until_true more_than 8
echo "the driver is killed, with $(pieces) pieces there"
kill -9 "$driver"
wait "$driver" 2> /dev/null || true
start_node n2
"$lanthorn" "${reference[@]}" -o there.exr "${farm[@]}" --pieces 64
driver=
[ ! -e there.exr.pieces ] || { echo "found there.exr.pieces, expected it to be gone"; exit 1; }
"$lanthorn" compare there.exr here.exr --metric relrmse --max 0

"$lanthorn" "${chart[@]}" -o there "${farm[@]}" > /dev/null
python3 - << 'EOF'
import csv
def errors(folder):
    with open(folder + "/trade.csv") as file:
        return [{key: row[key] for key in row if "relrmse" in key or "flux" in key or key in ("scene", "technique", "preset")}
                for row in csv.DictReader(file)]
here, there = errors("here"), errors("there")
assert len(here) >= 2, here
if here != there:
    raise SystemExit(f"the cluster's errors are {there}, expected {here}")
print(f"{len(here)} points with the errors of this machine")
EOF
