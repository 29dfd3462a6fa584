"""What starts the workers of a farm (examples/farm): Slurm, systemd, ssh, each with the toy kind of work."""

import os
import pathlib
import re
import shutil
import stat
import subprocess
import tempfile
import time
import unittest

from farm_runs import FARM, FarmTest, Request
from process_runs import HANGS_S

STARTERS = pathlib.Path(__file__).resolve().parents[2] / "examples/farm"
SLURM = [shutil.which(name, path="/usr/sbin:/usr/bin:/sbin") for name in ("slurmctld", "slurmd", "munged", "sbatch")]
LARGEST_EXPOSURE = 15  # tenths, as of coapt-server's unit (tests/e2e/test_deploy.py)

# One node that claims to have four processors.
SLURM_CONF = """
ClusterName=test
SlurmctldHost=localhost
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
SlurmctldPort={port}
SlurmdPort={other_port}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdParameters=config_overrides
MpiDefault=none
JobRequeue=1
NodeName=localhost CPUs=4 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class Starters(FarmTest):
    def setUp(self):
        super().setUp()
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="starters"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "coapt-farm").symlink_to(FARM)
        self.environment = {
            **os.environ,
            "COAPT_FARM": self.url,
            "HOME": str(self.folder),
            "PATH": f"{self.folder}:{os.environ['PATH']}",
        }

    def script(self, name, text):
        path = self.folder / name
        path.write_text(text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    def run_here(self, *command, **options):
        run = subprocess.run(
            list(map(str, command)), env=self.environment, cwd=self.folder, capture_output=True, text=True, timeout=HANGS_S,
            **options,
        )  # fmt: skip
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def names_of_workers(self):
        return {worker["name"] for worker in self.status()["workers"]}

    def test_ssh_starts_as_many_workers_as_are_asked_for_and_keeps_the_address_out_of_its_arguments(self):
        self.script("ssh", f'#!/bin/bash\necho "$@" >>{self.folder}/called\nshift\nexec bash -c "$*"\n')
        self.script("hostname", "#!/bin/bash\necho node1\n")
        hosts = self.script("hosts", "# ours\nnode1 2\n\n")
        request = Request(300)
        waiting = self.coordinator(request)
        self.run_here(STARTERS / "ssh/start_workers.sh", hosts)
        self.collect(waiting, request)
        self.assertEqual(self.names_of_workers(), {"node1-1", "node1-2"})
        self.assertNotIn(self.url, (self.folder / "called").read_text())

    def test_the_flags_of_the_systemd_unit_are_those_of_the_program(self):
        unit = (STARTERS / "systemd/coapt-work@.service").read_text()
        flags = set(re.findall(r"--[a-z-]+", re.search(r"^ExecStart=(.*)$", unit, re.M).group(1)))
        self.assertLessEqual(flags, set(re.findall(r"--[a-z-]+", self.farm("work", "--help").stdout.decode())))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "needs systemd-analyze")
    def test_systemd_takes_the_unit_and_finds_it_locked_down(self):
        unit = self.folder / "coapt-work@1.service"
        text = (STARTERS / "systemd/coapt-work@.service").read_text()
        unit.write_text(text.replace("/usr/local/bin/coapt-farm", FARM).replace("/etc/coapt-farm", "/etc/hostname"))
        self.run_here("systemd-analyze", "verify", unit)
        exposure = f"--threshold={LARGEST_EXPOSURE}"
        self.run_here("systemd-analyze", "security", "--offline=yes", "--no-pager", exposure, unit)

    @unittest.skipUnless(all(SLURM) and os.geteuid() == 0, "needs Slurm's packages and root")
    def test_a_slurm_array_works_until_nothing_is_left(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        port = 20000 + os.getpid() % 20000
        conf = self.folder / "slurm.conf"
        conf.write_text(SLURM_CONF.format(folder=self.folder, port=port, other_port=port + 1))
        self.environment["SLURM_CONF"] = str(conf)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        controller, node, munge, batch = SLURM
        files = {"socket": "munge.socket", "key-file": "munge.key", "pid-file": "munge.pid", "seed-file": "munge.seed",
                 "log-file": "munge.log"}  # fmt: skip
        daemons = [
            [munge, "--foreground", "--force", *(f"--{name}={self.folder}/{file}" for name, file in files.items())],
            [controller, "-D"],
            [node, "-D"],
        ]
        for daemon in daemons:
            process = subprocess.Popen(
                daemon, env=self.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
            )
            self.addCleanup(self.end, process)
            time.sleep(0.5)
        request = Request(400)
        waiting = self.coordinator(request)
        started = time.monotonic()
        while True:
            queued = subprocess.run(
                [batch, "--array=0-2", STARTERS / "slurm/coapt-work.sh"],
                env=self.environment, cwd=self.folder, capture_output=True, text=True,
            )  # fmt: skip
            if queued.returncode == 0 or time.monotonic() - started > 20:
                break
            time.sleep(0.5)
        self.assertEqual(queued.returncode, 0, queued.stderr)
        self.collect(waiting, request)
        number = queued.stdout.split()[-1]
        self.assertTrue(self.names_of_workers() <= {f"slurm-{number}-{i}" for i in range(3)})
        self.assert_each_item_once(request)


if __name__ == "__main__":
    unittest.main()
