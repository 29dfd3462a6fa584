"""What coapt plan is asked for: --search, --fix, --forbid; and what it refuses, before it closes anything."""

import json
import unittest

import jsonschema
from plan_runs import options, without_machine
from programs import BAD_INPUT, NO_COMPETENT_PLAN, OK, SOURCE, ProgramTest, coapt, small_valve

LONG = ["--evaluations", "100000"]
RING = {"step": "annuloplasty", "shape": "own", "sizes_below": 3}


def plan_of(*steps):
    return {"schema": "coapt.plan/1", "steps": list(steps)}


def techniques(plan):
    return {step["step"] for step in plan["plan"]["steps"]}


def search_schema():
    """search.schema.json, with what it takes from plan.schema.json put in its place."""
    schema, plan = [json.loads((SOURCE / f"io/schema/{name}.schema.json").read_text()) for name in ("search", "plan")]
    steps = schema["$defs"]["rules"]["properties"]["fixed"]["properties"]
    assert steps["steps"] == {"$ref": "../plan/1#/$defs/steps"}
    steps["steps"] = plan["$defs"]["steps"]
    schema["$defs"] |= plan["$defs"]
    return schema


class Input(ProgramTest):
    def plan(self, *arguments, **changes):
        result = coapt("plan", small_valve(), *options(**changes), *arguments, "--json")
        self.assertIn(result.returncode, [OK, NO_COMPETENT_PLAN], result.stderr)
        return json.loads(result.stdout)

    def refused(self, *arguments):
        """The lines on standard error of a search that is refused at once."""
        result = coapt("plan", small_valve(), *arguments, "--json")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""), result.stderr)
        self.assertNotEqual(result.stderr, "")
        return result.stderr.splitlines()

    def search_refused(self, search):
        file = self.write("search.json", search)
        lines = self.refused(*LONG, "--search", file)
        for line in lines:
            self.assertTrue(line.startswith(f"coapt: {file}: "), line)
        return [line.removeprefix(f"coapt: {file}: ") for line in lines]


