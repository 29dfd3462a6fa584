#!/usr/bin/python3
"""What lab/charts/plot.py makes of tables worked out by hand."""

import csv
import io
import pathlib
import sys
import tempfile
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "lab/charts"))

import matplotlib.text  # noqa: E402
import plot  # noqa: E402
import uniqueness  # noqa: E402
import verdicts  # noqa: E402


def table(text):
    return list(csv.DictReader(io.StringIO(text)))


def texts(figure):
    return [text.get_text() for text in figure.findobj(matplotlib.text.Text)]


ABLATION = table(
    """\
group,change,scene,status,crossing,attempts,compared,full_leak_mm2,leak_change_mm2,rms_mm,seconds,time_ratio
tissue,a,s,converged,false,1,true,8,-3,0.5,0.01,2
tissue,a,t,converged,false,2,true,8,1,0.5,0.01,2
tissue,a,u,converged,true,1,false,8,99,0.5,0.01,2
to compare,b,s,converged,false,1,true,8,0.25,0.1,0.01,1
"""
)
GROWTH = table(
    """\
part,triangles,steps_before,microseconds
step,100,250,10
step,1000,250,1000
set-up,100,0,5
set-up,1000,0,50
"""
)
ACCURACY = table(
    """\
scene,method,membrane,triangles,tolerance,status,crossing,seconds,rms_mm,max_mm,leak_error_mm2
s,fast,springs,648,0.01,converged,false,0.01,0.5,1,-0.5
s,fast,continuum,648,0.01,converged,false,0.02,0.6,1,0.6
s,fast,continuum,1296,0.01,converged,false,0.1,0.25,1,0.25
s,fast,continuum,648,0.01,converged,true,0.001,0.01,1,0.01
"""
)
STABILITY = table(
    """\
scene,axis,level,nominal,method,outcome,attempts
s,pressure,16,true,m,other_equilibrium,1
s,pressure,100,false,m,crosses,1
s,pressure,100,false,ladder,settles,3
t,pressure,16,true,m,settles,1
"""
)


UNIQUENESS = table(
    """\
kind,valve,seed,scene,bending_n_mm,status,crossing,attempts,steps,compared,rms_mm,leak_difference_mm2
known,v,5,0,0,converged,false,1,300,true,0.2,-3
known,v,5,1,0,converged,false,2,500,true,0.01,0
known,v,5,2,0,converged,true,2,900,false,,
known,v,5,0,0.03,converged,false,1,300,true,0.01,0.5
"""
)
VERDICTS = table(
    """\
valve,held_out,plan,own_trusted,own_leak_mm2,fine_trusted,fine_leak_mm2,reference_trusted,reference_leak_mm2
a,false,0,true,0.5,true,2,true,1.5
a,false,1,true,0,true,0,true,0
b,true,0,true,3,true,0.9,true,0.8
b,true,1,true,0.2,true,0.4,false,
"""
)


class Ablation(unittest.TestCase):
    def test_medians_and_largest_are_of_what_compares_and_the_rest_is_counted(self):
        said = texts(plot.draw_ablation(ABLATION))
        self.assertEqual(said.count("2.0"), 3, "leak: median; time: median and largest")
        self.assertIn("3.0", said)
        self.assertIn("1 failed", said)
        for name in ("tissue", "a", "to compare", "b"):
            self.assertIn(name, said)


class SpeedAccuracy(unittest.TestCase):
    def test_the_front_passes_over_what_is_beaten(self):
        self.assertEqual(plot.front([(10, 0.5), (20, 0.6), (100, 0.25)]), [(10, 0.5), (100, 0.25)])

    def test_what_crossed_is_not_drawn(self):
        axis = plot.draw_speed_accuracy(ACCURACY).axes[0]
        best = next(line for line in axis.lines if line.get_label() == "continuum, best for its time")
        self.assertEqual(list(best.get_ydata()), [0.6, 0.25])
        self.assertEqual(sum(len(points.get_offsets()) for points in axis.collections), 3)


class Stability(unittest.TestCase):
    def test_each_outcome_is_a_letter_too_with_the_attempts_of_the_ladder(self):
        said = texts(plot.draw_stability(STABILITY))
        self.assertEqual([said.count(cell) for cell in ("O", "X", "S", "S3")], [1, 1, 1, 1])
        self.assertEqual(said.count("pressure, kPa"), 2, "a panel for each scene and axis")
        self.assertIn("ladder", said)


class Uniqueness(unittest.TestCase):
    def test_scenes_that_do_not_compare_count_among_attempts_alone(self):
        s = uniqueness.summary(UNIQUENESS[:3])
        self.assertEqual((s["scenes"], s["compared"], s["elsewhere"], s["second_attempts"]), (3, 2, 1, 2))
        self.assertEqual((s["leak_max_mm2"], s["median_steps"]), (3, 500))
        self.assertAlmostEqual(s["leak_p90_mm2"], 2.7)

    def test_there_is_a_point_for_each_rigidity(self):
        share = uniqueness.draw_uniqueness(UNIQUENESS).axes[0]
        self.assertEqual(list(share.lines[0].get_ydata()), [50, 0])


class Verdicts(unittest.TestCase):
    def test_what_is_not_trusted_is_not_competent_and_not_drawn(self):
        self.assertEqual(verdicts.agreement(VERDICTS, "own"), (1, 2, 1))
        self.assertEqual(verdicts.agreement(VERDICTS, "fine"), (3, 1, 0))
        figure = verdicts.draw_verdicts(VERDICTS)
        self.assertEqual(sum(len(points.get_offsets()) for points in figure.axes[0].collections), 3)
        self.assertIn("b (held out)", texts(figure))


class Program(unittest.TestCase):
    def test_it_draws_a_table_beside_it_the_same_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            ecdf = pathlib.Path(folder) / "ecdf.csv"
            ecdf.write_text("method,closures,share\ncoapt,10,0.5\ncoapt,20,1\nrandom,40,0.25\n")
            drawn = []
            for _ in range(2):
                plot.main([str(ecdf)])
                drawn.append(ecdf.with_suffix(".png").read_bytes())
            self.assertEqual(drawn[0], drawn[1])
            self.assertEqual(drawn[0][:4], b"\x89PNG")

    def test_a_table_of_another_name_is_refused(self):
        with self.assertRaises(SystemExit) as refused, unittest.mock.patch("sys.stderr", io.StringIO()):
            plot.main(["weather.csv"])
        self.assertEqual(refused.exception.code, 2)


class Growth(unittest.TestCase):
    def test_the_legend_says_how_each_part_grows(self):
        words = texts(plot.growth.draw_growth(GROWTH))
        self.assertIn("step, after 250 steps: N^2.00", words)
        self.assertIn("set-up: N^1.00", words)


if __name__ == "__main__":
    unittest.main()
