"""What a wheel may ask for, and that a wheel is what its name says."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "cmake/packaging"))

from bundle_libraries import BASE, bundle, new_name  # noqa: E402
from check_wheel import wheel_problems  # noqa: E402
from shared_libraries import Elf, elf_files, loaded_libraries, parse_elf, read_elf  # noqa: E402
from wheel_rules import TAG, folder_problems, problems_of, too_new  # noqa: E402

OBJDUMP = """
_engine.so:     file format elf64-x86-64

Dynamic Section:
  NEEDED               libnlopt_cxx.so.0
  NEEDED               libc.so.6
  SONAME               _engine.so
  RUNPATH              $ORIGIN/../coapt.libs:/opt/lib

Version definitions:
1 0x01 0x0b792650 OWN_1.0

Version References:
  required from libc.so.6:
    0x06969194 0x00 12 GLIBC_2.14
    0x0abb9d3a 0x00 10 GLIBC_ABI_DT_RELR
"""


def engine(**changes):
    return Elf(**{"machine": "x86-64", "needed": ["libc.so.6"], "versions": {"GLIBC_2.36"}} | changes)


class Rules(unittest.TestCase):
    def test_objdump_is_read(self):
        elf = parse_elf(OBJDUMP)
        self.assertEqual(elf.machine, "x86-64")
        self.assertEqual(elf.soname, "_engine.so")
        self.assertEqual(elf.needed, ["libnlopt_cxx.so.0", "libc.so.6"])
        self.assertEqual(elf.run_path, ["$ORIGIN/../coapt.libs", "/opt/lib"])
        self.assertEqual(elf.versions, {"GLIBC_2.14", "GLIBC_ABI_DT_RELR"})

    def test_symbols_may_be_as_new_as_the_tag_says(self):
        for version in ("GLIBC_2.36", "GLIBC_2.2.5", "GLIBC_ABI_DT_RELR", "GLIBCXX_3.4.30", "CXXABI_TM_1", "XZ_5.0"):
            self.assertFalse(too_new(version), version)
        for version in ("GLIBC_2.37", "GLIBC_2.100", "GLIBC_PRIVATE", "GLIBCXX_3.4.31", "CXXABI_1.3.14", "GCC_13.0.0"):
            self.assertTrue(too_new(version), version)

    def test_each_breach_is_one_problem(self):
        self.assertEqual(problems_of("e.so", engine(), set()), [])
        for changes, said in (
            ({"machine": "littleaarch64"}, "is for littleaarch64"),
            ({"needed": ["libpython3.11.so.1.0"]}, "linked against libpython3.11.so.1.0"),
            ({"needed": ["libcairo.so.2"]}, "neither in the wheel nor allowed"),
            ({"versions": {"GLIBC_2.38"}}, "GLIBC_2.38, newer than"),
            ({"run_path": ["/usr/local/lib"]}, "outside the wheel"),
        ):
            (problem,) = problems_of("e.so", engine(**changes), set())
            self.assertIn(said, problem)
        self.assertEqual(problems_of("e.so", engine(needed=["own.so"], run_path=["$ORIGIN"]), {"own.so"}), [])
        (problem,) = problems_of("e.so", engine(needed=["own.so"]), {"own.so"})
        self.assertIn("does not say where", problem)


@unittest.skipUnless(shutil.which("patchelf"), "no patchelf")
class Bundled(unittest.TestCase):
    """A library of Debian's as if it were ours."""

    def setUp(self):
        self.enterContext(folder := tempfile.TemporaryDirectory())
        self.folder = pathlib.Path(folder.name)
        (self.folder / "coapt").mkdir()
        # libbrotlidec needs libbrotlicommon, and both come with libfreetype, which cairo needs.
        self.library = loaded_libraries("/usr/lib/x86_64-linux-gnu/libcairo.so.2")["libbrotlidec.so.1"]
        shutil.copyfile(self.library, self.folder / "coapt/engine.so")

    def test_what_a_file_needs_comes_along_under_a_name_of_its_own(self):
        self.assertEqual(len(folder_problems(self.folder)), 1)
        bundle(self.folder, "coapt.libs", rename=True)
        common = loaded_libraries(self.library)["libbrotlicommon.so.1"]
        name = new_name(common, "libbrotlicommon.so.1")
        self.assertRegex(name, r"^libbrotlicommon-[0-9a-f]{8}\.so\.1$")
        self.assertEqual([file.name for file in elf_files(self.folder)], ["engine.so", name])
        self.assertIn(name, read_elf(self.folder / "coapt/engine.so").needed)
        found = loaded_libraries(self.folder / "coapt/engine.so")
        self.assertEqual(found[name].resolve(), self.folder.resolve() / "coapt.libs" / name)
        self.assertLessEqual(set(found) - {name}, BASE)
        self.assertEqual(folder_problems(self.folder), [])
        row = (self.folder / "coapt.libs/libraries.tsv").read_text().split("\t")
        self.assertEqual(row[:2], [name, "libbrotli1"])
        self.assertTrue((self.folder / "coapt.libs/licenses/libbrotli1.txt").exists())

    def test_a_wheel_that_has_changed_is_refused(self):
        bundle(self.folder, "coapt.libs", rename=True)
        name = f"coapt-1.2-cp311-cp311-{TAG}"
        info = self.folder / "coapt-1.2.dist-info"
        info.mkdir()
        (info / "METADATA").write_text("Metadata-Version: 2.1\nName: coapt\nVersion: 1.2\n")
        (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nTag: cp311-cp311-{TAG}\n")
        with tempfile.TemporaryDirectory() as place:
            subprocess.run(
                ["/usr/bin/python3", "-m", "wheel", "pack", self.folder, "--dest-dir", place],
                check=True,
                capture_output=True,
            )
            wheel = pathlib.Path(place) / f"{name}.whl"
            self.assertEqual(wheel_problems(wheel), [])
            with zipfile.ZipFile(wheel, "a") as archive:
                archive.writestr("coapt/more.py", "")
            self.assertEqual(wheel_problems(wheel), ["coapt/more.py: not in RECORD"])
            other = wheel.rename(wheel.with_name("coapt-1.3-cp311-cp311-linux_x86_64.whl"))
            with self.assertRaises(KeyError):
                wheel_problems(other)


if __name__ == "__main__":
    unittest.main()
