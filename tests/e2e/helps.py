"""Every command of a program, by its --help."""

import re
import subprocess

NOTICE = "coapt is research software, not a medical device; not for clinical decisions."


def about(program):
    """What its --version prints, as a pattern."""
    revision = r"\nrevision \S+, closures \d+, plans \d+\n"
    return rf"^{program} \d+\.\d+\.\d+" + revision + re.escape(NOTICE) + r"\n$"


def help_of(*command):
    return subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout


def listed(text, heading):
    """First words of the lines below a heading."""
    below = re.search(rf"^{heading}:\n((?:  .*\n)+)", text, re.MULTILINE)
    return re.findall(r"^  (\S+)", below.group(1), re.MULTILINE) if below else []


def commands(*command):
    """Those that do something, as words, with the text of their help."""
    text = help_of(*command)
    below = listed(text, "Subcommands")
    if not below:
        yield command, text
    for name in below:
        yield from commands(*command, name)


def flags(text):
    """All options of a help: "-o", "--output"."""
    return {flag for names in re.findall(r"^ +(-\S+)", text, re.MULTILINE) for flag in names.split(",")}
