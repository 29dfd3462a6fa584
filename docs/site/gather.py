#!/usr/bin/python3
"""Gathers the sources of the documentation site: the repository's Markdown, and pages made of headers, manual pages, the
OpenAPI document, notebooks, the gallery and the presets.

Usage: docs/site/gather.py TARGET XML OPENAPI NOTEBOOKS GALLERY PRESETS

TARGET    folder of the sources, written
XML       Doxygen's, of the headers of core and search
OPENAPI   the document that stands alone
NOTEBOOKS folder of the notebooks that were run (run_notebooks.py)
GALLERY   folder of what its scripts drew and printed (examples/gallery/run.py)
PRESETS   folder of what coapt says of its presets (docs/site/run_presets.py)
"""

import json
import pathlib
import re
import sys

from gallery_pages import gallery_pages
from header_pages import header_pages
from manual_pages import manual_page
from notebook_pages import notebook_page
from pages import ROOT, Gathering, place, relative
from preset_pages import preset_pages
from rest_pages import rest_pages

SITE = pathlib.Path(__file__).parent
BESIDE = ("README.md", "docs/README.md", "CHANGELOG.md")
MANUAL = ("coapt", "coapt-server", "coapt-farm", "coapt-live", "coapt-lab")
NOTEBOOKS = ("first_repair", "drawings", "own_study", "own_objective", "surrogate")


def readers():
    """Caption and documents of each table of docs/README.md."""
    text = (ROOT / "docs/README.md").read_text(encoding="utf-8")
    for heading, table in re.findall(r"^## (.+?)$(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL):
        if linked := re.findall(r"^\| \[[^\]]+\]\(([^)#]+)\)", table, re.MULTILINE):
            yield heading, [(ROOT / "docs" / path).resolve().relative_to(ROOT).as_posix() for path in linked]


def contents(caption, pages):
    entries = "\n".join(page.removesuffix(".md") for page in pages)
    return f"```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{entries}\n```\n"


def every_page(listed):
    """The contents by reader, for the front page."""
    *readings, project = [(caption, [place(path) for path in paths]) for caption, paths in listed]
    parts = [("coapt", ["overview.md", "documents.md"]), *readings]
    parts += [("Gallery", ["gallery/index"])]
    parts += [("Notebooks", [f"notebooks/{name}" for name in ("index", *NOTEBOOKS)])]
    parts += [("Reference", [f"reference/{name}/index" for name in ("presets", "python", "commands", "rest", "cpp")])]
    parts += [project]
    seen, text = set(), ""
    for caption, pages in parts:
        text += "\n" + contents(caption, [page for page in pages if page not in seen])
        seen.update(pages)
    return text


def listing(title, words, pages):
    """A page that lists others: file, title, what it is."""
    entries = "\n".join(f"- [{name}]({page}.md): {what}" for page, name, what in pages)
    names = "\n".join(page for page, _, _ in pages)
    return f"# {title}\n\n{words}\n\n{entries}\n\n```{{toctree}}\n:hidden:\n\n{names}\n```\n"


def main():
    target, xml, openapi, notebooks, gallery, presets = sys.argv[1:]
    gathering, listed = Gathering(target), list(readers())
    for page, more in (("index", every_page(listed)), ("notebooks", "")):
        path = f"docs/site/{page}.md"
        gathering.write(place(path), gathering.linked((SITE / f"{page}.md").read_text(encoding="utf-8"), path) + more)
    gathering.documents([*BESIDE, *dict.fromkeys(path for _, paths in listed for path in paths if path not in BESIDE)])

    for file in sorted((SITE / "python").glob("*.rst")):
        gathering.write(f"reference/python/{file.name}", file.read_bytes())
    for name, page in header_pages(pathlib.Path(xml)).items():
        gathering.write(f"reference/cpp/{name}", page)
    for name, page in rest_pages(json.loads(pathlib.Path(openapi).read_text(encoding="utf-8"))).items():
        gathering.write(f"reference/rest/{name}", page)

    manual = [manual_page((ROOT / f"docs/man/{name}.1.scd").read_text(encoding="utf-8")) for name in MANUAL]
    for name, (page, _) in zip(MANUAL, manual):
        gathering.write(f"reference/commands/{name}.md", page)
    words = "The manual pages. Each command's `--help` says the same in short."
    entries = [(name, name, what) for name, (_, what) in zip(MANUAL, manual)]
    gathering.write("reference/commands/index.md", listing("Commands", words, entries))

    for name in NOTEBOOKS:
        page, pictures = notebook_page(pathlib.Path(notebooks) / f"{name}.ipynb")
        here = f"notebooks/{name}.md"
        for picture, content in pictures.items():
            gathering.write(f"notebooks/{picture}", content)
        source = f"clients/python/notebooks/{name}.ipynb"
        gathering.write(source, (ROOT / source).read_bytes())
        gathering.write(here, page.replace("\n\n", f"\n\n[The notebook]({relative(source, here)})\n\n", 1))
    for name, content in gallery_pages(gallery).items():
        gathering.write(f"gallery/{name}", content)
    for name, content in preset_pages(presets).items():
        gathering.write(f"reference/presets/{name}", content)
    gathering.finish()


if __name__ == "__main__":
    main()
