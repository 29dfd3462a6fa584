"""How far a process has come, told by what it has done: time on the clock says nothing on a busy machine."""

import os
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "service"))

from served import HANGS_S  # noqa: E402


def wait_until(condition):
    deadline = time.monotonic() + HANGS_S
    while not condition():
        if time.monotonic() > deadline:
            raise TimeoutError(f"not within {HANGS_S} s")
        time.sleep(0.02)


def after_name(process):
    return pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()


def cpu_seconds(process):
    """Of all its threads, in user mode."""
    return int(after_name(process)[11]) / os.sysconf("SC_CLK_TCK")


def is_stopped(process):
    """By SIGSTOP."""
    return after_name(process)[0] == "T"


def catches(process, signal):
    """Whether it has a handler for it."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    caught = next(line for line in status.splitlines() if line.startswith("SigCgt:")).split()[1]
    return bool(int(caught, 16) >> (signal - 1) & 1)
