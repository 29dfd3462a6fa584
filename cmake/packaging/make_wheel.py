#!/usr/bin/env python3
"""Makes the wheel: the Python package, the engine and the libraries that the engine needs.

Usage: SOURCE_DATE_EPOCH=... make_wheel.py BUILD OUTPUT    for instance build/release build/wheel

The name has the tag of manylinux if its rules hold (wheel_rules.py), else linux. Nothing is fetched: setuptools and wheel are
Debian's. The same build and SOURCE_DATE_EPOCH give the same bytes.
"""
import contextlib
import io
import logging
import os
import pathlib
import shutil
import sys
import tempfile
import warnings

import setuptools.build_meta
from bundle_libraries import bundle
from wheel.wheelfile import WheelFile
from wheel_rules import TAG, folder_problems

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "clients/python"


def metadata(source, target):
    """The .dist-info that setuptools makes of pyproject.toml; its name."""
    warnings.simplefilter("ignore")  # that Debian's setuptools takes its part of pyproject.toml for a beta
    with contextlib.chdir(source), contextlib.redirect_stdout(io.StringIO()):
        info = setuptools.build_meta.prepare_metadata_for_build_wheel(str(target))
    shutil.rmtree(target / "coapt.egg-info")
    # Arrays, which the client alone can do without.
    file = target / info / "METADATA"
    head, blank, text = file.read_text(encoding="utf-8").partition("\n\n")
    file.write_text(f"{head}\nRequires-Dist: numpy{blank}{text}", encoding="utf-8")
    return info


def lay_out(build, folder):
    """What the wheel holds, in `folder`; the names of its .dist-info and of the module."""
    with tempfile.TemporaryDirectory() as source:
        source = pathlib.Path(source)
        shutil.copytree(PACKAGE / "coapt", source / "coapt", ignore=shutil.ignore_patterns("__pycache__"))
        for file in (PACKAGE / "pyproject.toml", PACKAGE / "README.md", ROOT / "LICENSE"):
            shutil.copy(file, source)
        info = metadata(source, folder)
        shutil.copytree(source / "coapt", folder / "coapt")
    (module,) = (build / "python/coapt").glob("_engine.cpython-*.so")
    shutil.copy(module, folder / "coapt")
    bundle(folder, "coapt.libs", rename=True)
    return info, module.name


def make_wheel(build, output):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        info, module = lay_out(build, folder)
        against = folder_problems(folder)
        for problem in against:
            print(problem, file=sys.stderr)
        python = "cp" + module.split("-")[1]  # _engine.cpython-311-x86_64-linux-gnu.so
        tag = f"{python}-{python}-{'linux_x86_64' if against else TAG}"
        version = info.removesuffix(".dist-info")
        (folder / info / "WHEEL").write_text(
            f"Wheel-Version: 1.0\nGenerator: coapt\nRoot-Is-Purelib: false\nTag: {tag}\n", encoding="utf-8"
        )
        for path in folder.rglob("*"):
            path.chmod(0o755 if path.is_dir() or path.suffix == ".so" else 0o644)
        output.mkdir(parents=True, exist_ok=True)
        for old in output.glob("coapt-*.whl"):
            old.unlink()
        name = output / f"{version}-{tag}.whl"
        logging.getLogger("wheel").setLevel(logging.WARNING)
        with WheelFile(name, "w") as wheel:
            wheel.write_files(folder)
        return name


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if "SOURCE_DATE_EPOCH" not in os.environ:
        sys.exit("SOURCE_DATE_EPOCH is not set: the time of the commit, in seconds since 1970")
    print(make_wheel(*map(pathlib.Path, sys.argv[1:])))


if __name__ == "__main__":
    main()
