"""Nothing that strangers have written moves the terminal: names in valves, plans and files, and what services answer."""

import contextlib
import http.client
import http.server
import json
import os
import pty
import re
import subprocess
import threading
import unittest

from process_runs import HANGS_S
from programs import COAPT, NO_COMPETENT_PLAN, NOT_CLOSED, OK, ProgramTest, small_valve
from server_runs import ServerTest

BAD = "\x1b[2J\x07\u009b31m\rx"
SHOWN = "31m x"  # what is left of it
MOVES = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
RING = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "generic-classic", "size_mm": 30}]}


class Shown(ProgramTest):
    def check(self, *arguments):
        run = subprocess.run([COAPT, *map(str, arguments)], capture_output=True, timeout=HANGS_S)
        run.stdout, run.stderr = run.stdout.decode(), run.stderr.decode()  # text=True would make \r an end of a line
        for text in (run.stdout, run.stderr):
            found = MOVES.search(text)
            self.assertIsNone(found, f"{arguments}: {found and text[max(0, found.start() - 80) : found.end() + 40]!r}")
        return run

    def check_ok(self, *arguments):
        run = self.check(*arguments)
        self.assertIn(run.returncode, (OK, NOT_CLOSED, NO_COMPETENT_PLAN), (arguments, run.stderr))
        return run.stdout


class Terminal(Shown):
    def named_valve(self):
        valve = json.loads(small_valve().read_text())
        valve["name"], valve["provenance"] = BAD, [BAD]
        valve["chordae"][0]["id"] = BAD
        return valve

    def test_names_in_files_are_printed_without_control_characters(self):
        valve = self.named_valve()
        named = self.write("named.json", valve)
        wrong = self.write("wrong.json", {**valve, BAD: 1, "chordae": [{**valve["chordae"][0], BAD: 2}]})
        cut = self.write("cut.json", {"schema": "coapt.plan/1", "steps": [{"step": "chordal_excision", "chorda": BAD}]})
        step = self.write("step.json", {"schema": "coapt.plan/1", "steps": [{"step": BAD}]})
        for command in (("close",), ("valve", "info"), ("valve", "check"), ("diagnose",), ("open",)):
            self.check(*command, named)
            self.check(*command, wrong)
        for plan in (cut, step):
            self.check("close", named, "--plan", plan)
            self.check("evaluate", named, plan)
        self.check("compare", named, small_valve())
        self.check("study", "physiology", named)
        self.check("plan", named, "--evaluations", 6, "--plans", 1, "--region-points", 2, "-o", self.folder / "x.html")
        self.check_ok("study", "information", named, "--draws", 2)
        self.check_ok("study", "model", named, "--draws", 2, "-o", self.folder / "model")
        self.check_ok("observe", named, "--leak", 30, "--leak-sd", 8, "--source", BAD, "-o", self.folder / "seen.json")
        self.check_ok("close", self.folder / "seen.json", "--draws", 2)
        self.check_ok("train", "case", named, "--exam", "A", "--seed", 7, "-o", self.folder / "case")

    def test_json_is_escaped_and_otherwise_the_same(self):
        name = BAD + "\x7f\u202e\u2066"
        named = self.write("named.json", {**self.named_valve(), "name": name})
        for command, member in ((("valve", "info"), "name"), (("close",), "valve"), (("open",), "name")):
            self.assertEqual(json.loads(self.check_ok(*command, named, "--json"))[member], name)
        made = self.check_ok("valve", "remodel", named, "--ap-dilation", 5, "--name", name, "-o", "-")
        self.assertEqual(json.loads(made)["name"], name)

    def test_names_of_files_need_not_be_utf_8(self):
        odd = os.fsdecode(bytes(self.folder) + b"/\xff.json")
        with open(odd, "w") as file:
            file.write(small_valve().read_text())
        run = subprocess.run([COAPT, "compare", odd, odd, "--json"], capture_output=True, timeout=HANGS_S)
        self.assertEqual((run.returncode, run.stderr), (OK, b""))
        self.assertIn("\ufffd", json.loads(run.stdout)["closed"]["source"])

    def test_so_are_names_of_files_and_words_of_a_command(self):
        odd = self.write(BAD + ".json", "{")
        for command in (("close",), ("diagnose",), ("plan",), ("valve", "info"), ("valve", "check"), ("prefer",)):
            self.check(*command, odd)
        self.check("close", small_valve(), "--plan", odd)
        self.check("valve", "import", "--leaflet", odd, "-o", self.folder / "valve.json")
        self.check("export", small_valve(), "-o", f"/no/{BAD}.stl")
        for words in (
            (BAD,),
            ("--" + BAD,),
            ("close", BAD),
            ("valve", "make", BAD),
            ("plan", small_valve(), "--forbid", BAD),
        ):
            self.assertNotEqual(self.check(*words).returncode, 0)
        self.check("close", "human-normal", "--server", "http://" + BAD)

    def test_so_are_names_of_files_that_can_be_read_and_of_folders(self):
        odd, folder = self.write(BAD + ".json", small_valve().read_text()), self.folder / BAD
        plan = self.write(BAD + "-plan.json", RING)
        one = ("--evaluations", 6, "--plans", 1, "--region-points", 2)
        for command in (
            ("compare", odd, small_valve()),
            ("compare", small_valve(), odd),
            ("evaluate", small_valve(), plan, "--region-points", 2, "--no-evidence"),
            ("plan", odd, small_valve(), *one, "-o", folder),
            ("study", "model", odd, "--draws", 2, "-o", folder),
            ("study", "annulus", small_valve("porcine-3"), "-o", folder),
            ("train", "case", odd, "--exam", "A", "--seed", 7, "-o", folder),
        ):
            self.assertIn(SHOWN, self.check_ok(*command), command)


