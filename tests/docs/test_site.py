#!/usr/bin/env python3
"""The pages that docs/site makes of documents, manual pages and the OpenAPI document, without Sphinx."""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

import gallery_pages  # noqa: E402
from manual_pages import manual_page  # noqa: E402
from notebook_pages import notebook_page  # noqa: E402
from pages import Gathering, anchor, place  # noqa: E402
from preset_pages import preset_pages  # noqa: E402
from rest_pages import rest_pages  # noqa: E402

LINK = re.compile(r"\]\(([^()\s#]+\.md)#?([^()\s]*)\)")


class Links(unittest.TestCase):
    def test_a_link_leads_to_the_sites_page_or_file(self):
        with tempfile.TemporaryDirectory() as folder:
            gathering = Gathering(folder)
            text = gathering.linked(
                "[a](../README.md#limits) [b](../core/valve/valve.h) ![c](images/demo.png) [d](../farm/ask/) [e](man)\n"
                "```\n[f](../README.md)\n```\n",
                "docs/surgeon.md",
            )
            self.assertEqual(
                text,
                "[a](overview.md#limits) [b](reference/cpp/core/valve/valve.md) ![c](images/demo.png) d "
                "[e](reference/commands/index.md)\n```\n[f](../README.md)\n```\n",
            )
            self.assertTrue((pathlib.Path(folder) / "images/demo.png").is_file())

    def test_documents_keep_their_tree_below_docs(self):
        self.assertEqual(place("docs/engineer/python.md"), "engineer/python.md")
        self.assertEqual(place("ARCHITECTURE.md"), "project/architecture.md")
        self.assertIsNone(place("farm/ask"))

    def test_what_an_earlier_gathering_left_is_removed(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "old").mkdir()
            (pathlib.Path(folder) / "old/page.md").write_text("# Old\n")
            gathering = Gathering(folder)
            gathering.write("new.md", "# New\n")
            gathering.finish()
            self.assertEqual([file.name for file in pathlib.Path(folder).iterdir()], ["new.md"])


class ManualPages(unittest.TestCase):
    def test_a_command_has_its_synopsis_its_options_and_examples(self):
        page, what = manual_page(
            'coapt(1) "coapt" "coapt"\n\n# NAME\n\ncoapt - closes valves\n\n## coapt close VALVE\n\n'
            "Closes a _VALVE_, see\ncoapt-lab(1).\n\n*-o*, *--output* _FILE_\n\tFile to write.\n\n"
            "# EXAMPLES\n\n\tcoapt close a.json++\ncoapt close \\*.json\n"
        )
        self.assertEqual(what, "closes valves")
        for part in (
            "# coapt\n\n## Name\n\ncoapt - closes valves",
            "### coapt close\n\n```\ncoapt close VALVE\n```",
            "Closes a <i>VALVE</i>, see\n[coapt-lab(1)](coapt-lab.md).",
            "<b>-o</b>, <b>--output</b> <i>FILE</i>\n: File to write.",
            "```bash\ncoapt close a.json\ncoapt close *.json\n```",
        ):
            self.assertIn(part, page)

    def test_every_page_is_read_to_its_end(self):
        for file in (ROOT / "docs/man").glob("*.scd"):
            page = manual_page(file.read_text(encoding="utf-8"))[0]
            for mark in "bi":
                self.assertEqual(page.count(f"<{mark}>"), page.count(f"</{mark}>"), file.name)
            self.assertEqual(re.findall(r"^.*(?:\+\+|\t).*$", page, re.MULTILINE), [], file.name)


class RestPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "openapi.json"
            command = ["cmake", "-D", f"OUTPUT={file}", "-P", ROOT / "server/openapi.cmake"]
            subprocess.run(command, check=True, capture_output=True)
            cls.document = json.loads(file.read_text(encoding="utf-8"))
        cls.pages = rest_pages(cls.document)
        cls.anchors = {
            name: {anchor(heading) for heading in re.findall(r"^#+ (.*)$", page, re.MULTILINE)}
            for name, page in cls.pages.items()
        }

    def test_every_request_and_schema_has_a_place(self):
        text = "\n".join(self.pages.values())
        for path, methods in self.document["paths"].items():
            for method in set(methods) & {"get", "post", "put", "patch", "delete"}:
                self.assertEqual(text.count(f"## {method.upper()} {path}\n"), 1)
        for name in self.document["components"]["schemas"]:
            self.assertIn(anchor(name), self.anchors["schemas.md"])

    def test_links_lead_to_headings(self):
        for name, page in self.pages.items():
            for target, heading in LINK.findall(page):
                if not target.startswith("../"):
                    self.assertIn(target, self.pages, name)
                    self.assertTrue(not heading or heading in self.anchors[target], f"{name}: {target}#{heading}")


