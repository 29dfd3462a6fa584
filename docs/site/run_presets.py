#!/usr/bin/python3
"""Asks coapt what its presets are: for each a picture of the closed valve, and its description, closure and physiology as
one JSON. What is newer than the program is left.

Usage: docs/site/run_presets.py COAPT TARGET
"""

import json
import pathlib
import subprocess
import sys


def asked(coapt, *words):
    return json.loads(subprocess.run([coapt, *words, "--json"], capture_output=True, text=True, check=True).stdout)


def main():
    coapt, target = sys.argv[1], pathlib.Path(sys.argv[2])
    target.mkdir(parents=True, exist_ok=True)
    presets = asked(coapt, "presets")["presets"]
    (target / "presets.json").write_text(json.dumps([preset["name"] for preset in presets]))
    for preset in presets:
        name = preset["name"]
        file, picture = target / f"{name}.json", target / f"{name}.png"
        if file.exists() and file.stat().st_mtime > pathlib.Path(coapt).stat().st_mtime:
            continue
        print(f"Closing {name}", flush=True)
        preset["closure"] = asked(coapt, "close", name, "--render", picture)
        preset["valve"] = asked(coapt, "valve", "info", name)
        preset["physiology"] = asked(coapt, "study", "physiology", name)["rows"]
        file.write_text(json.dumps(preset))


if __name__ == "__main__":
    main()
