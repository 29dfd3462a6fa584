"""coapt train: cases by seed, schedules, scores of trials."""

import json
import unittest

from programs import BAD_INPUT, SOURCE, ProgramTest, coapt

COLUMNS = (
    "learner,block,trial,valve,exam,seed,difficulty,choice,answer,right,confidence,seconds,path_mm,largest_n,visited"
)


class Train(ProgramTest):
    def case(self, exam, seed):
        folder = self.folder / f"{exam}-{seed}"
        made = json.loads(self.run_ok("train", "case", "--exam", exam, "--seed", seed, "-o", folder, "--json").stdout)
        self.assertEqual(made, json.loads((folder / "case.json").read_text()))
        return folder, made

    def test_exam_a_writes_four_valves_that_close_and_says_which_is_shown(self):
        folder, made = self.case("A", 5)
        self.assertEqual((made["schema"], made["exam"], made["seed"]), ("coapt.training_case/1", "A", 5))
        self.assertIn(made["answer"], (1, 2, 3, 4))
        self.assertGreaterEqual(min(pair["scaled"] for pair in made["differences"]), 1.0)
        self.assertLess(made["largest_flaccid_mm"], made["limits"]["flaccid_mm"])
        for picture in ("choices.png", "flaccid.png"):
            self.assertEqual((folder / picture).read_bytes()[:4], b"\x89PNG")
        first = made["choices"][0]
        closed = json.loads(self.run_ok("close", folder / first["file"], "--json").stdout)
        self.assertAlmostEqual(closed["leak_mm2"], first["leak_mm2"], places=9)

    def test_exam_b_has_a_truth_for_each_segment(self):
        folder, made = self.case("B", 6)
        self.assertEqual([s["segment"] for s in made["segments"]], "A1 A2 A3 P1 P2 P3 AC PC".split())
        self.assertEqual({s["mobility"] for s in made["segments"]}, {"tethered", "normal", "prolapsing"})
        self.run_ok("valve", "check", folder / made["file"])

    def test_a_study_is_laid_out_and_its_trials_are_scored(self):
        study = SOURCE / "examples/training/study-1.json"
        exam = json.loads(self.run_ok("train", "exam", study, "--seed", 4, "--json").stdout)
        (block,) = exam["blocks"]
        rows = [COLUMNS]
        for number, trial in enumerate(block["trials"], start=1):
            right = number % 2
            rows.append(
                f"1,exam,{number},human-normal,A,{trial['seed']},-0.2,{1 + right},2,{right},0.5,90,300,0.7,P1 AC A1"
            )
        table = self.write("trials.csv", "\n".join(rows) + "\n")
        scored = json.loads(self.run_ok("train", "score", table, "--json").stdout)
        self.assertEqual((scored["schema"], scored["trials"]), ("coapt.training_score/1", 10))
        self.assertEqual(scored["scores"][0]["right"], 5)
        self.assertRegex(self.run_ok("train", "score", table).stdout, r"5 of +10")
        self.assertIn("seeds of the cases", self.run_ok("train", "exam", study, "--seed", 4).stdout)

    def test_bad_tables_are_refused_with_row_and_column(self):
        row = "1,exam,1,human-normal,A,7,-0.2,5,2,0,0.5,90,300,0.7,P1"
        table = self.write("trials.csv", f"{COLUMNS}\n{row}\n")
        refused = coapt("train", "score", table)
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("/2/choice", refused.stderr)
        self.assertIn("from 1 to 4", refused.stderr)

    def test_text_that_is_not_utf8_is_refused(self):
        table = self.folder / "trials.csv"
        table.write_bytes(COLUMNS.encode() + b"\n1,caf\xe9,1,human-normal,A,7,-0.2,1,2,0,0.5,90,300,0.7,P1\n")
        refused = coapt("train", "score", table)
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("/2/block", refused.stderr)
        self.assertIn("must be UTF-8", refused.stderr)

    def test_seeds_are_those_that_json_and_pages_can_count_with(self):
        study = SOURCE / "examples/training/study-1.json"
        last = 2**52
        exam = json.loads(self.run_ok("train", "exam", study, "--seed", 4, "--first-case", last, "--json").stdout)
        self.assertEqual(min(trial["seed"] for trial in exam["blocks"][0]["trials"]), last)
        self.assertNotEqual(coapt("train", "exam", study, "--seed", 4, "--first-case", last + 1).returncode, 0)
        self.assertNotEqual(coapt("train", "exam", study, "--seed", 2**53).returncode, 0)


if __name__ == "__main__":
    unittest.main()
