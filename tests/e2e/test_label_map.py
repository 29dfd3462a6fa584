"""Label maps, DICOM series and bare files of `coapt valve import`, and that no patient is named by what comes of them."""

import gzip
import json
import unittest

from programs import BAD_INPUT, NOT_CLOSED, SOURCE, ProgramTest, coapt

IMAGES = SOURCE / "tests/io/image/files"
SHEETS = SOURCE / "examples/valves/source/bodyparts3d"
# What write_image_files.py and the keys below hold of a patient.
SECRETS = ["DOE", "JANE", "MRN", "Elsewhere", "19480229"]


def plate_labels(ring=True):
    """Two plates of labels 1 and 2 and a band of label 3 about them."""
    size = (60, 60, 8)

    def label(i, j, k):
        out = ((2 * i - 59) ** 2 + (2 * j - 59) ** 2) ** 0.5
        if out < 44 and k in (3, 4):
            return 1 if j < 29 else 2 if j > 30 else 0
        return 3 if ring and 44 <= out < 52 and 2 <= k <= 5 else 0

    return size, bytes(label(i, j, k) for k in range(size[2]) for j in range(size[1]) for i in range(size[0]))


def nrrd(keys="", space="space: left-posterior-superior\nspace directions: (0.7,0,0) (0,0.7,0) (0,0,0.7)\n"):
    size, labels = plate_labels()
    head = f"NRRD0004\ntype: uchar\ndimension: 3\nsizes: {' '.join(map(str, size))}\n{space}encoding: gzip\n{keys}\n"
    return head.encode() + gzip.compress(labels)


def hanging_labels(anterior, posterior, names=""):
    """A funnel whose front, over 37 % of the annulus, is taller than its back, below a band of label 3."""

    def label(i, j, k):
        out, depth, front = ((2 * i - 59) ** 2 + (2 * j - 59) ** 2) ** 0.5, 11 - k, 2 * j - 59 > 18
        if k >= 11 and 44 <= out < 52:
            return 3
        edge = 44 - 2.5 * depth
        return (anterior if front else posterior) if 0 <= depth <= (9 if front else 6) and edge - 4 <= out < edge else 0

    head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 60 60 14\nspace: left-posterior-superior\n"
    head += f"space directions: (0.7,0,0) (0,0.7,0) (0,0,0.7)\nencoding: gzip\n{names}\n"
    voxels = bytes(label(i, j, k) for k in range(14) for j in range(60) for i in range(60))
    return head.encode() + gzip.compress(voxels)


