"""coapt --server: the same as without, through a coapt-server."""

import http.server
import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import threading
import unittest

from plan_runs import BARE, VALVE, options
from process_runs import HANGS_S, wait_until
from programs import BAD_INPUT, COAPT, FAILURE, INTERRUPTED, OK, ProgramTest, coapt, small_valve
from relay import Relay
from server_runs import ServerTest

RING = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": 30}]}
OWN = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": 1}]}
LONG = {
    "schema": "coapt.plan/1",
    "steps": [
        {"step": "papillary_approximation", "side": "posteromedial", "anchor": "saddle_peak", "suture_length_mm": 99}
    ],
}
BOTH = {
    "schema": "coapt.plan/1",
    "steps": [
        {"step": "papillary_approximation", "side": side, "anchor": "ipsilateral_trigone", "suture_length_mm": 26}
        for side in ("anterolateral", "posteromedial")
    ],
}
TOKEN = "open-sesame-2026"
PICTURE = re.compile(r'<svg.*?</svg>|data:image/png;base64,[^"]+', re.DOTALL)


def without_seconds(text):
    return re.sub(r"\d+\.\d+ s\b", "S s", re.sub(r'"seconds":\s*[-0-9.e]+', '"seconds": 0', text))


class ThroughService(ServerTest):
    def remote(self, *arguments, stdin=""):
        return coapt(*arguments, "--server", self.url, stdin=stdin)

    def assert_same(self, *arguments, stdin=""):
        """What is printed, and the exit code, here and through the service; they are the same but for seconds."""
        here, there = coapt(*arguments, stdin=stdin), self.remote(*arguments, stdin=stdin)
        self.assertEqual(without_seconds(there.stdout), without_seconds(here.stdout))
        self.assertEqual((there.returncode, there.stderr), (here.returncode, here.stderr))
        return there


