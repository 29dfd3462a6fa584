#!/usr/bin/python3
"""Runs the scripts of the gallery and keeps the picture and the text that each leaves.

Usage: examples/gallery/run.py [--changed] TARGET [SCRIPT...]

TARGET     folder; of closing/strain.py it gets closing/strain.png (or .svg), a thumbnail and closing/strain.txt
SCRIPT     the scripts to run (all)
--changed  leave those whose picture is newer than they are

Each runs in a folder of its own, beside a link to examples/, with the programs and the engine of COAPT_BUILD (build/release). The
scripts that ask a service share one, which COAPT_SERVER names. A script fails if it ends with an error, or leaves no picture of
its own name.
"""

import argparse
import contextlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

GALLERY = pathlib.Path(__file__).resolve().parent
ROOT = GALLERY.parents[1]
BUILD = pathlib.Path(os.environ.get("COAPT_BUILD", ROOT / "build/release")).resolve()
KINDS = (".py", ".sh", ".cpp")
THUMBNAIL_PX = 320
PATIENCE_S = 300


def scripts():
    return sorted(path for path in GALLERY.glob("*/*") if path.suffix in KINDS)


def asks_a_service(script):
    return "COAPT_SERVER" in script.read_text()


def surroundings():
    """The environment in which a reader who has built coapt runs a script."""
    found = dict(os.environ, MATPLOTLIBRC=str(GALLERY / "matplotlibrc"))
    found["PATH"] = f"{BUILD / 'bin'}:{pathlib.Path(sys.executable).parent}:{found['PATH']}"
    places = (ROOT / "clients/python", BUILD / "python", found.get("PYTHONPATH"))
    found["PYTHONPATH"] = ":".join(str(place) for place in places if place)
    return found


@contextlib.contextmanager
def service(folder, environment):
    """The address of a service that is there as long as the scripts need it."""
    command = ["coapt-server", "--port", "0", "--no-token", "--db", str(pathlib.Path(folder) / "service.sqlite")]
    with subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True) as server:
        try:
            for line in server.stderr:
                if found := re.search(r"listening on (http://\S+:\d+)", line):
                    yield found[1]
                    return
            raise SystemExit("coapt-server ended before it listened")
        finally:
            server.terminate()


def command_of(script, folder, environment):
    if script.suffix == ".py":
        return [sys.executable, script]
    if script.suffix == ".sh":
        return ["bash", "-eu", "-o", "pipefail", script]
    program = folder / script.stem
    packages = subprocess.run(["pkg-config", "--cflags", "--libs", "eigen3", "nlopt"], capture_output=True, text=True)
    flags = ["-std=c++20", "-O1", "-fopenmp", f"-I{ROOT}"]
    subprocess.run(
        ["c++", *flags, script, "-o", program, BUILD / "libcoapt.a", *packages.stdout.split()],
        check=True,
        env=environment,
        capture_output=True,
        text=True,
    )
    return [program]


def run(script, target, environment):
    """What went wrong, or nothing."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "examples").symlink_to(ROOT / "examples")
        try:
            command = command_of(script, folder, environment)
            ran = subprocess.run(
                command, cwd=folder, env=environment, capture_output=True, text=True, timeout=PATIENCE_S
            )
        except subprocess.TimeoutExpired:
            return f"took more than {PATIENCE_S} s"
        except subprocess.CalledProcessError as error:
            return error.stderr
        if ran.returncode != 0:
            return f"exit code {ran.returncode}\n{ran.stdout}{ran.stderr}"
        picture = next((file for end in (".png", ".svg") if (file := folder / (script.stem + end)).exists()), None)
        if picture is None:
            return f"left no picture {script.stem}.png or .svg"
        place = target / script.parent.name
        place.mkdir(parents=True, exist_ok=True)
        for end in (".png", ".svg"):
            (place / (script.stem + end)).unlink(missing_ok=True)
        (place / f"{script.stem}.txt").write_text(ran.stdout)
        make_thumbnail(picture, place / f"{script.stem}-small.png")
        shutil.move(picture, place / picture.name)  # last: it says that all is there
    return None


def make_thumbnail(picture, path):
    """A drawing of lines is its own thumbnail."""
    if picture.suffix == ".png":
        from matplotlib.image import imread, thumbnail

        thumbnail(picture, path, scale=min(1.0, THUMBNAIL_PX / imread(picture).shape[1]))


def is_done(script, target):
    made = target / script.parent.name / script.stem
    pictures = [file for end in (".png", ".svg") if (file := made.with_suffix(end)).exists()]
    return any(file.stat().st_mtime > script.stat().st_mtime for file in pictures)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("target", type=pathlib.Path)
    parser.add_argument("script", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    target, chosen = arguments.target.resolve(), [path.resolve() for path in arguments.script] or scripts()
    if arguments.changed:
        chosen = [script for script in chosen if not is_done(script, target)]
    environment, failed = surroundings(), []
    environment.pop("COAPT_SERVER", None)  # else coapt runs there
    served = environment
    with contextlib.ExitStack() as stack:
        if any(asks_a_service(script) for script in chosen):
            folder = stack.enter_context(tempfile.TemporaryDirectory())
            served = environment | {"COAPT_SERVER": stack.enter_context(service(folder, environment))}
        for script in chosen:
            name, begun = script.relative_to(GALLERY), time.monotonic()
            wrong = run(script, target, served if asks_a_service(script) else environment)
            print(f"{time.monotonic() - begun:6.1f} s  {name}{': FAILED' if wrong else ''}", flush=True)
            if wrong:
                failed.append(f"{name}: {wrong}")
    print("\n".join(failed), end="\n" if failed else "", file=sys.stderr)
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main())
