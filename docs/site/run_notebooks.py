#!/usr/bin/python3
"""Runs the notebooks in Jupyter's kernel, as a reader would, and keeps what they show. One that has not changed since
it was run is left; remove TARGET to run all.

Usage: docs/site/run_notebooks.py TARGET
"""

import os
import pathlib
import sys

import nbformat
from nbclient import NotebookClient
from pages import ROOT


def main():
    target = pathlib.Path(sys.argv[1])
    target.mkdir(parents=True, exist_ok=True)
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # no word of a debugger that nobody asked for
    for source in sorted((ROOT / "clients/python/notebooks").glob("*.ipynb")):
        ran = target / source.name
        if ran.exists() and ran.stat().st_mtime > source.stat().st_mtime:
            continue
        print(f"Running {source.name}", flush=True)
        notebook = nbformat.read(source, as_version=4)
        NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
        nbformat.write(notebook, ran)


if __name__ == "__main__":
    main()