class Liar(http.server.BaseHTTPRequestHandler):
    """Passes requests on to a coapt-server, and lies in each name and word of its answers but those by which the command line finds what
    it shows."""

    KEPT = {"id", "state", "format", "pairing", "fitted", "base64"}

    def lies(self, told):
        if isinstance(told, dict) and "bytes" not in told:
            lies = {name: value if name in self.KEPT else self.lies(value) for name, value in told.items()}
            return lies | {BAD: BAD}
        if isinstance(told, list):
            return list(map(self.lies, told))
        return told + BAD if isinstance(told, str) else told

    def lied(self, body):
        return json.dumps(self.lies(json.loads(body)), ensure_ascii=False).encode()

    def pass_on(self):
        asked = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        connection = http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=HANGS_S)
        with contextlib.closing(connection):
            connection.request(self.command, self.path, asked, {"Content-Type": "application/json"})
            answer = connection.getresponse()
            self.send_response(answer.status)
            for name in ("Content-Type", "Content-Disposition", "Retry-After"):
                if name in answer.headers:
                    self.send_header(name, answer.headers[name])
            self.end_headers()
            if "json" in answer.headers.get("Content-Type", ""):
                self.wfile.write(self.lied(answer.read()))
            for line in answer:
                event = line.startswith(b"data: {")
                self.wfile.write(b"data: " + self.lied(line[6:]) + b"\n" if event else line)

    do_GET = do_POST = pass_on

    def log_message(self, *_):
        pass


class Climber(Liar):
    """Tells names that lead out of any folder."""

    def lies(self, told):
        if isinstance(told, dict):
            return {
                name: f"../{value}" if name == "name" and isinstance(value, str) else self.lies(value)
                for name, value in told.items()
            }
        return list(map(self.lies, told)) if isinstance(told, list) else told