class Rules(Input):
    def test_what_is_fixed_is_in_every_plan_and_no_other_ring(self):
        fixed = self.write("ring.json", plan_of(RING))
        result = self.plan("--fix", fixed, evaluations=30)
        self.assertEqual(result["reproduce"]["search"]["rules"]["fixed"], plan_of(RING))
        self.assertEqual(len(result["plans"]), 2)
        for plan in result["plans"]:
            rings = [step for step in plan["plan"]["steps"] if step["step"] == "annuloplasty"]
            self.assertEqual(rings, [RING])

    def test_what_is_forbidden_is_in_no_plan_and_said_to_be_left_out(self):
        result = self.plan(
            "--forbid", "annuloplasty", "--forbid", "papillary_approximation:saddle_peak", evaluations=30
        )
        self.assertGreater(len(result["plans"]), 0)
        for plan in result["plans"]:
            self.assertEqual(techniques(plan), {"papillary_approximation"})
            self.assertNotIn("saddle_peak", {step["anchor"] for step in plan["plan"]["steps"]})
        self.assertIn({"what": "ring of the annulus's own shape", "why": "forbidden"}, result["cut"])

    def test_the_annulus_s_own_shape_is_offered_on_request(self):
        forbidden = ("--forbid", "papillary_approximation", "--forbid", "annuloplasty:generic-classic")
        few = ("--evaluations", "20", "--plans", "1", "--region-points", "2", "--no-evidence", "--fine-levels", "0")
        found = coapt("plan", "human-p2-prolapse", *few, *forbidden, "--rings", "own", "--json", "--model-draws", "0")
        self.assertIn(found.returncode, [OK, NO_COMPETENT_PLAN], found.stderr)
        result = json.loads(found.stdout)
        self.assertTrue(result["reproduce"]["search"]["rules"]["own_ring"])
        self.assertIn(" --rings own", result["reproduce"]["command"])
        self.assertEqual(
            {step["shape"] for plan in result["plans"] for step in plan["steps"] if "shape" in step}, {"own"}
        )

    def test_fixed_and_forbidden_go_together(self):
        fixed = self.write("ring.json", plan_of(RING))
        result = self.plan("--fix", fixed, "--forbid", "papillary_approximation", evaluations=50)
        self.assertEqual([plan["plan"]["steps"] for plan in result["plans"]], [[RING]])
        self.assertEqual((result["plans_possible"], result["plans_tried"], result["stop"]), (1, 1, "exhausted"))

    def test_all_forbidden_leaves_no_plan_and_all_reasons(self):
        forbidden = ("--forbid", "annuloplasty", "--forbid", "papillary_approximation", "--forbid", "neochorda")
        result = coapt("plan", "human-functional-mr", *LONG, *forbidden, "--json")
        self.assertEqual(result.returncode, NO_COMPETENT_PLAN, result.stderr)
        found = json.loads(result.stdout)
        self.assertEqual((found["plans"], found["stop"], found["any_competent"]), ([], "exhausted", False))
        why = {cut["what"]: cut["why"] for cut in found["cut"]}
        muscles = ["suture of the anterolateral muscle", "suture of the posteromedial muscle"]
        for what in ["ring of the annulus's own shape", *muscles]:
            self.assertEqual(why[what], "forbidden")
        for what in ["neochordae", "resection", "clip", "cutting of strut chordae", "shortening of chordae"]:
            self.assertIn(what, why)

    def test_fixed_and_forbidden_at_once_is_refused(self):
        fixed = self.write("ring.json", plan_of(RING))
        for word in ["annuloplasty", "annuloplasty:own"]:
            with self.subTest(word):
                lines = self.refused(*LONG, "--fix", fixed, "--forbid", word)
                self.assertEqual(len(lines), 1)
                self.assertRegex(lines[0], "/steps/0: is both fixed and forbidden$")

    def test_every_word_that_forbids_nothing_is_named(self):
        lines = self.refused(*LONG, "--forbid", "rings", "--forbid", "annuloplasty", "--forbid", "annuloplasty:round")
        self.assertEqual(len(lines), 2)
        self.assertRegex(lines[0], r'forbid.*/?0: is "rings", must be one of .*annuloplasty')
        self.assertRegex(lines[1], r'forbid.*/?2: is "annuloplasty:round", must be one of ')

    def test_a_fixed_plan_for_another_valve_is_refused_with_all_that_it_lacks(self):
        insertion = {"leaflet": "posterior", "along": 0.5, "height": 1.0}
        fixed = self.write(
            "other.json",
            plan_of(
                {"step": "neochorda", "head": "of-another", "insertion": insertion, "length_mm": 20},
                {"step": "chordal_excision", "chorda": "none"},
            ),
        )
        lines = self.refused(*LONG, "--fix", fixed)
        self.assertEqual(len(lines), 2)
        self.assertRegex(lines[0], "/steps/0/head: is 'of-another', this valve has: AL1")
        self.assertRegex(lines[1], "/steps/1/chorda: is 'none', this valve has: ")

    def test_a_fixed_plan_that_is_none_is_refused_with_its_name_and_pointer(self):
        wrong = self.write("wrong.json", plan_of({"step": "annuloplasty", "shape": "own", "sizes_below": 7}))
        (line,) = self.refused(*LONG, "--fix", wrong)
        self.assertTrue(line.startswith(f"coapt: {wrong}: /steps/0/sizes_below: is 7"), line)
        (line,) = self.refused(*LONG, "--fix", self.folder / "missing.json")
        self.assertIn("missing.json: cannot be opened", line)

    def test_an_option_of_the_command_line_is_named_in_its_words(self):
        fixed = self.write("other.json", plan_of({"step": "chordal_excision", "chorda": "none"}))
        self.assertRegex(self.refused(*LONG, "--fix", fixed)[0], "--fix[:/]")
        self.assertRegex(self.refused(*LONG, "--forbid", "rings")[0], "--forbid[:/]")


