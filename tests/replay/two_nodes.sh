# A Slurm cluster of two nodes on this machine, for any user, without systemd and cgroups: to be sourced.
#   start_cluster FOLDER    begins munged, slurmctld and slurmd of n1 and n2, and waits until both nodes are idle
#   start_node n2, start_controller    begin one again; stop_cluster ends all
# FOLDER must be new and not writable by others. Sets SLURM_CONF; process ids are in `munged`, `controller`, `node[n1]`, `node[n2]`.

declare -A node
controller=
munged=

cluster_programs() {
    local name
    for name in munged slurmctld slurmd sbatch squeue sinfo scontrol; do
        PATH=$PATH:/usr/sbin type -P "$name" > /dev/null || { echo "found no $name, expected Debian's slurm-wlm and munge"; return 1; }
    done
}

# A port that nothing listens on.
free_port() {
    local port
    for port in $(seq "$1" 7 "$(($1 + 7000))"); do
        if ! (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null; then
            echo "$port"
            return
        fi
    done
    return 1
}

start_controller() {
    slurmctld -D -f "$cluster/slurm.conf" >> "$cluster/ctld.out" 2>&1 &
    controller=$!
}

start_node() {
    slurmd -D -f "$cluster/slurm.conf" -N "$1" >> "$cluster/$1.out" 2>&1 &
    node[$1]=$!
}

# Waits, at most a minute, until a command succeeds.
until_true() {
    local turn
    for turn in $(seq 300); do
        if "$@" > /dev/null 2>&1; then
            return
        fi
        sleep 0.2
    done
    echo "waited a minute for: $*" >&2
    return 1
}

both_idle() {
    [ "$(sinfo -h -N -o '%T' | sort -u)" = idle ]
}

start_cluster() {
    cluster=$1
    PATH=$PATH:/usr/sbin
    mkdir -p "$cluster"/{state,spool.n1,spool.n2}
    chmod 700 "$cluster"
    (umask 077; head -c 1024 /dev/urandom > "$cluster/munge.key")
    chmod 400 "$cluster/munge.key"
    local me control first second
    me=$(id -un)
    control=$(free_port 16817)
    first=$(free_port "$((control + 1))")
    second=$(free_port "$((first + 1))")
    cat > "$cluster/slurm.conf" << EOF
ClusterName=lanthorn
SlurmUser=$me
SlurmdUser=$me
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$control
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.sock
CredType=cred/munge
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool.%n
SlurmctldPidFile=$cluster/ctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/ctld.log
SlurmdLogFile=$cluster/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$cluster/jobcomp.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1
ReturnToService=2
SlurmdTimeout=10
KillWait=5
MinJobAge=3600
MaxArraySize=10001
JobRequeue=1
NodeName=n1 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$first CPUs=1 RealMemory=500
NodeName=n2 NodeHostname=localhost NodeAddr=127.0.0.1 Port=$second CPUs=1 RealMemory=500
PartitionName=replay Nodes=n1,n2 Default=YES MaxTime=60 State=UP
EOF
    export SLURM_CONF=$cluster/slurm.conf
    munged --foreground $([ "$(id -u)" -ne 0 ] || echo --force) --key-file="$cluster/munge.key" --socket="$cluster/munge.sock" \
        --pid-file="$cluster/munged.pid" --log-file="$cluster/munged.log" --seed-file="$cluster/munged.seed" > "$cluster/munged.out" 2>&1 &
    munged=$!
    until_true test -S "$cluster/munge.sock"
    start_controller
    start_node n1
    start_node n2
    until_true both_idle
}

stop_cluster() {
    local id
    scancel --user="$(id -un)" 2> /dev/null || true
    for id in "${node[@]}" "$controller" "$munged"; do
        [ -z "$id" ] || kill -9 "$id" 2> /dev/null || true
    done
    wait 2> /dev/null || true
}