def on_terminal(*arguments):
    """What a terminal gets of standard output."""
    terminal, output = pty.openpty()
    process = subprocess.Popen(
        [COAPT, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.DEVNULL
    )
    os.close(output)
    text = b""
    try:
        while part := os.read(terminal, 1 << 16):
            text += part
    except OSError:  # the program has ended
        pass
    os.close(terminal)
    process.wait(HANGS_S)
    return text.decode().replace("\r\n", "\n")


class LyingService(Shown, ServerTest):
    def serve(self, handler):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        server.port = self.server.port
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        return ("--server", f"http://127.0.0.1:{server.server_port}")

    def setUp(self):
        super().setUp()
        self.liar = self.serve(Liar)

    def test_every_command_shows_its_answers_without_control_characters(self):
        valve, ring = small_valve(), self.write("ring.json", RING)
        closed, out = self.folder / "closed.ply", self.folder / "out"
        self.run_ok("close", valve, "--closed", closed)
        one = ("--region-points", 2, "--no-evidence")
        for command in (
            ("close", valve, "--open"),
            ("close", valve, "--draws", 2),
            ("close", valve, "--certainty", "sure"),
            ("diagnose", valve),
            ("open", valve),
            ("compare", valve, valve),
            ("evaluate", valve, ring, ring, *one),
            ("plan", valve, "--evaluations", 6, "--plans", 1, *one),
            ("fit", valve, "--closed", closed, "--side", "middle", "--frame", "valve", "--rounds", 1, "-o", out),
            ("study", "physiology", valve),
            ("study", "information", valve, "--draws", 2),
            ("study", "model", valve, "--draws", 2, "-o", self.folder / "model"),
            ("study", "annulus", small_valve("porcine-3"), "-o", self.folder / "annulus"),
        ):
            with self.subTest(command=command[:2]):
                self.assertIn(SHOWN, self.check_ok(*command, *self.liar))
                told = json.loads(self.check_ok(*command, *self.liar, "--json"))
                self.assertIn(" [2J  " + SHOWN, told)
        self.check_ok("export", valve, "-o", self.folder / "x.stl", *self.liar)

    def test_no_file_is_written_beside_the_folder(self):
        climber, folder = self.serve(Climber), self.folder / "deep" / "model"
        self.check("study", "model", small_valve(), "--draws", 2, "-o", folder, *climber)
        self.assertIn("index.html", os.listdir(folder))
        self.check("export", small_valve(), "-o", str(self.folder / "deep" / "heart") + "/", *climber)
        self.assertLessEqual(set(os.listdir(self.folder / "deep")), {"model", "heart"})

    def test_nor_do_refusals_move_the_terminal(self):
        seen = self.folder / "seen.json"
        for command in (
            ("close", "no-such"),
            ("observe", small_valve(), "--leak", 30, "--leak-sd", 8, "-o", seen),
            ("plan", "no-such"),
        ):
            self.assertIn(SHOWN, self.check(*command, *self.liar).stderr)

    def test_an_answer_as_it_is_is_escaped(self):
        request = self.write("request.json", {"valve": "human-functional-mr"})
        for name in ("close", "diagnose"):
            told = json.loads(self.check_ok("operations", name, "--request", request, *self.liar))
            self.assertEqual(told[BAD], BAD)

    def test_files_are_printable_on_a_terminal_and_as_they_are_elsewhere(self):
        class File(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                self.send_response(200)
                self.send_header("Content-Type", "text/plain")
                self.end_headers()
                self.wfile.write(f"one{BAD}\ntwo".encode())

            def log_message(self, *_):
                pass

        request = self.write("request.json", {"valve": "human-normal"})
        command = ("operations", "close", "--request", request, *self.serve(File))
        self.assertEqual(on_terminal(*command), f"one [2J  {SHOWN}\ntwo")
        run = subprocess.run([COAPT, *map(str, command)], capture_output=True, timeout=HANGS_S)
        self.assertEqual(run.stdout, f"one{BAD}\ntwo".encode())

    def test_what_is_nested_without_end_is_refused(self):
        class Deep(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                self.send_response(200)
                self.send_header("Content-Type", "application/json")
                self.end_headers()
                self.wfile.write(b"[" * 1_000_000 + b"]" * 1_000_000)

            def log_message(self, *_):
                pass

        run = self.check("close", "human-normal", "--json", *self.serve(Deep))
        self.assertIn("did not answer with JSON", run.stderr)


if __name__ == "__main__":
    unittest.main()