class SameOutput(ThroughService):
    def setUp(self):
        super().setUp()
        self.ring, self.own, self.long, self.both = (
            self.write(f"{name}.json", plan)
            for name, plan in [("ring", RING), ("own", OWN), ("long", LONG), ("both", BOTH)]
        )

    def test_closures_are_the_same(self):
        file = small_valve()
        for arguments in [
            (VALVE,),
            (file,),
            (file, "--plan", self.ring),
            (VALVE, "--json"),
            (file, "--plan", self.ring, "--json"),
        ]:
            self.assertEqual(self.assert_same("close", *arguments).returncode, OK)
        self.assert_same("close", "-", stdin=file.read_text())

    def test_openings_are_the_same(self):
        for more in (
            [],
            ["--plan", self.ring],
            ["--json"],
            ["--flow", 200, "--exercise", 2, "--plan", self.ring, "--json"],
        ):
            self.assertEqual(self.assert_same("open", small_valve(), *more).returncode, OK)

    def test_pictures_are_the_same(self):
        for more in ([], ["--plan", self.ring]):
            here, there = self.folder / "here.png", self.folder / "there.png"
            self.assertEqual(
                (
                    coapt("close", small_valve(), *more, "--render", here).returncode,
                    self.remote("close", small_valve(), *more, "--render", there).returncode,
                ),
                (OK, OK),
            )
            self.assertEqual(there.read_bytes(), here.read_bytes())
        piped = self.remote("close", "-", "--render", there, stdin=small_valve().read_text())
        self.assertEqual((piped.returncode, piped.stderr), (OK, ""))

    def test_evaluations_are_the_same(self):
        valve = small_valve()
        for more in ([], ["--json"]):
            self.assert_same("evaluate", valve, self.own, self.ring, "--no-evidence", "--region-points", 9, *more)
        self.assert_same("evaluate", valve, self.own, self.own, "--no-evidence", "--region-points", 1, "--json")
        # Enough nodes for a ladder.
        self.assert_same("evaluate", valve, self.own, self.ring, "--no-evidence", "--region-points", 70)

    def test_evaluations_of_an_observed_valve_are_weighed_alike(self):
        seen = self.folder / "seen.json"
        self.run_ok("observe", small_valve(), "--leak", 40, "--leak-sd", 8, "-o", seen)
        self.assert_same("evaluate", seen, self.ring, "--no-evidence", "--region-points", 2, "--json")
        self.assert_same("evaluate", seen, self.ring, "--no-evidence", "--region-points", 2, "--model-draws", 0)

    def test_searches_are_the_same(self):
        self.assert_same("plan", VALVE, *options(**BARE), "--json")
        self.assert_same("plan", small_valve(), *options(), "--forbid", "annuloplasty:own", "--fix", self.ring)

    def test_a_search_from_a_file_has_the_same_report(self):
        search = self.write(
            "search.json",
            {"evaluations": 8, "plans": 1, "region_points": 2, "evidence": False, "weights": {"movement": 0.5}},
        )
        self.assert_same_pictures("plan", small_valve(), "--search", search, "--seed", 7)

    def test_a_report_on_own_plans_is_the_same(self):
        more = ("--region-points", 2, "--json")
        self.assert_same_pictures("evaluate", small_valve(), self.own, self.ring, "--no-evidence", *more)
        self.assert_same_pictures("evaluate", small_valve(), self.both, *more)

    def assert_same_pictures(self, *command):
        """Nor does what is printed differ."""
        page, pages = self.folder / "report.html", []

        def run(run_it):
            result = run_it(*command, "-o", page)
            self.assertIn(result.returncode, (0, 4))
            pages.append(without_seconds(page.read_text()))
            return without_seconds(result.stdout), result.returncode, result.stderr

        self.assertEqual(run(self.remote), run(coapt))
        # They differ in the command line that a page tells: a request has none.
        pictures = [PICTURE.findall(page) for page in pages]
        self.assertGreater(len(pictures[0]), 1)
        self.assertEqual(pictures[1], pictures[0])

    def test_a_study_is_the_same_with_all_its_files(self):
        here, there = self.folder / "here", self.folder / "there"
        valve = small_valve("porcine-3")
        one = coapt("study", "annulus", valve, "-o", here)
        other = self.remote("study", "annulus", valve, "-o", there)
        self.assertEqual((one.returncode, other.returncode, other.stderr), (OK, OK, ""))
        self.assertEqual(without_seconds(other.stdout).replace(str(there), str(here)), without_seconds(one.stdout))
        names = {file.name for file in here.iterdir() if not file.name.startswith("closures.sqlite")}
        self.assertEqual({file.name for file in there.iterdir()}, names)
        for name in names:
            self.assertEqual(
                without_seconds((there / name).read_text()), without_seconds((here / name).read_text()), name
            )
        again = self.remote("study", "annulus", valve, "-o", there, "--json")
        study = json.loads(again.stdout)
        self.assertEqual(study["closures"], study["closures_known"])

    def test_a_study_with_options_is_asked_for_as_it_is_here(self):
        self.assertEqual(
            self.remote(
                "study",
                "approximation",
                small_valve("porcine-thesis"),
                "--displacement-step",
                6,
                "--region-points",
                17,
                "--protocol",
                "lookup-clamped",
                "--scan-sites",
                0,
                "-o",
                self.folder / "s",
            ).returncode,
            OK,
        )
        asked = self.curl("/v1/jobs")[2]["jobs"][0]
        self.assertEqual((asked["kind"], asked["state"]), ("study", "SUCCEEDED"))

    def test_what_is_wrong_is_told_in_the_same_words(self):
        broken = self.write("broken.json", {"schema": "coapt.valve/1"})
        for arguments in [
            ("close", broken),
            ("close", VALVE, "--plan", self.long),
            ("close", VALVE, "--plan", "none.json"),
            ("evaluate", VALVE, self.own, self.long, "--no-evidence", "--region-points", "1"),
            ("plan", VALVE, "--forbid", "nothing"),
            ("plan", VALVE, "--fix", self.long),
            ("plan", broken),
        ]:
            self.assertEqual(self.assert_same(*map(str, arguments)).returncode, BAD_INPUT, arguments)

    def test_a_valve_that_the_service_has_stored_is_named_by_its_id(self):
        stored = self.post("/v1/valves", self.make(VALVE).read_text())[2]["id"]
        self.assertEqual(
            without_seconds(self.remote("close", stored).stdout), without_seconds(coapt("close", VALVE).stdout)
        )
        unknown = self.remote("close", "no-such-valve")
        self.assertEqual(unknown.returncode, BAD_INPUT)
        self.assertTrue(unknown.stderr.startswith("coapt: no-such-valve: "), unknown.stderr)


