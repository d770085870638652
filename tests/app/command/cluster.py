#!/usr/bin/env python3
"""Tests studies over many machines with the programs that run them: a job array of Slurm and GNU parallel, with tasks that
are killed, requeued and tried again. Skipped, which it says, where the program is not installed.

cluster.py CLEARANCE slurm|parallel
"""

import getpass
import os
import pathlib
import shutil
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time

from program import check, end, expect, house, program, run

SHARDS = 8
RUNS = 24
# small steps, so that a shard takes longer than the second between two commits
STUDY = (house("bedroom-after-earthquake"), "--set", "run.dt=1e-5", "--runs", str(RUNS))
NEEDED = {"slurm": ("slurm-wlm", ("slurmctld", "slurmd", "sbatch", "scontrol", "squeue")),
          "parallel": ("parallel", ("parallel",))}
SLURM = """ClusterName=clearance
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SlurmdParameters=config_overrides
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
MpiDefault=none
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def wait_for(what, reached, seconds=120):
    limit = time.monotonic() + seconds
    while time.monotonic() < limit:
        found = reached()
        if found:
            return found
        time.sleep(0.05)
    check(False, f"{what} within {seconds} s")
    return None


def answers(folder):
    return {name: pathlib.Path(folder, name).read_bytes() for name in ("summary.json", "study.csv", "study-points.csv")}


def undivided(folder):
    run("study", *STUDY, "--out", str(folder), "--quiet")
    return answers(folder)


def process_of(out, shard):
    """Returns the process that runs this shard, if it does."""
    words = [str(out).encode(), f"{shard}/{SHARDS}".encode()]
    for place in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            line = (place / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if line[0] == os.fsencode(program) and all(word in line for word in words):
            return int(place.name)
    return None


def rows(out, shard):
    store = pathlib.Path(out, f"study-{shard}-of-{SHARDS}.sqlite")
    if not store.exists():
        return 0
    database = sqlite3.connect(f"file:{store}?mode=ro", uri=True, timeout=10)
    try:
        return database.execute("SELECT count(*) FROM trial").fetchone()[0]
    except sqlite3.OperationalError:  # its tables are not there yet
        return 0
    finally:
        database.close()


def kill(out, shard):
    """Kills the process of a shard as soon as it has kept a run."""
    process = wait_for(f"shard {shard} runs and keeps a run", lambda: rows(out, shard) and process_of(out, shard))
    if process:
        os.kill(process, signal.SIGKILL)


def check_merged(out, whole):
    run("study", *STUDY, "--out", str(out), "--merge", "--no-run", "--quiet")
    check(answers(out) == whole, "the merged answer is that of the undivided run, byte for byte")


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


class Slurm:
    """A cluster of this machine alone, for as long as the block."""

    def __init__(self, folder):
        self.folder = folder
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "slurm.conf").write_text(SLURM.format(host=socket.gethostname().partition(".")[0], folder=folder,
                                                        ports=free_ports(2), user=getpass.getuser()))
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def __enter__(self):
        log = open(self.folder / "daemons.log", "wb")
        self.daemons = [subprocess.Popen([name, "-D"], env=self.environment, stdout=log, stderr=log)
                        for name in ("slurmctld", "slurmd")]
        log.close()
        wait_for("the cluster is idle", lambda: "idle" in self.ask("sinfo", "-h", "-o", "%t"))
        return self

    def __exit__(self, *_):
        self.ask("scancel", "--user", getpass.getuser())
        wait_for("the queue is empty", lambda: not self.ask("squeue", "-h"))
        for daemon in reversed(self.daemons):
            daemon.terminate()
            daemon.wait(60)

    def ask(self, *words):
        return subprocess.run(words, env=self.environment, cwd=self.folder, capture_output=True, text=True).stdout.strip()

    def submit(self, script, *options):
        job = self.ask("sbatch", "--parsable", *options, str(script))
        check(job.isdigit(), f"submitted {job!r}")
        return job

    def finish(self, job):
        wait_for(f"job {job} ends", lambda: not self.ask("squeue", "-h", "-j", job))


def check_slurm(folder, whole):
    out, script = folder / "out", folder / "shards.sh"
    printed = expect(0, "study", *STUDY, "--out", str(out), "--print-shards", str(SHARDS)).stdout
    script.write_text(printed.replace("--cpus-per-task=2", "--cpus-per-task=1"))
    with Slurm(folder) as slurm:
        job = slurm.submit(script)
        kill(out, 1)
        wait_for("shard 3 runs and keeps a run", lambda: rows(out, 3) and process_of(out, 3))
        slurm.ask("scontrol", "requeue", f"{job}_3")
        check(wait_for("shard 3 is queued again", lambda: "PENDING" in slurm.ask("squeue", "-h", "-o", "%T", "-j", f"{job}_3")),
              "requeued")
        slurm.ask("scontrol", "update", f"JobId={job}_3", "StartTime=now")  # Slurm waits for two minutes otherwise
        slurm.finish(job)
        log = (folder / f"slurm-{job}_3.out").read_text()
        check("interrupted after" in log and log.splitlines()[-1].startswith(f"shard 3 of {SHARDS}: "),
              "a requeued shard goes on", log)
        lost = RUNS // SHARDS - rows(out, 1)
        done = run("study", *STUDY, "--out", str(out), "--merge", "--no-run")
        check(f"missing: of the shards 1 ({lost} run" in done.stderr, "the killed shard is missing", done.stderr)
        slurm.finish(slurm.submit(script, "--array=1"))
    check_merged(out, whole)


def check_parallel(folder, whole):
    out = folder / "out"
    printed = expect(0, "study", *STUDY, "--out", str(out), "--print-shards", str(SHARDS)).stdout
    line = next(line[2:] for line in printed.splitlines() if line.startswith("# parallel "))
    process = subprocess.Popen(["sh", "-c", line.partition(";")[0]], cwd=folder, env={**os.environ, "HOME": str(folder)},
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    kill(out, 2)
    output, error = process.communicate(timeout=300)
    check(process.returncode == 0, "parallel ends with 0", error)
    check(output.count(f": {RUNS // SHARDS} of {RUNS // SHARDS} runs are done") == SHARDS, "each shard ends once", output)
    tasks = [row.split("\t") for row in (folder / "log").read_text().splitlines()[1:]]
    check(sorted(row[6] for row in tasks) == ["0"] * SHARDS, "the log has each shard's exit code", tasks)
    check_merged(out, whole)


manner = sys.argv[2]
package, programs = NEEDED[manner]
missing = [name for name in programs if not shutil.which(name)]
if missing:
    print(f"skipped: {', '.join(missing)} not found; install the package {package}")
    sys.exit(77)
with tempfile.TemporaryDirectory(prefix="clearance-cluster-") as directory:
    place = pathlib.Path(directory)
    {"slurm": check_slurm, "parallel": check_parallel}[manner](place, undivided(place / "whole"))
end()
