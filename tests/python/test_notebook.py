"""What notebooks show."""

import html.parser
import unittest

import coapt
from client_runs import SMALL, VALVE, ClientTest
from coapt import tables

VOID = {"br", "img"}


class Balanced(html.parser.HTMLParser):
    """Fails on an element that is not closed."""

    def __init__(self, text):
        super().__init__()
        self.open, self.tags = [], set()
        self.feed(text)
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        self.tags.add(tag)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.tags.add(tag)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()


class Shown(ClientTest):
    def shown(self, thing):
        """Names of the elements that a notebook gets."""
        text = thing._repr_html_()
        self.assertIn(coapt.NOTICE, text)
        return Balanced(text).tags

    def test_a_closure_shows_its_figures_and_where_leaflets_meet(self):
        closure = self.client.close(VALVE)
        leak = closure.measure.leak
        self.assertLessEqual({"table", "svg", "rect"}, self.shown(closure))
        self.assertIn(f"<b>{tables.with_error(leak.area_mm2, leak.error_mm2)} mm²</b>", closure._repr_html_())
        self.assertIn(f"{leak.openings[0].width_mm:.1f} mm wide, at ", closure._repr_html_())

    def test_a_valves_name_is_text_and_no_html(self):
        valve = self.client.get_valve(VALVE) | {"name": "<script>alert(1)</script>"}
        self.assertNotIn("script", self.shown(self.client.close(valve)))

    def test_plans_show_a_table_and_one_of_a_search_its_picture(self):
        job = self.client.search(VALVE, **SMALL)
        result = job.result()
        self.assertIn("table", self.shown(result))
        self.assertIn("img", self.shown(result.plans[0]))
        self.assertEqual(result.plans[0].picture()._repr_png_()[:4], b"\x89PNG")
        self.assertNotIn("img", self.shown(self.client.evaluate(VALVE, [result.plans[0]]).plans[0]))
        self.shown(job)

    def test_a_study_shows_its_findings(self):
        result = self.client.study("porcine-3", "annulus").result()
        self.assertEqual(result._repr_html_().count("<tr>"), 1 + len(result.findings))
        self.shown(result)


class WithoutNumpy(unittest.TestCase):
    PLY = (
        b"ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        b"element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 2.5 0\n3 0 1 2\n"
    )

    def test_a_mesh_is_arrays_with_numpy_and_lists_without(self):
        mesh = coapt.Mesh.from_ply(self.PLY)
        self.assertEqual([list(row) for row in mesh.vertices_mm], [[0, 0, 0], [1, 0, 0], [0, 2.5, 0]])
        self.assertEqual([list(row) for row in mesh.faces], [[0, 1, 2]])
        self.assertEqual(hasattr(mesh.faces, "shape"), coapt.meshes.numpy is not None)

    def test_a_mesh_that_breaks_off_is_refused(self):
        for content in (b"", self.PLY[:-8], self.PLY.replace(b"ascii", b"binary_little_endian")):
            with self.assertRaises(ValueError):
                coapt.Mesh.from_ply(content)


if __name__ == "__main__":
    unittest.main()
