"""Imports as jobs of coapt-server: a fit that is killed goes on where it was."""

import base64
import json
import os
import pathlib
import re
import signal
import socket
import threading
import time
import unittest

from programs import SOURCE
from server_runs import ServerTest

from grown_files import checkerboard, equal_faces, fans, repeated_arrays  # found through server_runs


def readers_of(server):
    """Processes that read files for it: children of the template, which its keeper has forked."""
    parents = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parents[int(stat.parent.name)] = int(stat.read_text().rsplit(")", 1)[1].split()[1])
        except OSError:  # it has ended meanwhile
            continue
    found = {server.process.pid}
    for _ in ("keeper", "template", "readers"):
        found = {pid for pid, parent in parents.items() if parent in found}
    return list(found)


def processor_s(pid):
    """That a process has used; 0 once it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def peak_mib(pid):
    """Of a process; 0 once it has ended."""
    try:
        status = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0.0
    peak = re.search(r"VmHWM:\s+(\d+) kB", status)
    return int(peak[1]) / 1024 if peak else 0.0


def within(seconds, condition):
    """What it says in the end."""
    until = time.monotonic() + seconds
    while not (said := condition()) and time.monotonic() < until:
        time.sleep(0.02)
    return said


class Imports(ServerTest):
    def request(self, **fit):
        """Open leaflets of a valve, and its closed points with a tip elsewhere."""
        given, truth = self.folder / "given.json", self.folder / "truth.json"
        self.run_ok("valve", "make", "human-functional-mr", "--triangles", 300, "-o", given)
        self.run_ok("valve", "remodel", given, "--displace-al", "1,0,1.5", "-o", truth)
        folder, closed = self.folder / "open", self.folder / "closed.ply"
        self.run_ok("export", given, "--open", "-o", f"{folder}/")
        self.run_ok("export", truth, "-o", closed)
        files = [{"name": file.name, "text": file.read_text()} for file in sorted(folder.iterdir())]
        surface = {"name": "closed.ply", "text": closed.read_text(encoding="latin-1")}
        return {
            "slicerheart": files,
            "triangles": 300,
            "fit": {"surface": surface, "side": "middle"} | fit,
        }

    def result(self, job_id):
        job = self.server.wait_for_end(job_id)
        self.assertEqual(job["state"], "SUCCEEDED", job["problems"])
        return self.server.get(job["links"]["result"])

    def test_a_killed_fit_comes_to_the_valve_of_an_undisturbed_one(self):
        request = self.request(rounds=8)
        undisturbed = self.result(self.server.submit(request, "/v1/imports")["id"])
        self.assertLess(undisturbed["fit"]["rms_mm"], undisturbed["fit"]["rms_before_mm"])
        job = self.server.submit(request, "/v1/imports", {"Idempotency-Key": "again"})
        counts = []
        for at_least in (30, 120):
            self.server.wait_until(job["id"], lambda now: now["progress"]["closures"] > at_least)
            counts.append(self.server.get(f"/v1/jobs/{job['id']}")["progress"]["closures"])
            self.assertEqual(self.server.get(f"/v1/jobs/{job['id']}")["state"], "RUNNING")
            self.server.kill()
            self.server = self.start_server()
            self.assertEqual(
                self.server.submit(request, "/v1/imports", {"Idempotency-Key": "again"})["id"],
                job["id"],
            )
        self.assertEqual(self.result(job["id"]), undisturbed)
        self.assertLess(max(counts), undisturbed["fit"]["closures"])

    def test_a_cancelled_fit_keeps_what_it_has(self):
        job = self.server.submit(self.request(rounds=1000), "/v1/imports")
        self.server.wait_until(job["id"], lambda now: now["progress"]["closures"] > 30)
        self.assertEqual(self.post(f"/v1/jobs/{job['id']}:cancel", "")[0], 200)
        ended = self.server.wait_for_end(job["id"])
        self.assertEqual(ended["state"], "CANCELLED")
        result = self.server.get(ended["links"]["result"])
        self.assertFalse(result["fit"]["finished"])
        self.assertEqual(self.server.get(f"/v1/valves/{result['valve']}")["schema"], "coapt.valve/1")

    def test_an_import_is_that_of_the_command_line(self):
        request = self.request()
        del request["fit"]
        job = self.server.submit(request, "/v1/imports")
        result = self.result(job["id"])
        valve = self.folder / "valve.json"
        picture = self.folder / "valve.png"
        options = ("--triangles", 300, "-o", valve, "--render", picture, "--json")
        printed = self.run_ok("valve", "import", "--slicerheart", self.folder / "open", *options).stdout
        printed = json.loads(printed)
        self.assertEqual(printed, {key: result[key] for key in printed})
        path = result["valve"]
        stored = self.server.get(f"/v1/valves/{path}")
        self.assertEqual(json.loads(valve.read_text())["vertices_mm"], stored["vertices_mm"])
        drawn = self.server.ask("GET", f"/v1/jobs/{job['id']}/files/import.png").body
        self.assertEqual(picture.read_bytes(), drawn)

    def test_a_form_with_files_is_the_same_request(self):
        contract = json.loads((SOURCE / "server/openapi.json").read_text())
        skirt = contract["components"]["examples"]["one_skirt"]["value"]
        fields = []
        for name in ("leaflets", "annulus", "chordae"):
            for file in skirt[name] if name == "leaflets" else [skirt[name]]:
                fields += ["-F", f"{name}=@{self.write(file['name'], file['text'])}"]
        request = {name: skirt[name] for name in ("leaflets", "annulus", "chordae")} | {"triangles": 100}
        asked = self.post("/v1/valves:import", request)
        form = self.curl("/v1/valves:import", *fields, "-F", "triangles=100")
        self.assertEqual(asked[0], 201, asked)
        self.assertEqual((form[0], form[2]), (200, asked[2]))
        self.assert_problem(self.curl("/v1/valves:import", *fields, "-F", "triangles=many"), 422, "/triangles")
        self.assert_problem(self.curl("/v1/closures", *fields), 415)

    LONG = 9000  # triangles: half a minute, and more than a closure may take

    def long_import(self):
        """Two files whose import takes as long as it may."""
        folder = SOURCE / "examples/valves/source/bodyparts3d"
        files = [
            {"name": path.name, "base64": base64.b64encode(path.read_bytes()).decode()}
            for path in (folder / "anterior_leaflet_sheet.obj", folder / "posterior_leaflet_sheet.obj")
        ]
        annulus = folder / "annulus_centerline.csv"
        return {
            "leaflets": files,
            "annulus": {"name": annulus.name, "text": annulus.read_text()},
            "chordae_seed": 1,
            "triangles": self.LONG,
        }

    def test_a_reader_that_is_killed_costs_its_request_alone(self):
        server = self.start_server("long.sqlite", "--vertex-steps", 1e12)
        replies = []
        client = threading.Thread(
            target=lambda: replies.append(server.ask("POST", "/v1/valves:import", self.long_import()))
        )
        client.start()
        readers = within(20, lambda: readers_of(server))
        self.assertEqual(len(readers), 1)
        os.kill(readers[0], signal.SIGKILL)
        client.join()
        self.assertEqual(replies[0].status, 422, replies[0].body)
        self.assertEqual(replies[0].json()["problems"][0]["code"], "input_output")
        self.assertEqual(server.ask("POST", "/v1/closures", {"valve": "human-normal"}).status, 200)
        small = {"files": [self.long_import()["annulus"]]}
        self.assertEqual(server.ask("POST", "/v1/imports:preview", small).status, 200)

    def test_files_that_grow_are_refused_within_64_mib_and_a_second_of_a_core(self):
        compared = {"fans": fans(3800), "equal faces": equal_faces(435_000)}
        for name, request in {
            **{f"map of {side}": checkerboard(side) for side in (128, 160, 230, 256)},
            "vtp": repeated_arrays(200, 7),
            **compared,
        }.items():
            path = "/v1/comparisons" if name in compared else "/v1/valves:import"
            replies, mib, seconds = [], 0.0, 0.0
            asking = lambda: replies.append(self.server.ask("POST", path, request))  # noqa: B023, E731
            client = threading.Thread(target=asking)
            client.start()
            while client.is_alive():
                for reader in readers_of(self.server):
                    mib, seconds = max(mib, peak_mib(reader)), max(seconds, processor_s(reader))
                time.sleep(0.002)
            self.assertEqual(replies[0].status, 422, name)
            if name in compared:
                self.assertIn(b" accepted", replies[0].body, name)
            self.assertLess(mib, 64, name)
            self.assertLess(seconds, 1.0, name)
            if name != "vtp":
                self.assertGreater(mib, 0, "it was seen")

    def test_the_core_is_free_within_a_second_after_the_client_has_gone(self):
        """In processor time, which does not depend on what else the machine does."""
        server = self.start_server("left.sqlite", "--vertex-steps", 1e12, "--vertices", 30_000)
        body = json.dumps(self.long_import() | {"triangles": 40_000}).encode()
        head = f"POST /v1/valves:import HTTP/1.1\r\nHost: localhost\r\nContent-Length: {len(body)}\r\n\r\n"
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(head.encode() + body)
            readers = within(20, lambda: readers_of(server))
            self.assertEqual(len(readers), 1)
            self.assertTrue(within(120, lambda: processor_s(readers[0]) > 2.0), "it computes")
        used_then, own_then, used = processor_s(readers[0]), processor_s(server.process.pid), 0.0
        while readers_of(server):
            used = max(used, processor_s(readers[0]) - used_then)
            self.assertLess(used, 1.0)
            time.sleep(0.02)
        self.assertEqual(server.ask("POST", "/v1/closures", {"valve": "human-normal"}).status, 200)
        self.assertLess(processor_s(server.process.pid) - own_then, 1.0, "nor does the service compute it")

    def test_a_reader_ends_with_its_client_and_with_the_service(self):
        server = self.start_server("gone.sqlite", "--vertex-steps", 1e12)
        body = json.dumps(self.long_import()).encode()
        head = f"POST /v1/valves:import HTTP/1.1\r\nHost: localhost\r\nContent-Length: {len(body)}\r\n\r\n"
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(head.encode() + body)
            self.assertTrue(within(20, lambda: readers_of(server)))
        self.assertTrue(within(5, lambda: not readers_of(server)))
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(head.encode() + body)
            readers = within(20, lambda: readers_of(server))
            self.assertTrue(readers)
            server.kill()
            gone = lambda: not any(pathlib.Path(f"/proc/{pid}/exe").exists() for pid in readers)  # noqa: E731
            self.assertTrue(within(5, gone))


if __name__ == "__main__":
    unittest.main()
