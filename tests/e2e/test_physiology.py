"""Calibrated valves beside what hearts do: every row is met, or is named here with the reason."""

import json
import unittest

from programs import SOURCE, ProgramTest

OPEN_EDGES = "open leaflets narrow a small ring less here than in hearts"
SHORT_EDGES = "free edges are shorter than two holes and a clip need"
WIDE = "the annulus is wide in diastole, and the flow is that of any adult"
TIPS_OUT = "tips that stand so far out that rings above 32 mm leak are farther apart in diastole than measured"
AT_A2 = "the leak lies where A2 meets P2; the mean of nine sections is met"
FALLS = "what prolapses is pressed against the other leaflet: the leak falls more than published"
SMALL_RINGS = "leaflets softened along the fibres close behind rings above 32 mm"
LONG_LEAFLETS = "ranges are of healthy hearts: long leaflets coapt over more height, tent less and pull less"

VALVES = {
    "human-normal": ("healthy", {"gradient_slope": OPEN_EDGES}),
    "human-functional-mr": (
        "functional",
        {"coaptation_length": AT_A2, "papillary_diastole": TIPS_OUT, "gradient_slope": OPEN_EDGES},
    ),
    "secondary-mr": (
        "functional",
        {
            "coaptation_length": AT_A2,
            "papillary_diastole": TIPS_OUT,
            "ring_36": SMALL_RINGS,
            "ring_34": SMALL_RINGS,
            "gradient_slope": OPEN_EDGES,
            "clip_share": SHORT_EDGES,
            "two_clips_share": SHORT_EDGES,
        },
    ),
    "human-p2-prolapse": (
        "prolapse",
        {"leak_200_over_60": FALLS, "ring_opening_share": OPEN_EDGES, "gradient_slope": OPEN_EDGES},
    ),
    "barlow": ("prolapse", {"gradient": WIDE, "gradient_slope": OPEN_EDGES, "clip_share": SHORT_EDGES}),
    "fibroelastic-flail": (
        "prolapse",
        {"leak_200_over_60": FALLS, "gradient": WIDE, "gradient_slope": OPEN_EDGES, "clip_share": SHORT_EDGES},
    ),
    "marfan": (
        "prolapse",
        {
            "leak_200_over_60": FALLS,
            "opening": WIDE,
            "gradient": WIDE,
            "gradient_slope": OPEN_EDGES,
            "clip_share": SHORT_EDGES,
        },
    ),
    "hypertrophic": (
        "healthy",
        {
            "coaptation_length": LONG_LEAFLETS,
            "coaptation_height": LONG_LEAFLETS,
            "depth_plane": LONG_LEAFLETS,
            "tenting_area": LONG_LEAFLETS,
            "struts_cut_ratio": LONG_LEAFLETS,
            "muscle_share": LONG_LEAFLETS,
            "annular_force": LONG_LEAFLETS,
            "opening": LONG_LEAFLETS,
            "gradient_slope": OPEN_EDGES,
        },
    ),
}


class CalibratedValves(ProgramTest):
    def missed(self, name, kind):
        valve = self.folder / f"{name}.json"
        dimensions = SOURCE / "examples" / "calibration" / f"{name}.json"
        self.run_ok("valve", "make", "--dimensions", dimensions, "-o", valve)
        told = json.loads(self.run_ok("study", "physiology", valve, "--kind", kind, "--json").stdout)
        return {row["quantity"] for row in told["rows"] if row["low"] is not None and row["verdict"] != "met"}

    def test_rows_that_are_missed_are_those_that_are_named(self):
        for name, (kind, named) in VALVES.items():
            with self.subTest(name):
                self.assertEqual(self.missed(name, kind), set(named))


if __name__ == "__main__":
    unittest.main()