class LabelMaps(ProgramTest):
    def refused(self, *arguments):
        result = coapt("valve", "import", *arguments, "-o", self.folder / "valve.json")
        self.assertEqual(result.returncode, BAD_INPUT, result.stderr)
        self.assertNotIn("terminate", result.stderr)
        return result.stderr

    def test_bare_files_are_the_valve_that_options_give(self):
        files = [
            SHEETS / f"{name}.{kind}"
            for name, kind in [
                ("anterior_leaflet_sheet", "obj"),
                ("posterior_leaflet_sheet", "obj"),
                ("annulus_centerline", "csv"),
                ("chordae", "csv"),
            ]
        ]
        bare, named = self.folder / "bare.json", self.folder / "named.json"
        result = self.run_ok("valve", "import", *reversed(files), "-o", bare, "--json")
        decisions = json.loads(result.stdout)["decisions"]
        self.assertEqual([d["subject"] for d in decisions[:4]], ["files"] * 4)
        self.assertEqual(decisions[0]["value"], "file 1 of 4 (.csv) is chordae")
        self.run_ok(
            "valve",
            "import",
            "--leaflet",
            files[0],
            files[1],
            "--annulus",
            files[2],
            "--chordae",
            files[3],
            "-o",
            named,
        )
        first, second = (json.loads(path.read_text()) for path in (bare, named))
        for valve in (first, second):
            del valve["provenance"]
        self.assertEqual(first, second)

    def test_a_folder_of_files_is_as_if_they_were_named_one_by_one(self):
        folder = self.folder / "case"
        folder.mkdir()
        for name, given in [("a.obj", "anterior_leaflet_sheet.obj"), ("p.obj", "posterior_leaflet_sheet.obj")]:
            (folder / name).write_bytes((SHEETS / given).read_bytes())
        (folder / "ring.csv").write_bytes((SHEETS / "annulus_centerline.csv").read_bytes())
        one, all_of = self.folder / "one.json", self.folder / "all.json"
        self.run_ok("valve", "import", *sorted(folder.iterdir()), "-o", one)
        (folder / "README.md").write_text("whose it is")
        (folder / ".hidden").write_text("")
        said = self.run_ok("valve", "import", folder, "-o", all_of).stderr
        self.assertIn("1 of 4 files of the folder not used", said)
        without_provenance = [json.loads(path.read_text()) | {"provenance": []} for path in (one, all_of)]
        self.assertEqual(*without_provenance)
        study = ("study", "imports", self.folder, "-o", self.folder / "study", "--json")
        self.assertEqual(json.loads(self.run_ok(*study).stdout)["stages"]["refused"], 0)
        empty = self.folder / "empty"
        empty.mkdir()
        self.assertIn("no file that a valve can be made of", self.refused(empty))

    def test_landmarks_that_a_person_placed_are_taken(self):
        sheets = [SHEETS / f"{side}_leaflet_sheet.obj" for side in ("anterior", "posterior")]
        given = [*sheets, SHEETS / "annulus_centerline.csv"]
        ring = [
            line for line in (SHEETS / "annulus_centerline.csv").read_text().splitlines() if line[:1] in "-0123456789"
        ]
        (self.folder / "seen.csv").write_text("label,x,y,z\nA," + ring[len(ring) // 4] + "\n")
        for option in (["--landmarks"], []):
            seen = self.folder / "seen.csv"
            if not option:  # among bare files they need a commissure
                seen.write_text(seen.read_text() + "ALC," + ring[len(ring) // 3] + "\n")
            said = self.run_ok("valve", "import", *given, *option, seen, "-o", self.folder / "v.json").stderr
            self.assertIn("saddle peak", said)
        far = self.folder / "far.csv"
        far.write_text("label,x,y,z\nA,900,900,900\n")
        self.assertIn("far.csv", self.refused(*given, "--landmarks", far))

    def test_a_map_larger_than_other_files_may_be_is_read(self):
        small = hanging_labels(1, 2)
        head, voxels = small[: small.index(b"\n\n") + 2], gzip.decompress(small[small.index(b"\n\n") + 2 :])
        slices = 60 + (64 << 20) // 3600
        head = head.replace(b"60 60 14", b"60 60 %d" % slices).replace(b"encoding: gzip", b"encoding: raw")
        large = self.folder / "large.nrrd"
        large.write_bytes(head + voxels.ljust(3600 * slices, b"\0"))
        (self.folder / "small.nrrd").write_bytes(small)
        for name in ("small", "large"):
            self.run_ok("valve", "import", self.folder / f"{name}.nrrd", "-o", self.folder / f"{name}.json")
        valves = [json.loads((self.folder / f"{name}.json").read_text())["vertices_mm"] for name in ("small", "large")]
        self.assertEqual(*valves)
        mesh = self.folder / "large.obj"
        large.rename(mesh)
        self.assertIn("larger than 64 MiB", self.refused(mesh))

    def test_bare_files_without_chordae_get_drawn_ones(self):
        out = self.folder / "valve.json"
        files = [
            SHEETS / "anterior_leaflet_sheet.obj",
            SHEETS / "posterior_leaflet_sheet.obj",
            SHEETS / "annulus_centerline.csv",
        ]
        self.run_ok("valve", "import", *files, "--seed", "3", "-o", out)
        self.assertIn("seed 3", out.read_text())

    def test_a_frame_turns_half_round_the_body_axis_and_the_valve_stays(self):
        files = [
            "--leaflet",
            SHEETS / "anterior_leaflet_sheet.obj",
            SHEETS / "posterior_leaflet_sheet.obj",
            "--annulus",
            SHEETS / "annulus_centerline.csv",
            "--chordae",
            SHEETS / "chordae.csv",
        ]
        lps, ras = self.folder / "lps.json", self.folder / "ras.json"
        self.run_ok("valve", "import", *files, "-o", lps)
        self.run_ok("valve", "import", *files, "--frame", "RAS", "-o", ras)
        first, second = (json.loads(path.read_text())["patient_frame"] for path in (lps, ras))
        for row in range(3):
            for column in range(4):
                sign = -1 if row < 2 else 1
                self.assertAlmostEqual(first[row][column], sign * second[row][column], 9)

    def test_wrong_words_and_files_are_named(self):
        image = IMAGES / "no-frame.nii.gz"
        self.assertIn("--label: is front=1", self.refused(image, "--label", "front=1"))
        self.assertIn("--label/anterior: is 9", self.refused(image, "--label", "anterior=9"))
        self.assertIn("is not a ring", self.refused(image))
        self.assertIn("has no DICOM image", self.refused(image, "--series", SHEETS))
        self.assertIn("has an unknown role", self.refused(SOURCE / "README.md"))
        self.assertIn(
            "the label map: is missing: the geometry of a series of images applies only to a label map",
            self.refused(
                "--leaflet",
                SHEETS / "anterior_leaflet_sheet.obj",
                "--series",
                IMAGES / "series",
                "--annulus",
                SHEETS / "annulus_centerline.csv",
                "--chordae",
                "synthesise",
            ),
        )

    def test_nothing_that_is_given_is_dropped_unsaid(self):
        self.run_ok("export", "human-normal", "--open", "-o", f"{self.folder}/open/")
        parts = [self.folder / "open" / name for name in ("leaflets.vtk", "annulus.mrk.json")]
        out = ("-o", self.folder / "valve.json")
        self.run_ok("valve", "import", *parts, *out)
        twice = self.refused(*parts, "--annulus", SHEETS / "annulus_centerline.csv")
        self.assertIn("file 2 of the files is that part, too", twice)
        drawn = self.run_ok("valve", "import", *parts, "--seed", "7", "--slack", "1.1", *out).stderr
        self.assertIn("options: slack not used", drawn)
        self.assertNotIn("seed not used", drawn)
        self.assertIn("phase not used", self.run_ok("valve", "import", *parts, "--phase", "2", *out).stderr)

    def test_a_slicerheart_folder_goes_with_no_other_part(self):
        self.run_ok("export", "human-normal", "--open", "-o", f"{self.folder}/open/")
        annulus = ("--annulus", SHEETS / "annulus_centerline.csv")
        self.assertIn("cannot be combined with other files", self.refused(self.folder / "open", *annulus))

    def test_a_table_beside_named_leaflets_leaves_them_as_they_are(self):
        leaflets = [SHEETS / f"{name}_leaflet_sheet.obj" for name in ("anterior", "posterior")]
        annulus = SHEETS / "annulus_centerline.csv"
        valves = []
        for given in ([annulus, "--leaflet", *leaflets], ["--leaflet", *leaflets, "--annulus", annulus]):
            valve = self.folder / "valve.json"
            self.run_ok("valve", "import", *given, "--chordae", "synthesise", "-o", valve)
            valves.append(json.loads(valve.read_text())["vertices_mm"])
        self.assertEqual(*valves)

    def test_what_a_person_should_check_is_said_with_and_without_json(self):
        (self.folder / "bare.nrrd").write_bytes(hanging_labels(2, 1))
        command = ["valve", "import", self.folder / "bare.nrrd", "-o", self.folder / "valve.json"]
        told, listed = self.run_ok(*command), self.run_ok(*command, "--json")
        looks = [one for one in json.loads(listed.stdout)["decisions"] if one["look"]]
        self.assertIn("label 2 is the anterior leaflet, label 1 the posterior one", [one["value"] for one in looks])
        self.assertEqual(
            told.stderr.splitlines()[: len(looks)],
            [
                f"coapt: valve import: check this against the images: {one['subject']}: {one['value']}; {one['reason']}."
                for one in looks
            ],
        )
        self.assertIn("coapt: valve import: units: mm.", told.stderr.splitlines()[len(looks) :])
        self.assertEqual((told.stdout, listed.stderr), ("", ""))
        strict = coapt(*command, "--strict")
        self.assertEqual(strict.returncode, NOT_CLOSED)
        self.assertTrue(json.loads((self.folder / "valve.json").read_text()))

    def test_labels_that_look_the_other_way_round_are_turned_refused_or_trusted(self):
        def map_of(*labels):
            path = self.folder / f"map{len(list(self.folder.iterdir()))}.nrrd"
            path.write_bytes(hanging_labels(*labels))
            return path

        out = self.folder / "valve.json"
        named = "Segment0_Name:=anterior\nSegment0_LabelValue:=1\nSegment1_Name:=posterior\nSegment1_LabelValue:=2\n"
        right, other = self.run_ok("valve", "import", map_of(1, 2), "-o", out), out.read_text()
        turned = self.run_ok("valve", "import", map_of(2, 1), "-o", out)
        self.assertNotIn("check this against the images: leaflets", right.stderr)
        self.assertIn("check this against the images: leaflets: label 2 is the anterior leaflet", turned.stderr)
        first, second = json.loads(other), json.loads(out.read_text())
        self.assertEqual(first["vertices_mm"], second["vertices_mm"])
        wrong = map_of(2, 1, named)
        refused = self.refused(wrong)
        self.assertIn("--label anterior=2 --label posterior=1", refused)
        self.assertIn("--trust-labels", refused)
        self.run_ok("valve", "import", wrong, "--trust-labels", "-o", out)
        self.run_ok("valve", "import", wrong, "--label", "anterior=2", "--label", "posterior=1", "-o", out)

    def test_a_label_map_comes_back_on_the_grid_that_it_was_drawn_on(self):
        given = self.folder / "given.nrrd"
        given.write_bytes(hanging_labels(1, 2))
        valve = self.folder / "valve.json"
        self.run_ok("valve", "import", given, "-o", valve)
        for name in ("out.nrrd", "out.nii"):
            out = self.folder / name
            result = coapt("export", valve, "--open", "--grid", given, "-o", out)
            self.assertIn(result.returncode, (0, NOT_CLOSED), result.stderr)
            again = self.run_ok("valve", "import", out, "-o", self.folder / "again.json", "--json")
            labels = {of["number"]: of["part"] for of in json.loads(again.stdout)["labels"]}
            self.assertEqual(labels, {1: "anterior", 2: "posterior", 3: "annulus"})
        self.assertIn(b"sizes: 60 60 14\n", (self.folder / "out.nrrd").read_bytes())
        preset = coapt("export", "human-normal", "--open", "--grid", given, "-o", self.folder / "no.nrrd")
        self.assertEqual(preset.returncode, BAD_INPUT)
        self.assertIn("--grid", preset.stderr)

    def test_a_folder_of_maps_is_studied_and_taken_up_again(self):
        maps = self.folder / "maps"
        maps.mkdir()
        (maps / "a.nrrd").write_bytes(hanging_labels(1, 2))
        (maps / "b.nrrd").write_bytes(hanging_labels(1, 1))
        study = ("study", "imports", maps, "-o", self.folder / "study", "--json")
        first = json.loads(self.run_ok(*study).stdout)
        self.assertEqual(first["maps"], 2)
        self.assertEqual(first["stages"]["refused"], 1)
        table = (self.folder / "study/imports.csv").read_text().splitlines()
        self.assertEqual([line.split(",")[0] for line in table], ["name", "a.nrrd", "b.nrrd"])
        log = (self.folder / "study/imports.jsonl").read_text()
        self.assertEqual(json.loads(self.run_ok(*study).stdout), first)
        self.assertEqual((self.folder / "study/imports.jsonl").read_text(), log)
        torn = self.folder / "study/imports.jsonl"
        torn.write_text(log[:40])
        self.run_ok(*study)
        self.assertEqual(torn.read_text().splitlines()[1:], log.splitlines(), "behind the half line")
        (self.folder / "study/valves/a.nrrd.json").unlink()
        (maps / "loose.txt").write_text("not a map")
        again = json.loads(self.run_ok(*study, "--pictures").stdout)
        self.assertEqual(again, first | {"left_out": 1})
        self.assertTrue((self.folder / "study/valves/a.nrrd.json").exists(), "made again")
        self.assertTrue((self.folder / "study/pictures/a.nrrd.png").exists())

    def test_nothing_that_comes_of_images_names_a_patient(self):
        """Neither the valve nor the decisions nor any message."""
        keys = "PatientName:=DOE^JANE\nSegment0_Name:=DOE JANE anterior\nSegment0_LabelValue:=1\n"
        keys += "Segment1_Name:=MRN-4711 posterior\nSegment1_LabelValue:=2\ncontent: DOE^JANE 1948\n"
        (self.folder / "DOE_JANE.seg.nrrd").write_bytes(nrrd(keys))
        out = self.folder / "valve.json"
        cases = [
            [self.folder / "DOE_JANE.seg.nrrd"],
            [self.folder / "DOE_JANE.seg.nrrd", "--series", IMAGES / "series"],
            [IMAGES / "qform.nii", IMAGES / "series"],
            [IMAGES / "no-frame.nii.gz", "--series", IMAGES / "series-without-orientation"],
        ]
        for arguments in cases:
            with self.subTest(arguments):
                out.unlink(missing_ok=True)
                result = coapt("valve", "import", *arguments, "-o", out, "--json")
                written = result.stdout + (out.read_text() if out.exists() else "")
                # The path that was typed is the user's own.
                written += result.stderr.replace(str(arguments[0]), "")
                for secret in SECRETS:
                    self.assertNotIn(secret, written)

    def test_names_in_headers_of_meshes_stay_there(self):
        out, mesh = self.folder / "valve.json", self.folder / "anterior.obj"
        mesh.write_text("# DOE^JANE MRN-4711\no DOE\n" + (SHEETS / "anterior_leaflet_sheet.obj").read_text())
        ring = self.folder / "annulus.csv"
        ring.write_text("# DOE^JANE 1948\n" + (SHEETS / "annulus_centerline.csv").read_text())
        result = self.run_ok("valve", "import", mesh, SHEETS / "posterior_leaflet_sheet.obj", ring, "-o", out, "--json")
        for secret in SECRETS:
            self.assertNotIn(secret, result.stdout + out.read_text())


if __name__ == "__main__":
    unittest.main()
