#!/usr/bin/env python3
"""Fails if a relative link or an anchor in a Markdown file of the repository leads nowhere, if one names a make target, a
script or an example that does not exist, or if the README is too long.

Usage: tests/docs/check_documents.py
"""
import pathlib
import re
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_README_LINES = 60
FENCE = re.compile(r"^\s*```.*?^\s*```\s*$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^()\s]+)\)")
CODE = re.compile(r"`([^`]+)`")
MAKE = re.compile(r"(?:^|[;&|] *)make ((?:[a-z][a-z0-9-]*)(?: [a-z][a-z0-9-]*)*)", re.MULTILINE)
TARGET = re.compile(r"^([a-z][a-z0-9-]*):", re.MULTILINE)
# A file or folder of these is named in full; a pattern may stand for several.
NAMED = re.compile(r"(?<![\w./*-])(?:docs|examples|lab|tests|cmake)/[\w./*-]*[\w/*]")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*$", re.MULTILINE)


def markdown_files():
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    return [path for path in map(ROOT.joinpath, listed.stdout.splitlines()) if path.exists()]


def prose(path):
    """The text without fenced blocks, which hold no links."""
    return FENCE.sub("", path.read_text(encoding="utf-8"))


def anchors(path):
    """As GitHub makes them: lower case, punctuation dropped, spaces to hyphens, repetitions numbered."""
    found = {}
    names = set()
    for heading in HEADING.findall(prose(path)):
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        count = found.get(name, 0)
        found[name] = count + 1
        names.add(f"{name}-{count}" if count else name)
    return names


def problem(source, target):
    if re.match(r"[a-z]+:", target):
        return None
    path, _, anchor = target.partition("#")
    file = (source.parent / urllib.parse.unquote(path)).resolve() if path else source
    if not file.exists():
        return "no such file"
    if anchor and (file.suffix != ".md" or anchor not in anchors(file)):
        return "no such heading"
    return None


def missing_targets(source, targets):
    """Of make commands in code. Names are one space apart: what follows more of them is a comment."""
    text = source.read_text(encoding="utf-8")
    code = "\n".join(FENCE.findall(text) + CODE.findall(prose(source)))
    named = {name for names in MAKE.findall(code) for name in names.split()}
    return sorted(named - targets)


def missing_files(source):
    """Scripts, examples and other files that code names by their path from the root."""
    text = source.read_text(encoding="utf-8")
    code = "\n".join(FENCE.findall(text) + CODE.findall(prose(source)))
    return sorted(name for name in set(NAMED.findall(code)) if not any(ROOT.glob(name.rstrip("/"))))


def main():
    wrong = []
    targets = set(TARGET.findall((ROOT / "Makefile").read_text(encoding="utf-8")))
    for source in markdown_files():
        wrong += [
            f"{source.relative_to(ROOT)}: make {name}: no such target" for name in missing_targets(source, targets)
        ]
        if source.name != "CHANGELOG.md" and not source.match("docs/experiments.md"):  # they name what was
            wrong += [f"{source.relative_to(ROOT)}: {name}: no such file" for name in missing_files(source)]
        for target in LINK.findall(prose(source)):
            if reason := problem(source, target):
                wrong.append(f"{source.relative_to(ROOT)}: {target}: {reason}")
    lines = len((ROOT / "README.md").read_text(encoding="utf-8").splitlines())
    if lines > MOST_README_LINES:
        wrong.append(f"README.md: {lines} lines, {MOST_README_LINES} at most")
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
