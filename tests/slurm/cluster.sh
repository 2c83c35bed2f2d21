#!/bin/bash
# A Slurm of two nodes of one core each on this machine alone, for tests and measurements:
#   tests/slurm/cluster.sh start FOLDER   then SLURM_CONF=FOLDER/slurm.conf sbatch ...
#   tests/slurm/cluster.sh kill FOLDER n1   a node dies, with all that runs on it
#   tests/slurm/cluster.sh stop FOLDER
# As root, with the packages slurm-wlm and munge. Everything it writes is in FOLDER.
set -euo pipefail
folder=$(mkdir -p "$2" && cd "$2" && pwd)
export SLURM_CONF=$folder/slurm.conf

# Below the ports that the system gives away by itself.
port() { echo $((20000 + $(id -u) % 10 + ($$ * 7) % 9000)); }

configure() {
    local base
    base=$(port)
    cat >"$SLURM_CONF" <<END
ClusterName=cydonia
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$base
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
# A node that is gone is missed soon, and its jobs begin elsewhere.
SlurmdTimeout=10
ReturnToService=2
NodeName=n[1-2] NodeHostname=localhost NodeAddr=127.0.0.1 Port=[$((base + 1))-$((base + 2))] CPUs=1 RealMemory=8000
PartitionName=all Nodes=ALL Default=YES State=UP
END
}

start() {
    mkdir -p "$folder/state" "$folder/n1" "$folder/n2"
    configure
    head -c 1024 /dev/urandom >"$folder/munge.key"
    chmod 600 "$folder/munge.key"
    munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
        --pid-file="$folder/munge.pid" --log-file="$folder/munge.log" \
        --seed-file="$folder/munge.seed"
    slurmctld -f "$SLURM_CONF"
    slurmd -f "$SLURM_CONF" -N n1
    slurmd -f "$SLURM_CONF" -N n2
    for _ in $(seq 60); do
        [[ $(sinfo --noheader --states=idle --format=%D 2>/dev/null) == 2 ]] && return
        sleep 0.5
    done
    echo "the cluster does not come up; see the logs in $folder" >&2
    exit 1
}

# A process, then all that it started: none lives to tell of another's end.
kill_tree() {
    local children
    children=$(pgrep -P "$1" || true)
    kill -9 "$1" 2>/dev/null || true
    for child in $children; do kill_tree "$child"; done
}

# The daemon, and its jobs' step daemons: the parents of what runs with this cluster's
# configuration on that node.
kill_node() {
    local pid
    kill -9 "$(cat "$folder/$1.pid")"
    for pid in $(pgrep -f 'slurm_script|slurmd.*job'); do
        if has "$pid" "SLURM_CONF=$SLURM_CONF" && has "$pid" "SLURMD_NODENAME=$1"; then
            kill_tree "$(ps -o ppid= -p "$pid" | tr -d ' ')"
        fi
    done
}

# A process, a line of its environment.
has() { tr '\0' '\n' <"/proc/$1/environ" 2>/dev/null | grep -qxF "$2"; }

stop() {
    scontrol shutdown 2>/dev/null || true
    for _ in $(seq 40); do
        pgrep -f "slurm(ctld|d) -f $SLURM_CONF" >/dev/null || break
        sleep 0.25
    done
    pkill -9 -f "slurm(ctld|d) -f $SLURM_CONF" || true
    [[ ! -e $folder/munge.pid ]] || kill "$(cat "$folder/munge.pid")" || true
}

case $1 in
start) start ;;
kill) kill_node "$3" ;;
stop) stop ;;
*) echo "start, kill or stop" >&2 && exit 2 ;;
esac
