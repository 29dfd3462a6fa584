"""`coapt export`, and `coapt valve import --slicerheart`, which reads a folder of it back."""

import json
import unittest

from programs import BAD_INPUT, FAILURE, ProgramTest, coapt

PLAN = {
    "schema": "coapt.plan/1",
    "steps": [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": 32}],
}
STARTS = {
    "glb": b"glTF",
    "vtk": b"# vtk DataFile Version 4.2\n",
    "ply": b"ply\n",
    "obj": b"# coapt",
    "stl": b"coapt",
    "mrk.json": b"{",
    "csv": b"Metric,Value,Unit",
    "feb": b"<?xml",
}


class Export(ProgramTest):
    def test_the_end_of_a_name_says_the_format_and_several_are_written_at_once(self):
        files = {format: self.folder / f"valve.{format}" for format in STARTS}
        self.run_ok(
            "export",
            "human-normal",
            *(part for file in files.values() for part in ("-o", file)),
        )
        for format, start in STARTS.items():
            self.assertTrue(files[format].read_bytes().startswith(start), format)

    def test_a_name_that_says_nothing_is_a_usage_error_that_lists_the_formats(self):
        result = coapt("export", "human-normal", "-o", self.folder / "valve.xyz")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("glb, vtk, ply", result.stderr + result.stdout)

    def test_what_cannot_be_written_fails_before_anything_is_closed(self):
        result = coapt("export", "human-normal", "-o", self.folder / "no/such/valve.glb")
        self.assertEqual(result.returncode, FAILURE)

    def test_a_plan_leaves_its_ring_among_the_markups(self):
        plan, file = self.write("plan.json", PLAN), self.folder / "repaired.mrk.json"
        self.run_ok("export", "human-functional-mr", "--plan", plan, "-o", file)
        names = [markup["name"] for markup in json.loads(file.read_text())["markups"]]
        self.assertIn("ring: generic-classic, size 32 mm", names)

    def test_ties_that_a_file_cannot_hold_are_said_not_to_be_kept(self):
        clip = {"step": "edge_to_edge", "device": "clip", "along": 0.5, "width_mm": 6}
        plan = self.write("plan.json", {"schema": "coapt.plan/1", "steps": [clip]})
        outputs = [
            f"{self.folder}/model/",
            *(f"{self.folder}/valve.{name}" for name in ("stl", "glb", "feb")),
        ]
        files = [part for output in outputs for part in ("-o", output)]
        said = self.run_ok("export", "human-normal", "--plan", plan, *files).stderr.splitlines()
        self.assertEqual(
            [line for line in said if "edge-to-edge" in line],
            ["coapt: export: .stl files do not store the edge-to-edge repair; a valve imported from one lacks it"],
        )
        self.assertEqual(self.run_ok("export", "human-normal", "-o", outputs[1]).stderr, "")

    def test_a_wrong_plan_is_named_with_its_pointer(self):
        plan = self.write(
            "plan.json",
            {
                "schema": "coapt.plan/1",
                "steps": [{"step": "annuloplasty", "shape": "no"}],
            },
        )
        result = coapt("export", "human-normal", "--plan", plan, "-o", self.folder / "valve.glb")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("plan.json: /steps/0", result.stderr)

    def test_measurements_are_not_of_an_open_valve(self):
        result = coapt("export", "human-normal", "--open", "-o", self.folder / "valve.csv")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("closed valve", result.stderr)

    def test_a_valve_goes_out_and_in_and_closes_alike(self):
        again = self.folder / "again.json"
        self.run_ok("export", "human-normal", "--open", "-o", f"{self.folder}/model/")
        self.run_ok(
            "valve",
            "import",
            "--slicerheart",
            self.folder / "model",
            "--name",
            "again",
            "-o",
            again,
        )
        self.run_ok("valve", "check", again)
        before, after = (json.loads(self.run_ok("close", valve, "--json").stdout) for valve in ("human-normal", again))
        self.assertEqual(after["status"], "converged")
        self.assertAlmostEqual(after["leak_mm2"], before["leak_mm2"], delta=3)

    def test_a_folder_of_another_valve_is_not_mixed_with_this_one(self):
        self.run_ok("export", "human-normal", "-o", f"{self.folder}/model/")
        result = coapt("export", "human-normal", "--open", "-o", f"{self.folder}/model/")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("model/measurements.csv is left from an earlier export", result.stderr)

    def test_a_folder_with_problems_is_refused_with_all_of_them(self):
        self.run_ok("export", "human-normal", "--open", "-o", f"{self.folder}/model/")
        (self.folder / "model/Chords_mesh.vtk").write_text("# vtk DataFile Version 4.2\nt\nBINARY\n")
        (self.folder / "model/annulus.mrk.json").write_text("{}")
        result = coapt("valve", "import", "--slicerheart", self.folder / "model", "-o", "-")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("Chords_mesh.vtk", result.stderr)
        self.assertIn("annulus.mrk.json/@schema", result.stderr)

    def test_a_folder_without_chordae_gets_drawn_ones_on_its_tips(self):
        self.run_ok("export", "human-functional-mr", "--open", "-o", f"{self.folder}/model/")
        for chords in (self.folder / "model").glob("Chords*"):
            chords.unlink()
        folder = ["valve", "import", "--slicerheart", self.folder / "model"]
        result = coapt(*folder, "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--chordae synthesise", result.stderr)
        drawn = [
            json.loads(self.run_ok(*folder, "--chordae", "synthesise", "--seed", seed, "-o", "-").stdout)
            for seed in ("1", "1", "2")
        ]
        self.assertEqual(drawn[0], drawn[1])
        self.assertNotEqual(drawn[0]["chordae"], drawn[2]["chordae"])
        self.assertEqual(drawn[2]["drawn_chordae"], {"seed": 2, "tips_given": True})
        told = json.loads(
            self.run_ok(
                *folder,
                "--chordae",
                "synthesise",
                "--json",
                "-o",
                self.folder / "v.json",
            ).stdout
        )
        self.assertEqual(told["schema"], "coapt.import/2")
        self.assertEqual(
            [decision["subject"] for decision in told["decisions"]][:4],
            ["units", "frame", "leaflets", "state"],
        )
        self.assertEqual(json.loads((self.folder / "v.json").read_text()), drawn[0])
        self.assertEqual(
            coapt(*folder, "--chordae", "synthesise", "--json", "-o", "-").returncode,
            BAD_INPUT,
        )
        valve = self.write("drawn.json", json.dumps(drawn[0]))
        self.assertEqual(
            json.loads(self.run_ok("close", valve, "--json").stdout)["status"],
            "converged",
        )
        for options in (["--chordae", "chordae.csv"], ["--tips", "tips.csv"]):
            self.assertEqual(coapt(*folder, *options, "-o", "-").returncode, BAD_INPUT)

    def test_import_needs_either_a_folder_or_all_parts(self):
        result = coapt("valve", "import", "--leaflet", "a.obj", "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--chordae is required", result.stderr)
        result = coapt("valve", "import", "--slicerheart", self.folder / "none", "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)


if __name__ == "__main__":
    unittest.main()
