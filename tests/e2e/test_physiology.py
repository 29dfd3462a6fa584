"""Presets are the calibrated valves. Beside what hearts do every row of theirs is met, or is named here with the reason."""

import json
import unittest

from programs import SOURCE, ProgramTest

OPEN_EDGES = "open leaflets narrow a small ring less here than in hearts"
TAUT_OPEN = "leaflets and chordae that closed a smaller annulus stand taut in the wider one of diastole"
SHORT_EDGES = "free edges are shorter than two holes and a clip need"
WIDE = "the annulus is wide in diastole, and the flow is that of any adult"
TETHERED = "leaflets that tips draw outwards open a little less than before clips were set"
TIPS_OUT = "tips that stand so far out that rings above 32 mm leak are farther apart in diastole than measured"
FALLS = "what prolapses is pressed against the other leaflet: the leak falls more than published"
SMALL_RINGS = "leaflets softened along the fibres tent a little less and close behind rings above 32 mm"
LONG_LEAFLETS = "ranges are of healthy hearts: long leaflets coapt over more height, tent less and pull less"

VALVES = {
    "human-normal": ("healthy", {}),
    "human-functional-mr": (
        "functional",
        {
            "papillary_diastole": TIPS_OUT,
            "opening": TETHERED,
            "two_clips_share": SHORT_EDGES,
            "clip_gradient": SHORT_EDGES,
        },
    ),
    "secondary-mr": (
        "functional",
        {
            "tenting_area": SMALL_RINGS,
            "papillary_diastole": TIPS_OUT,
            "ring_40": SMALL_RINGS,
            "ring_36": SMALL_RINGS,
            "ring_34": SMALL_RINGS,
            "two_clips_share": SHORT_EDGES,
            "clip_gradient": SHORT_EDGES,
        },
    ),
    "human-p2-prolapse": ("prolapse", {"ring_opening_share": TAUT_OPEN}),
    "barlow": ("prolapse", {"opening": WIDE, "gradient_slope": OPEN_EDGES}),
    "fibroelastic-flail": ("prolapse", {"ring_opening_share": TAUT_OPEN, "two_clips_share": SHORT_EDGES}),
    "marfan": ("prolapse", {"leak_200_over_60": FALLS, "gradient_slope": OPEN_EDGES}),
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
        },
    ),
}


class CalibratedValves(ProgramTest):
    def missed(self, name, kind):
        told = json.loads(self.run_ok("study", "physiology", name, "--kind", kind, "--json").stdout)
        return {row["quantity"] for row in told["rows"] if row["low"] is not None and row["verdict"] != "met"}

    def test_rows_that_are_missed_are_those_that_are_named(self):
        for name, (kind, named) in VALVES.items():
            with self.subTest(name):
                self.assertEqual(self.missed(name, kind), set(named))

    def test_presets_are_what_the_files_of_calibration_make(self):
        for name in VALVES:
            with self.subTest(name):
                file = SOURCE / "examples" / "calibration" / f"{name}.json"
                preset, made = (
                    json.loads(self.run_ok("valve", "make", *source, "-o", "-").stdout)
                    for source in ([name], ["--dimensions", file])
                )
                for valve in (preset, made):
                    del valve["provenance"]
                self.assertEqual(preset, made)


if __name__ == "__main__":
    unittest.main()
