"""coapt-lab, the program under test."""

import os
import subprocess

from process_runs import HANGS_S

LAB = os.environ["COAPT_LAB"]


def coapt_lab(*arguments):
    """Runs coapt-lab; the result has returncode, stdout, stderr."""
    return subprocess.run([LAB, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_S)