class OnlyHere(ThroughService):
    def test_what_a_service_does_not_offer_is_a_usage_error_that_names_it(self):
        ring = self.write("ring.json", RING)
        for arguments, named in [
            (("close", VALVE, "--closed", self.folder / "x.ply"), "--closed"),
            (("evaluate", VALVE, ring, "--no-evidence", "--threads", 1), "--threads"),
            (("plan", VALVE, "--store", self.folder / "x.sqlite"), "--store"),
            (("study", "ring", VALVE, "--threads", 1, "-o", self.folder / "s"), "--threads"),
        ]:
            run = self.remote(*arguments)
            self.assertEqual((run.returncode, run.stdout), (BAD_INPUT, ""), arguments)
            self.assertIn(named, run.stderr)
        self.assertEqual(list(self.folder.glob("x.*")), [])

    def test_too_many_closures_at_once_are_refused_with_the_limit(self):
        run = self.remote("evaluate", VALVE, self.write("ring.json", RING), "--no-evidence")
        self.assertEqual(run.returncode, BAD_INPUT)
        self.assertIn("must be at most 500", run.stderr)


class Environment(ThroughService):
    def test_the_address_may_come_from_the_environment(self):
        surroundings = os.environ | {"COAPT_SERVER": "http://127.0.0.1:1"}
        run = subprocess.run([COAPT, "close", VALVE], env=surroundings, capture_output=True, text=True)
        self.assertEqual(run.returncode, FAILURE)
        self.assertIn("http://127.0.0.1:1 does not answer", run.stderr)
        here = subprocess.run([COAPT, "close", VALVE, "--server", ""], env=surroundings, capture_output=True, text=True)
        self.assertEqual(here.returncode, OK, here.stderr)

    def test_an_address_that_is_none_is_a_usage_error(self):
        for url in ("localhost:8080", "http://", "ftp://localhost"):
            run = coapt("close", VALVE, "--server", url)
            self.assertEqual(run.returncode, BAD_INPUT)
            self.assertIn("--server", run.stderr)

    def test_a_token_does_not_go_unencrypted_to_another_machine(self):
        surroundings = os.environ | {"COAPT_TOKEN": TOKEN}
        for url in ("http://plans.invalid", "http://localhost.plans.invalid:8080", "http://127.0.0.1.plans.invalid/"):
            run = subprocess.run(
                [COAPT, "close", VALVE, "--server", url], env=surroundings, capture_output=True, text=True
            )
            self.assertEqual(run.returncode, BAD_INPUT, run.stderr)
            self.assertIn("not encrypted", run.stderr)
        for arguments in (["https://plans.invalid"], ["http://plans.invalid", "--plain-http"], ["http://localhost:1"]):
            run = subprocess.run(
                [COAPT, "close", VALVE, "--server", *arguments], env=surroundings, capture_output=True, text=True
            )
            self.assertEqual(run.returncode, FAILURE, run.stderr)


class Tokens(ThroughService):
    def setUp(self):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.token = folder / "token"
        self.token.write_text(TOKEN + "\n")
        self.token.chmod(0o600)
        self.flags = ("--token-file", self.token)
        super().setUp()

    def test_a_token_comes_from_a_file_or_the_environment(self):
        self.assertEqual(self.remote("close", VALVE, "--token-file", self.token).returncode, OK)
        run = subprocess.run(
            [COAPT, "close", VALVE, "--server", self.url],
            capture_output=True,
            text=True,
            env=os.environ | {"COAPT_TOKEN": TOKEN},
        )
        self.assertEqual(run.returncode, OK, run.stderr)

    def test_a_token_that_would_begin_another_header_is_refused(self):
        run = subprocess.run(
            [COAPT, "close", VALVE, "--server", self.url],
            capture_output=True,
            text=True,
            env=os.environ | {"COAPT_TOKEN": f"{TOKEN}\r\nX: y"},
        )
        self.assertEqual(run.returncode, BAD_INPUT)
        self.assertIn("COAPT_TOKEN has a control character", run.stderr)

    def test_without_it_one_does_not_come_in(self):
        self.assertEqual(self.remote("close", VALVE).returncode, BAD_INPUT)
        wrong = self.write("wrong", "another-token-of-nobody")
        self.assertEqual(self.remote("close", VALVE, "--token-file", wrong).returncode, BAD_INPUT)
        self.assertEqual(self.remote("close", VALVE, "--token-file", self.folder / "none").returncode, BAD_INPUT)


