"""coapt population: valves drawn from distributions; coapt study population: which repair suits which of them."""

import json
import unittest

from programs import BAD_INPUT, SOURCE, ProgramTest, coapt

PRIOR = SOURCE / "examples/populations/adult.json"


class Population(ProgramTest):
    def test_three_valves_are_made_studied_and_taken_out(self):
        # Mostly flail leaflets: they are quick to find.
        prior = json.loads(PRIOR.read_text())
        for aetiology in prior["aetiologies"]:
            aetiology["share"] = 1 if aetiology["name"] == "p2_flail" else 1e-6
        adults, study = self.folder / "adults", self.folder / "study"
        make = ("population", "make", "-n", 4, "--seed", 7, "--prior", self.write("prior.json", json.dumps(prior)))
        self.assertIn("4 valves", self.run_ok(*make, "-o", adults).stdout)
        population = json.loads((adults / "population.json").read_text())
        self.assertEqual(population["schema"], "coapt.population/1")
        self.assertEqual(len((adults / "members.csv").read_text().splitlines()), 5)
        self.assertIn("are assumed", (adults / "index.html").read_text())

        closed = json.loads(self.closed(adults, 1).stdout)
        self.assertAlmostEqual(closed["leak_mm2"], population["members"][1]["leak_mm2"], places=9)
        healthy = json.loads(self.closed(adults, 1, "--healthy").stdout)
        self.assertLessEqual(healthy["leak_mm2"], 5.0)

        run = ("study", "population", adults, "--nodes", 1, "-o", study)
        self.assertIn("Written to", self.run_ok(*run, "--members", 2, "--searched", 0).stdout)
        kept = (study / "records.bin").read_bytes()
        # A killed study left part of a record behind; the rest goes on from the whole ones.
        (study / "records.bin").write_bytes(kept + b"torn")
        found = json.loads(self.run_ok(*run, "--searched", 1, "--evaluations", 50, "--json").stdout)
        self.assertEqual((study / "records.bin").read_bytes()[: len(kept)], kept)
        self.assertEqual(found, json.loads((study / "findings.json").read_text()))
        self.assertEqual((found["schema"], found["members"]), ("coapt.population_study/1", 4))
        self.assertLessEqual(found["tree"]["leaves"], 8)
        self.assertEqual(len(found["searched"]["members"]), 1)
        for name in ("tree.svg", "tree.txt", "tree.json", "findings.csv", "records.csv", "index.html"):
            self.assertTrue((study / name).read_text())

        refused = coapt("study", "population", adults, "--nodes", 2, "-o", study)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("holds records of other valves", refused.stderr)

    def closed(self, adults, index, *more):
        valve = self.folder / "valve.json"
        self.run_ok("population", "valve", adults, index, "-o", valve, *more)
        return coapt("close", valve, "--json")

    def test_priors_are_refused_where_they_are_wrong(self):
        prior = json.loads(PRIOR.read_text())
        prior["anatomy"]["ap_mm"]["sd"] = -1
        prior["anatomy"]["nose_mm"] = prior["anatomy"]["ap_mm"]
        refused = coapt("population", "make", "--prior", self.write("prior.json", json.dumps(prior)))
        self.assertEqual(refused.returncode, BAD_INPUT)
        self.assertIn("/anatomy/nose_mm", refused.stderr)
        prior["anatomy"].pop("nose_mm")
        refused = coapt("population", "make", "--prior", self.write("prior.json", json.dumps(prior)))
        self.assertIn("/anatomy/ap_mm/sd", refused.stderr)


if __name__ == "__main__":
    unittest.main()
