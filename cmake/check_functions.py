#!/usr/bin/env python3
"""check_functions.py [ROOT]: fails if a source X.cpp defines a function that a header other than X.h declares.

Read by their form, as clang-format lays them out: heads of functions begin at the left margin, anonymous namespaces end with their
comment. Overloads are told apart by the types of their parameters. A class's functions are where its header says, too."""
import os
import re
import sys
from collections import defaultdict
from pathlib import Path

from check_includes import sources

# They front files of one function each, and of a reader and a writer.
FRONTS = ("commands.h", "_parts.h", "operations/table.h", "io/json/valve_json.h", "io/json/plan_json.h")
HEAD = re.compile(
    r"^(?!using |template|#)(?:[\w:<>,&*\[\]]+ +[&*]*)*?((?:\w+::)*~?\w+)\(([^;{]*?)\)"
    r"(?: const)?(?: noexcept)?\s*(?:: [^;{]*?(?:\{[^;]*?\}|\))[^;{]*)?([;{])",
    re.MULTILINE,
)
CLASS = re.compile(r"^(?:class|struct) (\w+)(?: final)? \{", re.MULTILINE)


def types(parameters):
    """Of a function's parameters, without their names and defaults."""
    depth, each = 0, [""]
    for letter in re.sub(r"\s+", " ", parameters):
        depth += (letter in "<({[") - (letter in ">)}]")
        if letter == "," and depth == 0:
            each.append("")
        else:
            each[-1] += letter
    named = r"(.*[\s&*>])\w+$"
    return tuple(
        re.sub(r"\bconst\b|\s", "", re.sub(named, r"\1", one) if " " in re.sub("^const ", "", one) else one)
        for one in (one.split(" = ")[0].strip() for one in each)
    )


def complaints(texts):
    """What is wrong in `texts`, pairs of a file's name and its text."""
    homes, defined = defaultdict(set), []
    for file, text in texts:
        bare = re.sub(r"^namespace \{\n.*?^\}  // namespace\n", "", text, flags=re.MULTILINE | re.DOTALL)
        bare = re.sub(r" *//[^\n]*", "", bare)
        for name, parameters, end in HEAD.findall(bare):
            if end == ";" and file.endswith(".h"):
                homes[name, types(parameters)].add(file)
            elif end == "{" and file.endswith(".cpp"):
                # Of a class: wherever that is.
                defined.append((name, name.split("::")[-2] if "::" in name else (name, types(parameters)), file))
        if file.endswith(".h"):
            for name in CLASS.findall(bare):
                homes[name].add(file)
    for name, key, file in defined:
        headers = {header for header in homes.get(key, ()) if not header.endswith(FRONTS)}
        if headers and file.removesuffix(".cpp") + ".h" not in headers:
            yield f"{file}: {name}() is declared in {' and '.join(sorted(headers))}"


def main():
    os.chdir(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent)
    wrong = list(complaints((file, "\n".join(lines) + "\n") for file, lines in sources()))
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
