"""From a segmentation below ProbeToRAS to plans and back: what is sent, where it comes back, what is said."""

import json
import unittest

import numpy
from process_runs import wait_until
from programs import SOURCE
from slicer_runs import COARSE, SMALL, Asked, SlicerTest, case, example, probe_to_ras, read_nrrd, service

ENTRY = "SlicerHeart segmentation category and type~SCT^91134007^Mitral Valve~SlicerHeart^{}^{}~^^~Anatomic codes~^^~^^"


def boxes(*corners, shape=(30, 20, 10), **more):
    """A segmentation of boxes, each (first, last) in i, j, k, on voxels of 1 x 2 x 3 mm."""
    segments = []
    for i, (low, high) in enumerate(corners):
        mask = numpy.zeros(shape[::-1], numpy.uint8)
        mask[low[2] : high[2] + 1, low[1] : high[1] + 1, low[0] : high[0] + 1] = 7
        segments.append(case.Segment(f"part {i}", mask, id=f"Segment_{i}"))
    return case.Segmentation(segments, numpy.diag([1.0, 2.0, 3.0, 1.0]), **more)


class Maps(Asked):
    def test_what_is_sent_is_cropped_and_lies_where_it_was_drawn(self):
        turn = numpy.eye(4)
        turn[:3] = [[0, -1, 0, 100], [1, 0, 0, 200], [0, 0, 1, 300]]
        sent = boxes(((10, 5, 4), (12, 6, 4)), to_world=turn).cropped()
        labels, to_lps, _ = read_nrrd(sent.nrrd())
        # 15 mm of margin are 15, 8 and 5 voxels.
        self.assertEqual(labels.shape[::-1], (3 + 30, 2 + 16, 1 + 10))
        self.assertEqual([sorted(set(axis)) for axis in numpy.argwhere(labels)[:, ::-1].T], [[15, 16, 17], [8, 9], [5]])
        # Voxel 10, 5, 4 is at RAS 10, 10, 12 below the transform, at 90, 210, 312 in the world, at -90, -210, 312 in LPS.
        numpy.testing.assert_allclose(to_lps @ [15, 8, 5, 1], [-90, -210, 312, 1])
        self.assertEqual(sent.grid()["size"], [33, 18, 11])
        numpy.testing.assert_allclose(sent.grid()["to_lps_mm"], to_lps[:3])

    def test_segments_that_overlap_have_layers(self):
        one, other = ((2, 2, 2), (6, 6, 6)), ((4, 4, 4), (8, 8, 8))
        labels, to_lps, lines = read_nrrd(boxes(one, other, ((20, 2, 2), (21, 2, 2))).cropped().nrrd())
        self.assertEqual([sorted(set(layer.flat)) for layer in labels], [[0, 1, 3], [0, 2]])
        self.assertEqual([int((labels == number).sum()) for number in (1, 2, 3)], [125, 125, 2])
        self.assertIn("kinds: domain domain domain list", lines)
        self.assertIn("Segment1_Layer:=1", lines)

    def test_slicerhearts_terms_tell_leaflets_and_leave_the_rest_out(self):
        given = boxes(*[((2 * i, 0, 0), (2 * i, 1, 1)) for i in range(5)])
        given.segments[1].entry = ENTRY.format("sh-leaflet-mv-p", "mitral posterior leaflet")
        given.segments[2].entry = ENTRY.format("sh-leaflet-mv-a", "mitral anterior leaflet")
        given.segments[3].name, given.segments[4].id = "Annulus ring", case.VALVE_MASK
        taken = case.Case()
        taken.take(given)
        self.assertEqual([segment.name for *_, segment in taken.map.numbers], ["part 1", "part 2", "Annulus ring"])
        self.assertEqual(taken.roles, {1: "posterior", 2: "anterior"})
        given.segments[1].entry = ENTRY.format("sh-leaflet-tv-s", "tricuspid septal leaflet")
        with self.assertRaisesRegex(service.Trouble, "leaflet of another valve"):
            case.Case().take(given)

    def test_a_drawn_map_comes_back_below_the_transform_in_slicerhearts_terms(self):
        sent = boxes(((10, 5, 4), (12, 6, 4)), to_world=probe_to_ras()).cropped()
        head = ["NRRD0004", "type: unsigned char", "dimension: 3", "space: left-posterior-superior"]
        head += [
            "sizes: 33 18 11",
            "space directions: (9,0,0) (0,9,0) (0,0,9)",
            "encoding: gzip",
            "space origin: (1,2,3)",
        ]
        content = "\n".join([*head, "", ""]).encode() + sent.nrrd().split(b"\n\n", 1)[1]
        labels, to_lps, lines = read_nrrd(sent.placed(content))
        self.assertEqual(int((labels == 1).sum()), 6)
        numpy.testing.assert_allclose(case.FLIP @ to_lps @ [15, 8, 5, 1], [10, 10, 12, 1], atol=1e-9)
        self.assertEqual(
            [line.split("^")[3] for line in lines if "_Tags:=" in line], ["sh-leaflet-mv-a", "sh-leaflet-mv-p"]
        )

    def test_curves_and_tips_are_tables_in_lps(self):
        self.assertEqual(case.annulus_file([(1, 2, 3)] * 3)["text"], "x,y,z\n" + 3 * "-1.0,-2.0,3.0\n")
        labels = ("AL", "PM-2", "antero-lateral", "Posteromedial tip")
        rows = case.tips_file(labels, [(1, 2, 3)] * 4)["text"].splitlines()
        self.assertEqual([row.split(",")[0] for row in rows[1:]], ["AL", "PM", "AL", "PM"])
        self.assertEqual(rows[1], "AL,-1.0,-2.0,3.0")
        with self.assertRaisesRegex(service.Trouble, '"F-1" must be labelled AL or PM'):
            case.tips_file(["F-1"], [(1, 2, 3)])
        with self.assertRaisesRegex(service.Trouble, "no points"):
            case.annulus_file([])

    def test_what_cannot_be_sent_is_said(self):
        with self.assertRaisesRegex(service.Trouble, "empty"):
            boxes().cropped() if boxes().segments else case.Segmentation([], numpy.eye(4)).cropped()
        with self.assertRaisesRegex(service.Trouble, "no coapt.valve file"):
            case.Case().take_valve([1])
        self.assertIn("There is no valve yet", self.trouble(case.Case().closing(service.Service("http://localhost"))))

    def test_what_a_person_says_outlives_a_new_reading_of_the_same_segments(self):
        given, taken = boxes(((2, 2, 2), (3, 3, 3)), ((8, 8, 2), (9, 9, 3))), case.Case()
        taken.take(given)
        taken.say("label 1", "posterior")
        taken.say("flip", True)
        taken.take(given, again=True)
        self.assertEqual((taken.roles, taken.says), ({1: "posterior"}, {"flip": True}))
        taken.say("flip", None)
        self.assertEqual(taken.says, {})
        taken.say("label 2", "posterior")  # then it is two labels that make it
        self.assertEqual(taken.roles, {1: "posterior", 2: "posterior"})
        taken.take(given)
        self.assertEqual(taken.roles, {})


