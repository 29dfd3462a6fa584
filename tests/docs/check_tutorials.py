#!/usr/bin/python3
"""Fails if a command of a tutorial prints anything but what the tutorial shows.

Usage: tests/docs/check_tutorials.py [--write] BIN [TUTORIAL...]

BIN       folder of the programs
TUTORIAL  the pages to follow (all of docs/tutorials)
--write   puts what was printed into the pages instead

The blocks of a page that are fenced as `console` are one session of bash in an empty folder, beside a link to examples/: each line that
begins with "$ " is a command, the lines below it are what it prints. A block of Python after the words "Save this as `NAME`:" is that file. Seconds differ and are not compared; a last line "..."
stands for whatever follows. A service at port 8080 gets a free port.
"""

import argparse
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?<=^```console\n)(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)
SAVED = re.compile(r"[Ss]ave this as `([\w.]+)`:\n```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SECONDS = re.compile(r"\b\d+(\.\d+)? s\b")
MARK = "---- what follows was printed by command"
PORT = "8080"


def commands_of(page):
    """Each command with the lines that the page shows below it, by block."""
    blocks = []
    for block in BLOCK.findall(page):
        lines = block.splitlines()
        starts = [number for number, line in enumerate(lines) if line.startswith("$ ")] + [len(lines)]
        blocks.append([(lines[a][2:], lines[a + 1 : b]) for a, b in zip(starts, starts[1:])])
    return blocks


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return str(one.getsockname()[1])


def session(commands, binaries, folder):
    """What each command prints, as lines."""
    (folder / "examples").symlink_to(ROOT / "examples")
    port = free_port()
    script = "".join(f"echo '{MARK}'\n{command.replace(PORT, port)}\n" for command in commands)
    places = (ROOT / "clients/python", binaries.parent / "python")
    found = dict(
        os.environ,
        PATH=f"{binaries}:{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}",
        PYTHONPATH=":".join(map(str, places)),
    )
    with subprocess.Popen(
        ["bash"], cwd=folder, env=found, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        start_new_session=True,
    ) as shell:  # fmt: skip
        script += "kill $(jobs -p) 2>/dev/null; wait\n"
        printed = shell.communicate(script)[0].replace(port, PORT)
    return [part.splitlines() for part in printed.split(f"{MARK}\n")[1:]]


def as_shown(printed, shown):
    """As much of what was printed as the page shows."""
    if shown[-1:] != ["..."]:
        return printed
    return [*printed[: len(shown) - 1], "..."]


def followed(page, binaries):
    """The page as it should be, and where it is otherwise."""
    blocks = commands_of(page)
    with tempfile.TemporaryDirectory() as folder:
        for name, text in SAVED.findall(page):
            (pathlib.Path(folder) / name).write_text(text, encoding="utf-8")
        printed = iter(session([command for block in blocks for command, _ in block], binaries, pathlib.Path(folder)))
    wrong, texts = [], []
    for block in blocks:
        text = ""
        for command, shown in block:
            now = as_shown(next(printed, ["(nothing: the session ended before)"]), shown)
            same = SECONDS.sub("", "\n".join(now)) == SECONDS.sub("", "\n".join(shown))
            if not same:
                wrong.append(f"$ {command}\n" + "\n".join(now))
            text += "\n".join([f"$ {command}", *(shown if same else now)]) + "\n"
        texts.append(text)
    texts = iter(texts)
    return BLOCK.sub(lambda _: next(texts), page), wrong


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("binaries", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("tutorials", nargs="*", type=pathlib.Path)
    given = parser.parse_args()
    failed = False
    for file in given.tutorials or sorted((ROOT / "docs/tutorials").glob("*.md")):
        page, wrong = followed(file.read_text(encoding="utf-8"), given.binaries)
        if given.write:
            file.write_text(page, encoding="utf-8")
        elif wrong:
            failed = True
            print(f"{file}: prints otherwise:", *wrong, sep="\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
