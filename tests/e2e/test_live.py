"""coapt-live, with a script for a hand and with a simulated Haply Inverse3."""

import csv
import json
import os
import re
import signal
import socket
import subprocess
import time
import unittest

from haply_service import HaplyService
from helps import NOTICE, about, flags, help_of
from process_runs import HANGS_S, catches, wait_until
from programs import BAD_INPUT, FAILURE, INTERRUPTED, OK, SOURCE, ProgramTest

LIVE = os.environ["COAPT_LIVE"]
VALVE = "human-p2-prolapse"
LARGEST_N = 3.0


def live(*arguments):
    return subprocess.run([LIVE, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS_S)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


class Scripted(ProgramTest):
    def script(self, *rows):
        return self.write("hand.csv", "t_ms,x,y,z,button\n" + "".join(f"{row}\n" for row in rows))

    def test_a_pull_is_felt_and_gives_nothing_back(self):
        pull = self.script(
            "0,0,-4,-8,0", "100,0,-4,-8,1", "600,0,-4,0,1", "1100,0,-4,-8,1", "1200,0,-4,-8,0", "1300,0,-4,-8,0"
        )
        record = self.folder / "felt.csv"
        result = live(VALVE, "--device", f"stylus:{pull}", "--json", "--record", record)
        self.assertEqual(result.returncode, OK, result.stderr)
        figures = json.loads(result.stdout)
        self.assertEqual((figures["schema"], figures["notice"]), ("coapt.live/1", NOTICE))
        self.assertEqual((figures["end"], figures["rate_hz"], figures["grasps"]), ("device", 1000.0, 1))
        self.assertAlmostEqual(figures["periods"] + figures["periods_missed"], 1300, delta=10)
        self.assertGreater(figures["steps_per_second"], 0)
        self.assertGreater(figures["late_us"]["largest"], 0)
        self.assertGreaterEqual(figures["lowest_energy_mj"], -0.001 - 1.0 * (figures["periods_missed"] > 0))

        with record.open() as file:
            rows = [{name: float(text) for name, text in row.items()} for row in csv.DictReader(file)]
        self.assertEqual(len(rows), figures["periods"])
        forces = [(row["fx"], row["fy"], row["fz"]) for row in rows]
        self.assertEqual(max(dot(force, force) ** 0.5 for force, row in zip(forces, rows) if not row["holds"]), 0)
        largest = max(dot(force, force) ** 0.5 for force in forces)
        self.assertGreater(largest, 0.3)
        self.assertLess(largest, LARGEST_N + 1e-3)
        self.assertAlmostEqual(largest, figures["largest_force_n"], delta=1e-3)
        # It is pulled up, and the tissue pulls back down.
        self.assertLess(min(force[2] for force in forces), -0.3)

    def test_the_time_may_end_it_and_so_may_a_plan_be_applied(self):
        still = self.script("0,0,0,0,0", "60000,0,0,0,0")
        plan = SOURCE / "examples/plans/ring.json"
        result = live(
            "human-functional-mr",
            "--plan",
            plan,
            "--pressure",
            0,
            "--device",
            f"stylus:{still}",
            "--seconds",
            0.3,
            "--rate",
            500,
        )
        self.assertEqual(result.returncode, OK, result.stderr)
        told = re.match(r"(\d+) periods of 2 ms in \d+\.\d s, (\d+) missed; late by \d+ us \(median\)", result.stdout)
        self.assertTrue(told, result.stdout)
        self.assertLess(sum(map(int, told.groups())), 30000)  # of the script's minute

    def test_an_interrupt_ends_it_with_its_figures(self):
        still = self.script("0,0,0,0,0", "60000,0,0,0,0")
        with subprocess.Popen(
            [LIVE, VALVE, "--device", f"stylus:{still}", "--json"], stdout=subprocess.PIPE, text=True
        ) as run:
            wait_until(lambda: catches(run, signal.SIGINT))
            run.send_signal(signal.SIGINT)
            figures = json.loads(run.communicate(timeout=HANGS_S)[0])
        self.assertEqual((run.returncode, figures["end"]), (INTERRUPTED, "interrupt"))

    def test_the_example_is_a_script(self):
        result = live(VALVE, "--device", f"stylus:{SOURCE}/examples/live/pull.csv", "--seconds", 0.1)
        self.assertEqual(result.returncode, OK, result.stderr)

    def test_bad_scripts_are_refused_line_by_line(self):
        bad = self.script("0,0,0,0,0", "1,0,0,x,0", "2,0,5000,0,0", "2,0,0,0,0", "3,0,0,0,2")
        result = live(VALVE, "--device", f"stylus:{bad}")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        said = result.stderr.splitlines()
        for line, words in zip(
            said,
            (
                "line 3: z is not a number, must be from -1000 to 1000 mm",
                "line 4: y is 5000, must be from -1000 to 1000 mm",
                "line 5: t_ms is 2",
                "line 6: button is 2, must be 0 or 1",
            ),
        ):
            self.assertIn(words, line)
        self.assertEqual(len(said), 4)
        self.assertIn(
            "has no column button", live(VALVE, "--device", f"stylus:{self.write('a.csv', 't_ms,x,y,z')}").stderr
        )

    def test_a_valve_under_more_pressure_than_a_live_one_takes_is_refused(self):
        still = self.script("0,0,0,0,0", "100,0,0,0,0")
        valve = json.loads(self.make(VALVE).read_text())
        tense = self.write("tense.json", {**valve, "pressure_kpa": 40.0})
        result = live(tense, "--device", f"stylus:{still}")
        self.assertEqual((result.returncode, result.stdout), (BAD_INPUT, ""))
        self.assertIn("/pressure_kpa: is 40, must be from 0 to 33.3305 kPa, or give --pressure", result.stderr)
        self.assertEqual(live(tense, "--device", f"stylus:{still}", "--pressure", 120).returncode, OK)

    def test_bad_usage_is_refused(self):
        still = self.script("0,0,0,0,0")
        for arguments in (
            ["--device", "mouse"],
            ["--device", "haply:http://x"],
            ["--device", f"stylus:{still}", "--rate", "0"],
            [],
        ):
            with self.subTest(arguments):
                self.assertEqual(live(VALVE, *arguments).returncode, BAD_INPUT)
        self.assertEqual(live("no-such-valve", "--device", f"stylus:{still}").returncode, BAD_INPUT)


class Haply(ProgramTest):
    def test_a_simulated_inverse3_is_held_back_and_never_fed(self):
        def cursor(seconds):
            # Rests for 0.2 s, takes hold, goes up by 10 mm and back within a second, lets go. Its own frame has another origin.
            up = 0.01 * min(1.0, max(0.0, 1.0 - abs(seconds - 0.9) / 0.5))
            return (0.05, -0.1, 0.15 + up), 0.2 <= seconds < 1.6

        with HaplyService(cursor) as service:
            result = live(VALVE, "--device", f"haply:{service.url}", "--seconds", 1.7, "--json")
        self.assertEqual(result.returncode, OK, result.stderr)
        figures = json.loads(result.stdout)
        self.assertEqual((figures["end"], figures["grasps"]), ("time", 1))
        felt = service.felt
        self.assertGreater(len(felt), 100)
        self.assertEqual(max(dot(force, force) for seconds, _, _, force in felt if seconds < 0.2), 0)
        self.assertLess(max(dot(force, force) ** 0.5 for _, _, _, force in felt), LARGEST_N + 1e-6)
        self.assertLess(min(force[2] for _, _, _, force in felt), -0.1)
        # What the hand did, J: each force lasts until the next state.
        work = -sum(dot(before[3], minus(after[1], before[1])) for before, after in zip(felt, felt[1:]))
        self.assertGreater(work, -1e-3)
        self.assertEqual(felt[-1][3], (0.0, 0.0, 0.0))

    def test_a_device_that_hangs_up_is_lost(self):
        with HaplyService(lambda seconds: None if seconds > 0.3 else ((0, 0, 0), False)) as service:
            result = live(VALVE, "--device", f"haply:{service.url}", "--json")
        self.assertEqual(result.returncode, FAILURE)
        self.assertEqual(json.loads(result.stdout)["end"], "lost")
        self.assertRegex(result.stderr, rf"coapt-live: haply:{service.url}: was lost: ")

    def test_a_device_that_tells_no_place_is_lost(self):
        no_place = "no Inverse3 reported a place from -1000 to 1000 mm for 1 s"
        for name, told, problem in (
            ("a flood of garbage", "[]", no_place),
            ("a place out of range", ((1.5, 0, 0), False), no_place),
            ("an oversized message", "x" * 70000, "a message of the service has more than 64 KiB"),
        ):
            with self.subTest(name):

                def cursor(seconds, told=told):
                    return told if seconds > 0.3 else ((0, 0, 0), False)

                with HaplyService(cursor) as service:
                    result = live(VALVE, "--device", f"haply:{service.url}", "--seconds", 5, "--json")
                self.assertEqual(result.returncode, FAILURE)
                self.assertEqual(json.loads(result.stdout)["end"], "lost")
                self.assertIn(f"was lost: {problem}", result.stderr)

    def test_the_account_is_that_of_the_device_where_states_come_slower_than_periods(self):
        def cursor(seconds):
            # 10 ms a state: up by 4 mm and back.
            time.sleep(0.01)
            up = 0.004 * max(0.0, 1.0 - abs(seconds - 0.9) / 0.6)
            return (0, 0, up), 0.2 <= seconds < 1.6

        with HaplyService(cursor) as service:
            result = live(VALVE, "--device", f"haply:{service.url}", "--seconds", 1.9, "--json")
        self.assertEqual(result.returncode, OK, result.stderr)
        figures = json.loads(result.stdout)
        felt = service.felt
        self.assertEqual(figures["grasps"], 1)
        self.assertGreater(figures["periods"] + figures["periods_missed"], 2 * len(felt))
        work = -sum(dot(before[3], minus(after[1], before[1])) for before, after in zip(felt, felt[1:]))
        self.assertAlmostEqual(figures["energy_mj"], 1e3 * work, delta=1e-6)
        self.assertGreaterEqual(figures["lowest_energy_mj"], -0.001001)

    def test_a_service_that_is_not_there_is_said(self):
        with socket.create_server(("127.0.0.1", 0)) as free:
            port = free.getsockname()[1]
        result = live(VALVE, "--device", f"haply:ws://127.0.0.1:{port}")
        self.assertEqual((result.returncode, result.stdout), (FAILURE, ""))
        self.assertIn("cannot be reached", result.stderr)


class Help(unittest.TestCase):
    def test_version_and_help_say_what_coapt_is_not(self):
        self.assertRegex(live("--version").stdout, about("coapt-live"))
        self.assertIn(NOTICE, help_of(LIVE))

    def test_the_man_page_has_every_option_and_no_other(self):
        page = (SOURCE / "docs/man/coapt-live.1.scd").read_text()
        self.assertEqual(set(re.findall(r"^\*(--?\w+)\*", page, re.MULTILINE)) | {"--help"}, flags(help_of(LIVE)))


if __name__ == "__main__":
    unittest.main()
