"""Units of examples/ and of the Debian packages: what systemd and the service itself say of them."""

import re
import shutil
import subprocess
import unittest

from programs import SERVER, SOURCE, ProgramTest

UNIT = SOURCE / "examples/deploy/coapt-server.service"
PACKAGED = SOURCE / "debian/coapt-server.service"
WORKER = SOURCE / "examples/farm/systemd/coapt-work@.service"
PACKAGED_WORKER = SOURCE / "debian/coapt-farm.coapt-work@.service"
LARGEST_EXPOSURE = 12  # tenths, of 100, as docs/engineer/deploy.md says: "OK" ends at 49, "SAFE" at 9


def limits(unit):
    """What a service may use and do: the lines from "What it may use", or of a worker from its restarts, but its user."""
    text = unit.read_text()
    return [line for line in text[text.index("Restart=") :].splitlines() if line != "DynamicUser=yes"]


class Deploy(ProgramTest):
    def test_the_packages_are_built_of_what_the_build_needs(self):
        control = (SOURCE / "debian/control").read_text()
        asked = re.findall(r"[\w.+-]+", control[: control.index("Standards-Version:")].split("Build-Depends:")[1])
        rows = (SOURCE / "cmake/packages.txt").read_text()
        needed = {package for package in re.findall(r"^build +(\S+)", rows, re.M) if package != "g++"}
        self.assertEqual(set(asked) - {"debhelper-compat", "13", "dh-sequence-python3", "scdoc"}, needed)

    def test_the_packages_units_have_the_limits_of_the_examples(self):
        self.assertEqual(limits(PACKAGED), limits(UNIT))
        self.assertEqual(limits(PACKAGED_WORKER), limits(WORKER))

    def test_the_flags_of_the_unit_are_those_of_the_service(self):
        started = "".join(re.findall(r"^ExecStart=(.*)$", UNIT.read_text() + PACKAGED.read_text(), re.M))
        printed = subprocess.run([SERVER, "--help"], capture_output=True, text=True, check=True).stdout
        flags = set(re.findall(r"--[a-z-]+", started))
        self.assertGreater(len(flags), 0)
        self.assertLessEqual(flags, set(re.findall(r"--[a-z-]+", printed)))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "needs systemd-analyze")
    def test_systemd_takes_the_unit_and_finds_it_locked_down(self):
        self.check_unit(UNIT.read_text().replace("/usr/local/bin/coapt-server", SERVER))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "needs systemd-analyze")
    def test_systemd_takes_the_packages_unit(self):
        # Its manual page is not installed here.
        text = re.sub(r"^Documentation=.*\n", "", PACKAGED.read_text(), flags=re.M)
        self.check_unit(text.replace("/usr/bin/coapt-server", SERVER))

    def check_unit(self, text):
        unit = self.write("coapt-server.service", text)
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
