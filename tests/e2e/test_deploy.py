"""examples/deploy/coapt-server.service: what systemd and the service itself say of it."""

import re
import shutil
import subprocess
import unittest

from programs import SERVER, SOURCE, ProgramTest

UNIT = SOURCE / "examples/deploy/coapt-server.service"
LARGEST_EXPOSURE = 15  # tenths, of 100: "OK" ends at 49, "SAFE" at 9


class Deploy(ProgramTest):
    def test_the_flags_of_the_unit_are_those_of_the_service(self):
        started = re.search(r"^ExecStart=(.*)$", UNIT.read_text(), re.M).group(1)
        printed = subprocess.run([SERVER, "--help"], capture_output=True, text=True, check=True).stdout
        flags = set(re.findall(r"--[a-z-]+", started))
        self.assertGreater(len(flags), 0)
        self.assertLessEqual(flags, set(re.findall(r"--[a-z-]+", printed)))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "needs systemd-analyze")
    def test_systemd_takes_the_unit_and_finds_it_locked_down(self):
        unit = self.write("coapt-server.service", UNIT.read_text().replace("/usr/local/bin/coapt-server", SERVER))
        verified = subprocess.run(["systemd-analyze", "verify", unit], capture_output=True, text=True)
        self.assertEqual((verified.returncode, verified.stderr), (0, ""))
        exposed = subprocess.run(
            ["systemd-analyze", "security", "--offline=yes", "--no-pager", f"--threshold={LARGEST_EXPOSURE}", unit],
            capture_output=True,
            text=True,
        )
        self.assertEqual(exposed.returncode, 0, exposed.stdout + exposed.stderr)


if __name__ == "__main__":
    unittest.main()