class Flow(SlicerTest):
    def imported(self, *arguments, **named):
        taken = case.Case()
        taken.take(*arguments, **named)
        taken.says.update(COARSE)
        service.waited(taken.importing(self.service))
        return taken

    def test_the_example_below_a_transform_comes_to_plans_files_and_a_report(self):
        taken = self.imported(example(probe_to_ras()))
        looks = [look for *_, look in taken.decisions()]
        self.assertEqual(looks, sorted(looks, reverse=True))
        self.assertIn("label 3 is the annulus", [value for _, value, *_ in taken.decisions()])
        self.assertEqual([control.value for control in taken.controls()[:3]], list(case.PARTS))
        shown = service.waited(taken.closing(self.service))
        self.assertRegex(shown.words(), r"^Leak \d+\.\d ± \d+\.\d mm²$")
        self.assertEqual([kind for kind, *_ in shown.markups], ["ClosedCurve", "Fiducial", "Fiducial"])

        plans = service.waited(taken.planning(self.service, **SMALL))
        (row,) = taken.rows()
        self.assertEqual((row[0], row[1]), ("1", "; ".join(plans[0]["description"]) or "no repair"))
        repaired = service.waited(taken.closing(self.service, plans[0]["plan"]))
        labels, to_lps, lines = read_nrrd(repaired.labels)
        self.assertEqual(set(labels.flat), {0, 1, 2, 3})
        self.assertEqual(list(labels.shape), list(taken.map.layers[0].shape))
        # On the voxels of the segmentation itself, below its transform.
        steps = numpy.linalg.inv(example().ijk_to_local) @ case.FLIP @ to_lps
        numpy.testing.assert_allclose(steps[:3, :3], numpy.eye(3), atol=1e-6)
        numpy.testing.assert_allclose(steps[:3, 3], numpy.rint(steps[:3, 3]), atol=1e-4)
        self.assertTrue(service.waited(taken.reporting(self.service)).startswith(b"<!DOCTYPE html>"))

    def test_curve_tips_and_phase_are_taken(self):
        given = example(probe_to_ras())
        loop = numpy.loadtxt(
            SOURCE / "examples/valves/source/bodyparts3d/annulus_centerline.csv", delimiter=",", usecols=(0, 1, 2)
        )
        local = case.moved(loop, case.FLIP)
        world = case.moved(local, given.to_world)
        del given.segments[2]
        tips = [(-9.0, -3.0, -25.0), (9.0, -3.0, -25.0)]  # of the map, in LPS
        tips_world = case.moved(case.moved(tips, case.FLIP), given.to_world)
        taken = self.imported(
            given, case.annulus_file(world), case.tips_file(["AL", "Postero-medial"], tips_world), closed=False
        )
        self.assertNotIn("found along", " ".join(value for _, value, *_ in taken.decisions()))
        self.assertTrue(taken.valve["drawn_chordae"]["tips_given"])
        markups = {name: places for _, name, _, places in service.waited(taken.closing(self.service)).markups}
        near = [numpy.linalg.norm(local - point, axis=1).min() for point in markups["annulus"]]
        self.assertLess(max(near), 2.0)  # points of the loop are 1.9 mm apart
        # Three heads of a muscle are drawn about the tip that was given.
        heads = markups["papillary muscle tips"].reshape(2, 3, 3).mean(axis=1)
        numpy.testing.assert_allclose(heads, case.moved(tips, case.FLIP), atol=0.5)

    def test_a_control_makes_the_valve_anew(self):
        taken = self.imported(example())
        taken.say("label 1", "posterior")
        self.assertEqual(taken.roles, {1: "posterior", 2: "anterior", 3: "annulus"})
        said = self.trouble(taken.importing(self.service))
        self.assertIn("anterior", said)  # it does not look so
        taken.say("trust_labels", True)
        service.waited(taken.importing(self.service))
        self.assertEqual([one["part"] for one in taken.imported["labels"]], ["posterior", "anterior", "annulus"])

    def test_a_segmentation_without_leaflets_is_refused_in_words(self):
        given = example()
        given.segments = given.segments[2:]
        taken = case.Case()
        taken.take(given)
        said = self.trouble(taken.importing(self.service))
        self.assertRegex(said, 'no label is named as the anterior leaflet(.|\n)*Of the labels 1 is "Annulus"[.]')
        given = example(names=("Septal leaflet", "Tricuspid anterior", "Annulus"))
        taken.take(given)
        self.assertRegex(self.trouble(taken.importing(self.service)), "has a label named as a leaflet of another valve")

    def test_a_cancelled_search_ends_with_its_best_or_says_that_there_is_none(self):
        taken = case.Case()
        taken.take_valve(json.loads(self.server.ask("GET", "/v1/presets/human-functional-mr").body))
        for closures in (0, 30):
            task = service.Task(taken.planning(self.service, **{**SMALL, "evaluations": 50000}))
            self.until(task, lambda: closures < self.closures(task.said))
            task.cancel()
            self.until(task, lambda: task.ended)
            if task.error:
                self.assertEqual(str(task.error), "The search was cancelled before it had a plan.")
            else:
                self.assertTrue(task.result)
        self.assertEqual(taken.job["state"], "CANCELLED")

    def test_a_cancelled_import_leaves_no_valve(self):
        taken = case.Case()
        taken.take(example())
        task = service.Task(taken.importing(self.service))
        task.poll()
        task.cancel()
        self.until(task, lambda: task.ended)
        self.assertIn("ancelled", str(task.error))
        self.assertIsNone(taken.valve)

    def until(self, task, condition):
        wait_until(lambda: condition() or task.poll())

    @staticmethod
    def closures(said):
        found = [word for word in said.split() if word.isdigit()]
        return int(found[0]) if found else -1


if __name__ == "__main__":
    unittest.main()