class Search(Input):
    def test_a_search_is_as_its_schema_and_gives_the_same_plans_again(self):
        asked = {
            "evaluations": 13,
            "seed": 7,
            "plans": 1,
            "region_points": 2,
            "evidence": False,
            "rules": {
                "fixed": {"steps": [RING]},
                "forbidden": ["papillary_approximation:annulus_point"],
                "suture_lattice_mm": 1,
            },
            "weights": {"movement": 0, "step": 0.5},
        }
        validator = jsonschema.Draft202012Validator(search_schema())
        validator.validate(asked)
        self.assertFalse(validator.is_valid(asked | {"rules": {"fixed": {"steps": [RING | {"sizes_below": 7}]}}}))

        first = coapt("plan", small_valve(), "--search", self.write("asked.json", asked), "--json")
        first = json.loads(first.stdout)
        written = first["reproduce"]["search"]
        validator.validate(written)
        self.assertEqual(
            {key: written[key] for key in asked if key not in ("rules", "weights")},
            {key: asked[key] for key in asked if key not in ("rules", "weights")},
        )
        self.assertEqual(
            (written["weights"]["movement"], written["weights"]["step"], written["weights"]["leak"]), (0, 0.5, 1)
        )
        again = coapt("plan", small_valve(), "--search", self.write("written.json", written), "--json")
        again = json.loads(again.stdout)
        for answer in (first, again):
            del answer["reproduce"]["command"]
        self.assertEqual(without_machine(again), without_machine(first))

    def test_the_command_line_goes_before_the_file_and_adds_to_what_it_forbids(self):
        file = self.write("search.json", {"evaluations": 100000, "plans": 2, "rules": {"forbidden": ["annuloplasty"]}})
        search = self.plan("--search", file, "--forbid", "neochorda", plans=1)["reproduce"]["search"]
        self.assertEqual((search["evaluations"], search["plans"], search["evidence"]), (12, 1, False))
        self.assertEqual(search["rules"]["forbidden"], ["annuloplasty", "neochorda"])

    def test_all_problems_of_a_search_are_listed_with_their_pointers(self):
        problems = self.search_refused(
            {
                "evaluations": 0,
                "plans": "x",
                "seed": -1,
                "evidence": 1,
                "seconds": None,
                "surprise": 1,
                "rules": {
                    "forbidden": [1, "x"],
                    "fixed": {"steps": [{"step": "fly"}]},
                    "most_neochordae": 9,
                    "nope": 2,
                },
                "weights": {"leak": -1, "love": 1, "gap": None},
            }
        )
        self.assertEqual(
            {problem.split(":")[0] for problem in problems},
            {
                "/evaluations",
                "/plans",
                "/seed",
                "/evidence",
                "/seconds",
                "/surprise",
                "/rules/forbidden/0",
                "/rules/fixed/steps/0/step",
                "/rules/most_neochordae",
                "/rules/nope",
                "/weights/leak",
                "/weights/love",
                "/weights/gap",
            },
        )

    def test_what_the_valve_does_not_allow_is_said_with_the_file(self):
        problems = self.search_refused(
            {"rules": {"forbidden": ["rings"], "fixed": {"steps": [{"step": "chordal_excision", "chorda": "none"}]}}}
        )
        self.assertEqual(
            {problem.split(":")[0] for problem in problems}, {"/rules/forbidden/0", "/rules/fixed/steps/0/chorda"}
        )

    def test_text_that_is_no_search_is_refused(self):
        for text, problem in {
            '{"evaluations": NaN}': "/evaluations: ",
            '{"target_mm2": 1e999}': "/target_mm2: ",
            '{"weights": {"leak": Infinity}}': "/weights/leak: ",
            "": "parse error",
            "{": "parse error",
            "null": "is null",
            "[]": "is an array",
            '"x"': 'is "x"',
            '{"seed": 1, "seed": 2}': "/seed: is given more than once",
            '{"rules": 5}': "/rules: is 5",
            '{"weights": []}': "/weights: is an array",
        }.items():
            with self.subTest(text):
                lines = self.search_refused(text)
                self.assertEqual(len(lines), 1)
                self.assertTrue(lines[0].startswith(problem), lines)

    def test_ten_megabytes_of_garbage_are_refused_in_a_few_lines(self):
        letters = "".join(chr(33 + i * i % 90) for i in range(1000))
        fields = ",".join(f'"f{i}":{i}' for i in range(600000))
        for text in [letters * 10000, "[" * 10**7, '{"seed":' * 10**6, "{" + fields + "}", "9" * 10**7]:
            with self.subTest(text[:10]):
                lines = self.search_refused(text)
                self.assertLess(sum(map(len, lines)), 100000)

    def test_a_search_file_that_is_none_is_refused(self):
        for path in [self.folder / "missing.json", self.folder]:
            with self.subTest(path):
                (line,) = self.refused("--search", path)
                self.assertIn(str(path), line)

    def test_numbers_out_of_range_are_named_by_their_options(self):
        for option, value in [
            ("--evaluations", 0),
            ("--plans", 0),
            ("--region-points", 1090),
            ("--target", "nan"),
            ("--no-improvement", -1),
            ("--target", "1e999"),
        ]:
            with self.subTest(f"{option} {value}"):
                self.assertIn(f"{option}: is {value}, must be a", self.refused(option, value)[0])


if __name__ == "__main__":
    unittest.main()
