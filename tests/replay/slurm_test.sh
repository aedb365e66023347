#!/usr/bin/env bash
# 200 replays on a Slurm cluster of two nodes, which loses a task, a node, its controller and the driver on the way: nothing is lost, and the
# results are those of a run without it, byte for byte but for times.
#   slurm_test.sh LANTHORN REPOSITORY      77: skipped, Slurm is not installed
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

# The beginnings of one recording: no two are alike.
mkdir "$work/recordings"
for i in $(seq 200); do
    "$lanthorn" replay trim "$repository/tests/replay/two-glasses.rec" --to $((100 + 4 * i)) -o "$work/recordings/r$i.rec" > /dev/null
done

echo "on this machine"
"$lanthorn" replay suite "$work/recordings" -o "$work/local" --update-ratchet | tail -4

start_cluster "$work/cluster"
results() { find "$work/farm/results" -name '*.json' 2> /dev/null | wc -l; }
more_than() { [ "$(results)" -gt "$1" ]; }
begin() {
    "$lanthorn" replay suite "$work/recordings" -o "$work/farm" --executor slurm --slice-seconds 3 "$@" > "$work/farm.out" 2>&1 &
    driver=$!
}
begin
until_true more_than 5
echo "a task is killed, with $(results) results there"
task=$(pgrep -o -f "suite-slice $work/farm")
kill -9 "$task"
until_true more_than 30
echo "node n2 is killed, with $(results) results there"
kill -9 "${node[n2]}"
until_true more_than 60
echo "the controller is killed, with $(results) results there"
kill -9 "$controller"
sleep 2
start_controller
start_node n2
until_true more_than 80
echo "the driver is killed, with $(results) results there"
kill -9 "$driver"
begin --resume
code=0
wait "$driver" || code=$?
driver=
cat "$work/farm.out"
[ "$code" -eq 0 ] || { echo "found exit code $code, expected 0"; exit 1; }

python3 - "$work" << 'EOF'
import json, os, sys
def results(folder):
    all = {}
    for name in os.listdir(folder):
        if name.endswith(".json"):
            with open(os.path.join(folder, name)) as file:
                result = json.load(file)
            del result["times"]
            all[name] = json.dumps(result, sort_keys=True)
        elif name.endswith(".other"):
            sys.exit(f"{name}: two runs of the same differ")
    return all
local, farm = (results(os.path.join(sys.argv[1], which, "results")) for which in ("local", "farm"))
assert len(local) == 200, len(local)
if local != farm:
    sys.exit(f"{len(farm)} results of the cluster are not the {len(local)} of this machine")
print("200 results, equal to those of this machine")
EOF
