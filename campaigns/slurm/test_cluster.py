#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A cluster of two nodes on this machine, for real: slurmctld, two slurmd, array.sbatch. test_cluster.py BIN

A normal array; a shard that crashes; a node that is killed while it works; everything again (nothing is run); the result against a run
without Slurm. Needs Debian's slurm-wlm and root; ends with 77 where these are not there. Everything lives in a temporary folder and is ended by
process id."""
import filecmp
import glob
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(HERE, "array.sbatch")
SHARDS = 4
CONFIGURATION = """
ClusterName=confidel
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SelectType=select/linear
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdTimeout=10
SlurmctldTimeout=10
MinJobAge=300
ReturnToService=2
KillWait=5
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=60 State=UP
"""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


class Cluster:
    def __init__(self, folder):
        self.folder, self.daemons = folder, {}
        for name in ("state", "spool-n1", "spool-n2"):
            os.makedirs(os.path.join(folder, name))
        configuration = os.path.join(folder, "slurm.conf")
        with open(configuration, "w") as out:
            out.write(CONFIGURATION.format(host=socket.gethostname().split(".")[0], ports=free_ports(3), folder=folder))
        self.environment = dict(os.environ, SLURM_CONF=configuration)
        self.start("slurmctld", "-D")
        for node in ("n1", "n2"):
            self.start("slurmd", "-D", "-N", node, name=node)
        self.wait(lambda: self.nodes() == {"n1": "idle", "n2": "idle"}, 60, lambda: "the nodes are %s\n%s" % (self.nodes(), self.logs()))

    def start(self, program, *arguments, name=None):
        path = shutil.which(program, path=os.environ["PATH"] + ":/usr/sbin:/sbin")
        self.daemons[name or program] = subprocess.Popen([path, *arguments], env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def run(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True)

    def nodes(self):
        out = self.run("sinfo", "-h", "-N", "-o", "%N %t").stdout
        return {line.split()[0]: line.split()[1].rstrip("*$#~") for line in out.splitlines() if len(line.split()) == 2}

    def logs(self):
        return "\n".join("%s:\n%s" % (path, open(path, errors="replace").read()[-1500:]) for path in glob.glob(os.path.join(self.folder, "*.log")))

    @staticmethod
    def wait(condition, seconds, otherwise):
        end = time.time() + seconds
        while not condition():
            if time.time() > end:
                raise SystemExit("FAILED after %d s: %s" % (seconds, otherwise() if callable(otherwise) else otherwise))
            time.sleep(0.2)

    def submit(self, confidel, *arguments):
        done = subprocess.run(["sbatch", "--parsable", "--array=0-%d" % (SHARDS - 1), "--output=" + os.path.join(self.folder, "task-%A-%a.txt"), SCRIPT, *arguments],
                              env=dict(self.environment, CONFIDEL=confidel), capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit("sbatch: " + done.stderr)
        return done.stdout.strip()

    def states(self, job):
        """Of the tasks that are not forgotten: {task: (state, exit code)}"""
        out = self.run("scontrol", "show", "job", "-o", job).stdout
        result = {}
        for line in out.splitlines():
            fields = dict(field.split("=", 1) for field in line.split() if "=" in field)
            result[fields.get("ArrayTaskId", "?")] = (fields["JobState"], fields.get("ExitCode"))
        return result

    def finish(self, job, seconds=180):
        self.wait(lambda: not self.run("squeue", "-h", "-j", job).stdout.strip(), seconds, lambda: "job %s: %s\n%s" % (job, self.states(job), self.logs()))
        return self.states(job)

    def end(self):
        for daemon in reversed(list(self.daemons.values())):
            if daemon.poll() is None:
                daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()


def records(folder):
    result = []
    for path in sorted(glob.glob(os.path.join(folder, "block-*.jsonl"))):
        for line in open(path):
            record = json.loads(line)
            record.pop("seconds", None)
            result.append(record)
    return result


def children_of(process):
    """Process ids of all descendants."""
    found, waiting = [], [process]
    while waiting:
        parent = waiting.pop()
        done = subprocess.run(["ps", "-o", "pid=", "--ppid", str(parent)], capture_output=True, text=True)
        children = [int(word) for word in done.stdout.split()]
        found += children
        waiting += children
    return found


def expect(good, message):
    if not good:
        raise SystemExit("FAILED " + message)
    print("good: " + message.split(":")[0], flush=True)


def main():
    binaries = os.path.abspath(sys.argv[1])
    confidel = os.path.join(binaries, "confidel")
    missing = [name for name in ("slurmctld", "slurmd", "sbatch") if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin:/sbin")]
    if missing or os.geteuid() != 0:
        print("SKIPPED: %s" % ("not root" if not missing else "there is no " + ", ".join(missing) + " (apt-get install slurm-wlm)"))
        return 77
    folder = tempfile.mkdtemp(prefix="confidel-slurm-")
    cluster, good = None, False
    try:
        cluster = Cluster(folder)
        options = ["--seeds", "0..79", "--block", "5", "--max-points", "500"]
        serial, normal, broken, killed = (os.path.join(folder, name) for name in ("serial", "normal", "broken", "killed"))
        subprocess.run([confidel, "campaign", "run", "--out", serial, *options], check=True, stdout=subprocess.DEVNULL)

        start = time.time()
        states = cluster.finish(cluster.submit(confidel, normal, *options))
        expect(all(state[0] == "COMPLETED" for state in states.values()), "a normal array completes: %s" % states)
        expect(records(normal) == records(serial), "the cluster's result is the serial run's")
        expect(subprocess.run([confidel, "campaign", "cover", normal], stdout=subprocess.DEVNULL).returncode == 0, "cover accepts it")
        print("%d tasks in %.1f s" % (SHARDS, time.time() - start), flush=True)

        before = {path: (open(path).read(), os.stat(path).st_mtime_ns) for path in glob.glob(os.path.join(normal, "*"))}
        cluster.finish(cluster.submit(confidel, normal, *options))
        expect(before == {path: (open(path).read(), os.stat(path).st_mtime_ns) for path in glob.glob(os.path.join(normal, "*"))}, "a rerun is a no-op")

        crashing = os.path.join(folder, "crashing")
        with open(crashing, "w") as out:
            out.write('#!/bin/bash\ncase "$*" in *"--shard 2/"*) kill -SEGV $$ ;; esac\nexec %s "$@"\n' % confidel)
        os.chmod(crashing, 0o755)
        states = cluster.finish(cluster.submit(crashing, broken, *options))
        expect(sorted(state[0] for state in states.values()) == ["COMPLETED"] * (SHARDS - 1) + ["FAILED"], "a crashing shard fails alone: %s" % states)
        done = subprocess.run([confidel, "campaign", "cover", broken], capture_output=True, text=True)
        expect(done.returncode == 5 and "missing" in done.stderr, "cover refuses what is incomplete: %d %s" % (done.returncode, done.stderr))
        cluster.finish(cluster.submit(confidel, broken, *options))
        expect(records(broken) == records(serial), "the rerun completes it")

        # Slow enough to be caught at work: every run waits a little.
        slow = os.path.join(folder, "slow")
        with open(slow, "w") as out:
            out.write('#!/bin/bash\nsleep 3\nexec %s "$@"\n' % confidel)
        os.chmod(slow, 0o755)
        job = cluster.submit(slow, killed, *options)
        daemon = cluster.daemons["n2"]
        cluster.wait(lambda: cluster.nodes().get("n2") in ("alloc", "mix"), 60, lambda: "n2 never works: %s" % cluster.nodes())
        time.sleep(0.5)
        # What runs for n2 knows it by its environment; slurmstepd, which does not, is its parent, and has to go first: it must not report.
        victims = [daemon.pid, *children_of(daemon.pid)]
        for number in filter(str.isdigit, os.listdir("/proc")):
            try:
                words = open("/proc/%s/environ" % number, "rb").read().split(b"\0")
            except OSError:
                continue
            if b"SLURMD_NODENAME=n2" in words and ("SLURM_CONF=" + cluster.environment["SLURM_CONF"]).encode() in words:
                parent = int(open("/proc/%s/stat" % number).read().rsplit(")", 1)[1].split()[1])
                if open("/proc/%d/comm" % parent).read().startswith("slurmstepd"):
                    victims.insert(0, parent)
                victims.append(int(number))
        for victim in victims:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass
        states = cluster.finish(job, 300)
        expect(records(killed) == records(serial), "a killed node's work is done by the other: %s" % states)
        good = True
        print("a cluster of two nodes does what one machine does")
        return 0
    finally:
        if cluster:
            cluster.end()
        if good:
            shutil.rmtree(folder, ignore_errors=True)
        else:
            print("logs are in " + folder)


if __name__ == "__main__":
    sys.exit(main())