class NotebookPages(unittest.TestCase):
    def test_a_cell_shows_the_richest_of_what_it_has(self):
        outputs = [
            {"output_type": "stream", "name": "stderr", "text": "progress"},
            {"output_type": "stream", "name": "stdout", "text": ["leak\n"]},
            {"output_type": "execute_result", "data": {"text/plain": "x", "text/html": ["<b>\n", "\n", "x</b>"]}},
            {"output_type": "display_data", "data": {"text/plain": "x", "image/png": "iVBORw=="}},
        ]
        cells = [{"cell_type": "code", "source": ["1"], "outputs": outputs}]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.ipynb"
            path.write_text(json.dumps({"cells": cells}))
            page, pictures = notebook_page(path)
        self.assertEqual(
            page,
            '```python\n1\n```\n\n```text\nleak\n```\n\n<div class="shown">\n<b>\nx</b>\n</div>\n\n'
            "![What the cell shows](a-1.png)\n",
        )
        self.assertEqual(pictures, {"a-1.png": b"\x89PNG"})


class GalleryPages(unittest.TestCase):
    def test_every_folder_is_a_group_and_every_script_says_what_it_shows(self):
        folders = {file.parent.name for file in (ROOT / "examples/gallery").glob("*/*")} - {"__pycache__"}
        self.assertEqual(folders, {folder for folder, _ in gallery_pages.groups()})
        for folder in folders:
            for script in gallery_pages.scripts(folder):
                self.assertRegex(gallery_pages.sentence(script), r"^[A-Z].{30,160}\.$", script)
                self.assertLessEqual(len(script.read_text(encoding="utf-8").splitlines()), 42, script)

    def test_a_page_has_picture_source_and_what_is_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, _ in gallery_pages.groups():
                place = pathlib.Path(folder) / name
                place.mkdir()
                for script in gallery_pages.scripts(name):
                    (place / f"{script.stem}.svg").write_text("<svg/>")
                    (place / f"{script.stem}.txt").write_text("leak 1 mm²\n")
            pages = gallery_pages.gallery_pages(folder)
        page = pages["leak/compare_shapes.md"]
        self.assertTrue(page.startswith("# Compare shapes\n\nMeasures how far"))
        self.assertIn("![Compare shapes](compare_shapes.svg)", page)
        self.assertIn("\n```bash\n# Measures how far", page)
        self.assertIn("```text\nleak 1 mm²\n```", page)
        self.assertIn("[Compare shapes](leak/compare_shapes.md)", pages["index.md"])
        self.assertEqual(pages["leak/compare_shapes.svg"], b"<svg/>")


class PresetPages(unittest.TestCase):
    def test_a_page_has_dimensions_and_every_row_of_physiology(self):
        row = {"what": "Opening", "unit": "mm2", "source": "Kubota 2010", "value": 520.6, "low": 400.0, "high": 600.0}
        unknown = {"what": "Ratio", "unit": "", "source": None, "value": None, "low": None, "high": None}
        preset = {
            "name": "human-normal",
            "title": "Normal",
            "about": "A healthy valve.",
            "closure": {"leak": {"area_mm2": 0.09, "error_mm2": None}, "tenting_height_mm": 9.23},
            "valve": {
                "saddle_to_mid_posterior_mm": 26.14,
                "commissures_mm": 31.84,
                "leaflet_area_mm2": 1392.02,
                "chordae": {"basal": 4, "marginal": 10},
                "ruptured_chordae": 0,
                "pressure_kpa": 16.0,
                "triangles": 648,
                "provenance": ["parametric valve"],
            },
            "physiology": [row | {"verdict": "met"}, row | {"verdict": "above"}, unknown | {"verdict": "unknown"}],
        }
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder)
            (made / "presets.json").write_text('["human-normal"]')
            (made / "human-normal.json").write_text(json.dumps(preset))
            (made / "human-normal.png").write_bytes(b"\x89PNG")
            pages = preset_pages(folder)
        listed = "| [human-normal](human-normal.md) | Normal | 0.1 | 26.1 x 31.8 | 1392 | 1 of 2 |"
        self.assertIn(listed, pages["index.md"])
        for line in (
            "| Chordae | 4 basal, 10 marginal; 0 ruptured |",
            "| Opening, mm2 | 521 | 400 to 600 | **above** | Kubota 2010 |",
            "| Ratio |  |  | **unknown** |  |",
            "for `coapt valve make --dimensions`",
        ):
            self.assertIn(line, pages["human-normal.md"])
        self.assertEqual(pages["human-normal.png"], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
