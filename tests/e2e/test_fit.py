"""`coapt fit`: a valve fitted to its closed state as imaged."""

import json
import unittest

from programs import BAD_INPUT, NOT_CLOSED, ProgramTest, coapt


class Fit(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.mesh = ["--triangles", "150"]

    def displaced(self):
        """The valve as given, and the closed leaflets of the same with its tips elsewhere."""
        given, truth = self.folder / "given.json", self.folder / "truth.json"
        self.run_ok("valve", "make", "human-functional-mr", *self.mesh, "-o", given)
        self.run_ok("valve", "remodel", given, "--displace-al", "1,0,1.5", "-o", truth)
        closed = self.folder / "closed.ply"
        self.run_ok("export", truth, "--frame", "valve", "-o", closed)
        return given, truth, closed

    def test_tips_are_found_and_the_fitted_valve_closes_onto_the_surface(self):
        given, truth, closed = self.displaced()
        fitted, picture = self.folder / "fitted.json", self.folder / "map.png"
        options = [
            "--side",
            "middle",
            "--known",
            "slack",
            "prestretch",
            "stiffness",
            "hidden",
            "-o",
            fitted,
            "--map",
            picture,
        ]
        found = json.loads(self.run_ok("fit", given, "--closed", closed, *options, "--json").stdout)
        self.assertEqual(found["schema"], "coapt.fit/1")
        self.assertLess(found["rms_mm"], 0.05)
        self.assertGreater(found["rms_before_mm"], 0.3)
        values = {p["name"]: p for p in found["parameters"]}
        self.assertAlmostEqual(values["tip_AL_x"]["value"], -1.0, delta=0.15)
        self.assertAlmostEqual(values["tip_AL_z"]["value"], -1.5, delta=0.15)
        self.assertTrue(values["tip_AL_z"]["identifiable"])
        self.assertEqual(len(found["correlations"]), len(found["parameters"]))
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
        near = json.loads(self.run_ok("compare", fitted, truth, "--json").stdout)
        self.assertLess(near["rms_mm"], 0.1)
        self.assertIn("fitted to closed.ply", json.loads(fitted.read_text())["provenance"][-1])
        uncertain = json.loads(fitted.read_text())["fit"]
        self.assertEqual(uncertain["parameters"], list(values))
        self.assertAlmostEqual(uncertain["covariance"][2][2] ** 0.5, values["tip_AL_z"]["sd"], delta=1e-9)
        again = self.folder / "again.json"
        options[options.index(fitted)] = again
        self.run_ok("fit", given, "--closed", closed, *options, "--threads", "1")
        self.assertEqual(fitted.read_bytes(), again.read_bytes())

    def test_ruptured_chordae_are_found_and_told(self):
        torn, whole = self.folder / "torn.json", self.folder / "whole.json"
        self.run_ok("valve", "make", "human-p2-prolapse", *self.mesh, "-o", torn)
        valve = json.loads(torn.read_text())
        for chorda in valve["chordae"]:
            chorda["ruptured"] = False
        whole.write_text(json.dumps(valve))
        closed, fitted = self.folder / "closed.ply", self.folder / "fitted.json"
        self.run_ok("export", torn, "--frame", "valve", "-o", closed)
        options = ["--side", "middle", "--known", "tips", "prestretch", "stiffness", "hidden", "-o", fitted]
        found = json.loads(coapt("fit", whole, "--closed", closed, *options, "--ruptured", "--json").stdout)
        taken = [of["name"] for of in found["hypotheses"] if of["taken"]]
        self.assertEqual(taken, ["ruptured_P2"])
        self.assertEqual(found["hypotheses"][0]["name"], "intact")
        self.assertGreater(found["hypotheses"][0]["rms_mm"], found["rms_mm"])
        self.assertEqual(found["hypotheses_left_out"], [])
        valve = json.loads(fitted.read_text())
        self.assertIn("marginal chordae of P2 assumed ruptured", valve["provenance"][-1])
        self.assertEqual(sum(chorda["ruptured"] for chorda in valve["chordae"]), 2)
        table = coapt("fit", whole, "--closed", closed, *options, "--ruptured", "--rounds", "1").stdout
        self.assertRegex(table, r"ruptured_P2 .* selected")
        without = coapt("fit", whole, "--closed", closed, *options, "--rounds", "1", "--json").stdout
        self.assertNotIn("hypotheses", json.loads(without))

    def test_points_without_triangles_and_a_table_for_people(self):
        given, _, closed = self.displaced()
        points = self.folder / "points.csv"
        rows = closed.read_text(encoding="latin-1").split("end_header\n")[1].splitlines()
        points.write_text("\n".join(",".join(row.split()[:3]) for row in rows if len(row.split()) != 4))
        run = self.run_ok(
            "fit",
            given,
            "--closed",
            points,
            "--side",
            "middle",
            "--leak",
            "40",
            "--rounds",
            "30",
            "--known",
            "slack",
            "prestretch",
            "stiffness",
            "hidden",
            "-o",
            self.folder / "f.json",
        )
        self.assertIn("tip_AL_x, mm", run.stdout)
        self.assertIn("(given: 40.0 ± 3.0)", run.stdout)

    def test_a_fit_that_is_cut_short_says_so(self):
        given, _, closed = self.displaced()
        run = coapt("fit", given, "--closed", closed, "--rounds", "1", "-o", self.folder / "f.json")
        self.assertEqual(run.returncode, NOT_CLOSED)
        self.assertIn("stopped before convergence (--rounds)", run.stdout)
        timed = coapt("fit", given, "--closed", closed, "--seconds", "0.1", "--json", "-o", self.folder / "f.json")
        self.assertEqual(timed.returncode, NOT_CLOSED)
        self.assertEqual(json.loads(timed.stdout)["stop"], "time_limit")

    def test_what_cannot_be_fitted_is_refused(self):
        given, _, closed = self.displaced()
        away = self.write("away.csv", "\n".join(f"{200 + i % 20},{i // 20},0" for i in range(400)))
        few = self.write("few.csv", "0,0,0\n1,0,0\n2,0,0\n0,1,0\n1,1,0\n2,1,0\n0,2,0\n1,2,0\n")
        output = ["-o", self.folder / "f.json"]
        for arguments, words in (
            (["--closed", away], "--closed: is 1"),
            (["--closed", few], "must be at least 100"),
            (["--closed", given], "must end in one of"),
            (["--closed", closed, "--frame", "patient"], "/patient_frame: is missing"),
            (
                ["--closed", closed, "--known", "slack", "tips", "prestretch", "stiffness", "hidden"],
                "--known: excludes every parameter",
            ),
            (["--closed", closed, "--leak", "nan"], "--leak"),
        ):
            run = coapt("fit", given, *arguments, *output)
            self.assertEqual(run.returncode, BAD_INPUT, arguments)
            self.assertIn(words, run.stderr)
        self.assertFalse((self.folder / "f.json").exists())


if __name__ == "__main__":
    unittest.main()