class Interrupted(ThroughService):
    def start(self, *arguments, url=None):
        return subprocess.Popen(
            [COAPT, *map(str, arguments), "--server", url or self.url],
            text=True,
            process_group=0,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    def job_when(self, condition):
        def found():
            return [job["id"] for job in self.curl("/v1/jobs")[2]["jobs"] if condition(job)]

        wait_until(found)
        return found()[0]

    def test_ctrl_c_cancels_the_job_and_prints_its_best_so_far(self):
        run = self.start("plan", small_valve(), "--evaluations", 50000, "--region-points", 2, "--no-evidence")
        job = self.job_when(lambda job: job["progress"]["closures"] > 20)
        os.killpg(run.pid, signal.SIGINT)
        out, err = run.communicate(timeout=HANGS_S)
        self.assertEqual((run.returncode, err), (INTERRUPTED, ""))
        self.assertRegex(out, r"(?m)^   1 ")
        self.assertEqual(self.curl(f"/v1/jobs/{job}")[2]["state"], "CANCELLED")

    def test_a_cancelled_study_says_how_to_continue(self):
        run = self.start("study", "thesis", "porcine-thesis", "-o", self.folder / "s")
        self.job_when(lambda job: job["progress"]["closures"] > 0)
        os.killpg(run.pid, signal.SIGINT)
        _, err = run.communicate(timeout=HANGS_S)
        self.assertEqual(run.returncode, INTERRUPTED)
        self.assertIn("repeat the request to continue", err)

    def test_a_search_is_followed_over_the_death_of_its_service(self):
        relay = Relay(self.server.port)
        self.addCleanup(relay.close)
        run = self.start("plan", VALVE, *options(evaluations=20, **BARE), url=f"http://127.0.0.1:{relay.port}")
        self.job_when(lambda job: job["progress"]["closures"] > 3)
        self.server.kill()
        self.server = self.start_server()
        relay.target = self.server.port
        out, _ = run.communicate(timeout=HANGS_S)
        self.assertEqual(
            without_seconds(re.sub(r", \d+ reused from an earlier run", "", out)),
            without_seconds(coapt("plan", VALVE, *options(evaluations=20, **BARE)).stdout),
        )


class Hostile(ProgramTest):
    """A service that is not one's own."""

    def served(self, answer):
        """The address of what answers every request so: an iterator of parts."""

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                for part in answer():
                    try:
                        self.wfile.write(part)
                    except OSError:
                        return

            def log_message(self, *_):
                pass

        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        return f"http://127.0.0.1:{server.server_port}"

    def test_an_answer_without_end_is_refused_at_the_limit(self):
        def endless():
            yield b"HTTP/1.0 200 OK\r\nContent-Type: application/json\r\n\r\n"
            while True:
                yield b" " * (1 << 20)

        run = coapt("close", "human-normal", "--server", self.served(endless))
        self.assertEqual(run.returncode, FAILURE)
        self.assertIn("256 MiB", run.stderr)

    def test_what_it_says_does_not_move_the_terminal(self):
        problem = {"code": "out_of_range", "path": "/plan\u001b[2J", "message": "\u001b]0;pwned\u0007 \u009b31m\u202e"}
        body = json.dumps({"problems": [problem]}).encode()
        head = b"HTTP/1.0 422 No\r\nContent-Type: application/problem+json\r\nContent-Length: %d\r\n\r\n" % len(body)
        run = coapt("close", "human-normal", "--server", self.served(lambda: [head + body]))
        self.assertNotEqual(run.returncode, OK)
        self.assertIn("pwned", run.stderr)
        self.assertNotRegex(run.stderr, "[\x00-\x09\x0b-\x1f\x7f-\x9f\u202e]")


if __name__ == "__main__":
    unittest.main()
