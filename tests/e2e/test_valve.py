"""coapt valve make | import | check | info | remodel."""

import json
import subprocess
import unittest

import jsonschema
from process_runs import HANGS_S
from programs import BAD_INPUT, COAPT, FAILURE, OK, SOURCE, ProgramTest, coapt

PRESETS = [f"porcine-{i}" for i in range(1, 6)] + ["human-normal", "human-functional-mr", "human-p2-prolapse"]
PRESETS += ["barlow", "fibroelastic-flail", "marfan", "secondary-mr", "hypertrophic"]


class CommandLine(ProgramTest):
    def test_help_goes_to_stdout_and_tells_the_exit_codes_and_examples(self):
        result = self.run_ok("--help")
        self.assertIn("Exit codes: 0", result.stdout)
        self.assertIn("Examples:", result.stdout)
        self.assertEqual(result.stderr, "")

    def test_every_command_has_help_with_an_example(self):
        for command in [
            "valve make",
            "valve import",
            "valve check",
            "valve info",
            "valve remodel",
            "valve calibrate",
            "close",
            "evaluate",
            "plan",
        ]:
            with self.subTest(command):
                help_text = self.run_ok(*command.split(), "--help").stdout
                self.assertIn("Example", help_text)
                self.assertIn(f"  coapt {command} ", help_text)

    def test_version_carries_the_research_notice(self):
        self.assertIn("research software, not a medical device", self.run_ok("--version").stdout)

    def test_wrong_usage_is_2_with_nothing_on_stdout(self):
        for arguments in [
            [],
            ["fly"],
            ["close"],
            ["close", "human-normal", "--method", "magic"],
            ["plan", "human-normal", "--evaluations", "0"],
            ["valve", "make", "no-such-preset", "-o", "-"],
            ["valve", "make", "human-normal", "--ap-mm", "30", "-o", "-"],
        ]:
            with self.subTest(arguments):
                result = coapt(*arguments)
                self.assertEqual(result.returncode, BAD_INPUT)
                self.assertEqual(result.stdout, "")
                self.assertNotEqual(result.stderr, "")

    def test_an_unknown_command_is_named(self):
        for arguments in [["fly"], ["valve", "fly"]]:
            self.assertIn("unknown: fly", coapt(*arguments).stderr)

    def test_numbers_are_whole_and_in_range_and_their_option_is_named(self):
        for option, values in {
            "--evaluations": ["0", "abc", "1e3", "12x", "9" * 30],
            "--seed": ["-1", "18446744073709551616", "1.5"],
            "--seconds": ["nan", "inf", "-1", "1000001"],
        }.items():
            for value in values:
                with self.subTest(option + value):
                    result = coapt("plan", "human-normal", option, value)
                    self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
                    self.assertIn(f"{option}: is {value}, must be a", result.stderr)

    PRINTING = [
        "--help",
        "--version",
        "valve info human-normal",
        "valve check human-normal --json",
        "valve make human-normal -o -",
        "close human-normal --json",
    ]

    def test_a_result_that_is_lost_is_1_and_said(self):
        for command in self.PRINTING:
            for redirection in [">/dev/full", ">&-"]:
                with self.subTest(command + redirection):
                    result = subprocess.run(
                        f"exec '{COAPT}' {command} {redirection}",
                        shell=True,
                        stderr=subprocess.PIPE,
                        text=True,
                        timeout=HANGS_S,
                    )
                    self.assertEqual(result.returncode, FAILURE)
                    self.assertEqual(result.stderr, "coapt: standard output: cannot be written\n")

    def test_without_standard_output_files_hold_nothing_else(self):
        picture = self.folder / "closed.png"
        subprocess.run(
            f"exec '{COAPT}' close human-normal --render '{picture}' >&-",
            shell=True,
            stderr=subprocess.DEVNULL,
            timeout=HANGS_S,
        )
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


class Make(ProgramTest):
    def test_presets_are_listed_with_what_they_are(self):
        listed = json.loads(self.run_ok("presets", "--json").stdout)["presets"]
        self.assertIn("human-functional-mr", [preset["name"] for preset in listed])
        text = self.run_ok("presets").stdout
        for preset in listed:
            self.assertEqual(set(preset), {"name", "group", "title", "about"})
            self.assertIn(f"{preset['name']}: {preset['title']}. {preset['about']}\n", text)

    def test_every_preset_passes_check_and_its_schema(self):
        schema = json.loads((SOURCE / "io/schema/valve.schema.json").read_text())
        validator = jsonschema.Draft202012Validator(schema)
        for preset in PRESETS:
            with self.subTest(preset):
                path = self.make(preset)
                result = self.run_ok("valve", "check", path, "--json")
                self.assertEqual(json.loads(result.stdout), {"problems": []})
                validator.validate(json.loads(path.read_text()))

    def test_triangles_are_about_as_many_as_asked_for(self):
        path = self.make("human-normal", "--triangles", 2600)
        info = json.loads(self.run_ok("valve", "info", path, "--json").stdout)
        self.assertAlmostEqual(info["triangles"], 2600, delta=260)

    def test_dimensions_make_a_valve_of_these_dimensions(self):
        path = self.folder / "valve.json"
        self.run_ok("valve", "make", "--ap-mm", "31", "--al-pm-mm", "41", "--name", "mine", "-o", path)
        info = json.loads(self.run_ok("valve", "info", path, "--json").stdout)
        self.assertEqual(info["name"], "mine")
        self.assertAlmostEqual(info["saddle_to_mid_posterior_mm"], 31.0, delta=2.0)

    def test_a_slack_or_a_tissue_outside_its_range_is_named_with_what_is_accepted(self):
        result = coapt("valve", "make", "--strut-slack", "3", "--radial-extension", "-1", "-o", "-")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn(" --strut-slack: is 3, must be from 0.6 to 2", result.stderr)
        self.assertIn(" --radial-extension: is -1, must be from 0 to 0.4", result.stderr)

    def test_a_file_of_dimensions_makes_a_diseased_valve_with_the_healthy_ones_chordae(self):
        healthy = {"schema": "coapt.dimensions/1", "dimensions": {"strut_slack": 0.9, "triangles": 300}}
        sick = healthy | {"name": "sick", "remodelling": {"ap_dilation_percent": 15, "ruptured": ["P2"]}}
        valves = []
        for given in (healthy, sick):
            path = self.folder / "dimensions.json"
            path.write_text(json.dumps(given))
            valves.append(json.loads(self.run_ok("valve", "make", "--dimensions", path, "-o", "-").stdout))
        lengths = [[s["rest_length_mm"] for c in v["chordae"] for s in c["segments"]] for v in valves]
        self.assertEqual(lengths[0], lengths[1])
        self.assertEqual(valves[1]["name"], "sick")
        self.assertEqual(sum(c["ruptured"] for c in valves[1]["chordae"]), 2)
        path.write_text(json.dumps(sick | {"dimensions": {"ap_mm": 1, "al_pm": 30}}))
        result = coapt("valve", "make", "--dimensions", path, "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("/dimensions/ap_mm: is 1, must be from 8 to 80 mm", result.stderr)
        self.assertIn("/dimensions/al_pm", result.stderr)

    def test_an_impossible_dimension_is_named(self):
        result = coapt("valve", "make", "--ap-mm", "-3", "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn(" --ap-mm: ", result.stderr)
        self.assertEqual(result.stdout, "")

    def test_measured_skeletons_with_default_leaflets_close_like_healthy_valves(self):
        kaiser = SOURCE / "examples/valves/source/kaiser"
        # The tips of the second lie 20 mm behind the centre: leaflets of human proportions leave 16 mm2 open, and
        # lateral ones of 20 mm have two closed states, 14 mm2 apart.
        slack = [
            word
            for group in ("anterior", "posterior", "commissural", "strut", "basal")
            for word in (f"--{group}-slack", "0.9")
        ]
        taller = (*slack, "--lateral-height-mm", "24", "--commissure-height-mm", "10")
        for ring, tips, more in [
            ("normal_1_annulus", "normal_1_papillary", ()),
            ("hcm_d_annulus_early_systole", "hcm_d_papillary_early_systole", taller),
        ]:
            with self.subTest(ring):
                path = self.folder / f"{ring}.json"
                self.run_ok(
                    "valve",
                    "make",
                    "--annulus",
                    kaiser / f"{ring}.csv",
                    "--tips",
                    kaiser / f"{tips}.csv",
                    *more,
                    "-o",
                    path,
                )
                closed = json.loads(self.run_ok("close", path, "--json").stdout)
                self.assertEqual(closed["status"], "converged")
                self.assertFalse(closed["crossing"])
                self.assertLess(closed["leak_mm2"], 1.0)
                self.assertGreater(closed["tenting_height_mm"], 2.0)
                self.assertTrue(all(s["contact"] for s in closed["coaptation"]["sections"]))

    def test_an_annulus_in_place_of_the_tips_is_refused_at_once(self):
        ring = SOURCE / "examples/valves/source/kaiser/normal_1_annulus.csv"
        result = coapt("valve", "make", "--annulus", ring, "--tips", ring, "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--tips", result.stderr)
        self.assertEqual(result.stdout, "")

    def test_an_output_that_cannot_be_written_is_1(self):
        result = coapt("valve", "make", "human-normal", "-o", "/nowhere/valve.json")
        self.assertEqual(result.returncode, FAILURE)
        self.assertIn("/nowhere/valve.json", result.stderr)


class Calibrate(ProgramTest):
    FILE = {
        "schema": "coapt.calibration/1",
        "dimensions": {"strut_slack": 1.1, "anterior_slack": 1.15},
        "valves": {
            "well": {"kind": "healthy"},
            "sick": {"kind": "functional", "remodelling": {"ap_dilation_percent": 18}},
        },
        "unknowns": [{"at": ["/dimensions/strut_slack"], "low": 0.85, "high": 1.2}],
        "targets": [{"valve": "well", "quantity": "strut", "low": 1, "high": 3}],
    }

    def calibrate(self, file, *arguments):
        path = self.folder / "given.json"
        path.write_text(json.dumps(file))
        return coapt("valve", "calibrate", path, "-o", self.folder / "found", *arguments)

    def test_writes_the_valves_found_and_their_rows_before_and_after(self):
        result = self.calibrate(self.FILE, "--evaluations", "1", "--json")
        self.assertEqual(result.returncode, OK, result.stderr)
        told = json.loads(result.stdout)
        self.assertEqual((told["schema"], told["stop"]), ("coapt.calibration_result/1", "evaluation_limit"))
        self.assertLess(told["cost"], told["cost_before"])
        rows = {row["quantity"]: row for row in told["valves"]["well"]["rows"]}
        before = {row["quantity"]: row for row in told["valves"]["well"]["rows_before"]}
        self.assertGreater(rows["strut"]["value"], before["strut"]["value"])
        found = json.loads((self.folder / "found/calibration.json").read_text())
        well = json.loads((self.folder / "found/well.json").read_text())
        self.assertEqual(found["dimensions"]["strut_slack"], well["dimensions"]["strut_slack"])
        self.assertEqual(found["targets"], self.FILE["targets"])
        self.run_ok("valve", "make", "--dimensions", self.folder / "found/sick.json", "-o", self.folder / "sick.json")

    def test_a_bad_file_is_2_and_every_problem_has_its_place(self):
        bad = self.FILE | {
            "unknowns": [{"at": ["/dimensions/nothing"], "low": 0, "high": 1}],
            "targets": [{"valve": "well", "quantity": "strut"}, {"valve": "nobody", "quantity": "leek"}],
        }
        result = self.calibrate(bad)
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        for place in ["/unknowns/0/at/0", "/targets/0", "/targets/1/valve", "/targets/1/quantity"]:
            self.assertIn(f" {place}: ", result.stderr)


class Check(ProgramTest):
    def check(self, valve):
        result = coapt("valve", "check", "-", "--json", stdin=json.dumps(valve))
        problems = json.loads(result.stdout)["problems"]
        self.assertEqual(result.returncode, BAD_INPUT if problems else OK)
        return {problem["path"]: problem["message"] for problem in problems}

    def setUp(self):
        super().setUp()
        self.valve = json.loads(self.run_ok("valve", "make", "human-normal", "-o", "-").stdout)

    def test_a_preset_read_from_stdin_has_no_problem(self):
        self.assertEqual(self.check(self.valve), {})

    def test_problems_are_all_listed_with_their_pointers(self):
        self.valve["pressure_kpa"] = -1
        self.valve["surprise"] = 1
        del self.valve["faces"]
        problems = self.check(self.valve)
        self.assertIn("/pressure_kpa", problems)
        self.assertIn("/surprise", problems)
        self.assertTrue(any(path in ("/faces", "") for path in problems), problems)

    def test_an_index_out_of_range_is_pointed_at(self):
        self.valve["faces"][3][1] = 1000000
        self.assertTrue(any(path.startswith("/faces/3") for path in self.check(self.valve)))

    def test_deep_nesting_and_broken_text_are_problems_not_crashes(self):
        for text in ["", "{", "[" * 100000, "\x00\xff", '{"pressure_kpa": NaN}', "null", "1e999"]:
            with self.subTest(text[:10]):
                result = coapt("valve", "check", "-", "--json", stdin=text)
                self.assertEqual(result.returncode, BAD_INPUT)
                self.assertGreater(len(json.loads(result.stdout)["problems"]), 0)

    def test_a_file_that_is_not_there_is_bad_input(self):
        for command in [["valve", "check"], ["valve", "info"], ["close"], ["plan"]]:
            with self.subTest(command):
                self.assertEqual(coapt(*command, "no-such-file.json").returncode, BAD_INPUT)

    def test_a_problem_of_the_whole_file_names_it(self):
        result = coapt("valve", "check", "human-norma")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("human-norma: no such file", result.stdout)

    def test_a_directory_is_bad_input(self):
        self.assertEqual(coapt("valve", "check", self.folder).returncode, BAD_INPUT)


class Remodel(ProgramTest):
    def info(self, path):
        return json.loads(self.run_ok("valve", "info", path, "--json").stdout)

    def test_dilation_widens_the_annulus_front_to_back_only(self):
        normal, dilated = self.make("human-normal"), self.folder / "dilated.json"
        self.run_ok("valve", "remodel", normal, "--ap-dilation", "20", "-o", dilated)
        before, after = self.info(normal), self.info(dilated)
        self.assertGreater(after["saddle_to_mid_posterior_mm"], 1.1 * before["saddle_to_mid_posterior_mm"])
        self.assertAlmostEqual(after["commissures_mm"], before["commissures_mm"], delta=0.5)
        self.assertAlmostEqual(after["leaflet_area_mm2"], before["leaflet_area_mm2"], places=6)

    def test_displaced_tips_move_outwards_posterior_and_apical(self):
        moved = self.folder / "moved.json"
        self.run_ok(
            "valve", "remodel", "human-normal", "--displace-al", "1,2,3", "--displace-pm", "-4,5,6", "-o", moved
        )
        before = json.loads(self.run_ok("valve", "make", "human-normal", "-o", "-").stdout)
        after = json.loads(moved.read_text())
        for old, new in zip(before["papillary_heads"], after["papillary_heads"]):
            # x to the posteromedial side, y anterior, z to the atrium.
            expected = (-1, -2, -3) if old["side"] == "anterolateral" else (-4, -5, -6)
            for axis in range(3):
                shift = new["tip_mm"][axis] - old["tip_mm"][axis]
                self.assertAlmostEqual(shift, expected[axis], places=9)

    def test_the_new_valve_has_a_name_of_its_own_and_says_where_it_comes_from(self):
        worse, worst = self.folder / "worse.json", self.folder / "worst.json"
        self.run_ok("valve", "remodel", "human-normal", "--ap-dilation", "15", "-o", worse)
        self.assertEqual(self.info(worse)["name"], "human-normal remodelled")
        self.assertIn("dilation 15 %", self.info(worse)["provenance"][-1])
        self.run_ok("valve", "remodel", worse, "--name", "worst", "-o", worst)
        self.assertEqual(self.info(worst)["name"], "worst")

    def test_values_out_of_range_are_named_by_their_options(self):
        result = coapt(
            "valve", "remodel", "human-normal", "--ap-dilation", "1000", "--displace-pm", "1,2,300", "-o", "-"
        )
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn(" --ap-dilation: ", result.stderr)
        self.assertIn(" --displace-pm/2: ", result.stderr)


class Import(ProgramTest):
    DATA = SOURCE / "examples/valves/source/bodyparts3d"

    def test_the_real_valve_is_imported_with_its_provenance(self):
        valve = self.folder / "valve.json"
        self.run_ok(
            "valve",
            "import",
            "--leaflet",
            self.DATA / "anterior_leaflet_sheet.obj",
            self.DATA / "posterior_leaflet_sheet.obj",
            "--annulus",
            self.DATA / "annulus_centerline.csv",
            "--chordae",
            self.DATA / "chordae.csv",
            "--triangles",
            "720",
            "--name",
            "real",
            "--provenance",
            "from BodyParts3D",
            "-o",
            valve,
            "--render",
            self.folder / "import.png",
        )
        self.assertTrue((self.folder / "import.png").read_bytes().startswith(b"\x89PNG"))
        self.run_ok("valve", "check", valve)
        info = json.loads(self.run_ok("valve", "info", valve, "--json").stdout)
        self.assertEqual(info["name"], "real")
        self.assertAlmostEqual(info["triangles"], 720, delta=72)
        self.assertEqual(sum(info["chordae"].values()), 24)
        self.assertIn("from BodyParts3D", info["provenance"])

    def test_a_valve_without_its_annulus_is_imported_and_says_so(self):
        leaflets = [self.DATA / "anterior_leaflet_sheet.obj", self.DATA / "posterior_leaflet_sheet.obj"]
        given = ["--chordae", self.DATA / "chordae.csv", "-o", self.folder / "valve.json", "--json"]
        found = json.loads(self.run_ok("valve", "import", "--leaflet", *leaflets, *given, "--thickness", "1.5").stdout)
        look = {of["subject"] for of in found["decisions"] if of["look"]}
        self.assertIn("annulus", look)
        self.assertIn("state", {of["subject"] for of in found["decisions"]})
        self.assertEqual(found["thickness"], [])
        valve = json.loads((self.folder / "valve.json").read_text())
        self.assertEqual(valve["tissue"]["thickness_mm"], 1.5)
        result = coapt("valve", "import", "--leaflet", *leaflets, *given, "--thickness", "thick")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("--thickness must be", result.stderr)
        result = coapt("valve", "import", "--leaflet", *leaflets, *given, "--thickness", "measured")
        self.assertIn("requires thick leaflets", result.stderr)

    def test_a_mesh_that_is_none_is_named(self):
        mesh = self.write("leaflet.obj", "v 1 2\n")
        points = self.write("annulus.csv", "0,0,0\n1,0,0\n0,1,0\n")
        chordae = self.write("chordae.json", [])
        result = coapt("valve", "import", "--leaflet", mesh, "--annulus", points, "--chordae", chordae, "-o", "-")
        self.assertEqual(result.returncode, BAD_INPUT)
        self.assertIn("leaflet.obj", result.stderr)
        self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
