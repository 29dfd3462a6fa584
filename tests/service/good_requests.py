"""Requests as a well-behaved client makes them, and what must come of them."""

import json
import threading
import time
import urllib.parse

from served import ENDED, SOURCE, ask, search_of
from wire import Wrong, abandon, expect, head

PRESET = "human-functional-mr"
PLAN = {"schema": "coapt.plan/1", "steps": [{"step": "annuloplasty", "shape": "own", "sizes_below": 2}]}
EXAMPLES = json.loads((SOURCE / "server/openapi.json").read_text())["components"]["examples"]
# 155 closures, kept after the first time.
STUDY = {"name": "annulus"}


class World:
    """A service, and what the requests before have left there. From many threads."""

    def __init__(self, port):
        self.port = port
        self.valve = ask(port, "GET", f"/v1/presets/{PRESET}").json()
        self.valve_id = ask(port, "POST", "/v1/valves", self.valve).json()["id"]
        self.lock = threading.Lock()
        self.jobs, self.deleted, self.cancelled = {}, set(), set()

    def ask(self, method, path, body=None, headers=None):
        return ask(self.port, method, path, body, headers)

    def keep(self, job):
        with self.lock:
            self.jobs[job["id"]] = job["kind"]

    def any_job(self, random):
        """A job that was accepted, now and then one that is there no longer or never was."""
        with self.lock:
            ids = sorted(self.jobs)
        return random.choice(ids) if ids and random.random() < 0.95 else "never-was"

    def gone(self, job_id):
        """Statuses that a job may answer with besides the good ones."""
        with self.lock:
            return (404,) if job_id not in self.jobs or job_id in self.deleted else ()

    def any_valve(self, random):
        return random.choice([self.valve, self.valve_id, PRESET])


def closure(world, random):
    request = {"valve": world.any_valve(random)} | ({"plan": PLAN} if random.random() < 0.5 else {})
    reply = world.ask("POST", "/v1/closures", request)
    word = expect(reply, 200)
    if reply.json()["schema"] != "coapt.closure/2":
        raise Wrong(f"no closure: {reply.body[:200]!r}")
    return word


def evaluation(world, random):
    plans = [PLAN] * random.randint(1, 2)
    reply = world.ask("POST", "/v1/evaluations", {"valve": world.any_valve(random), "plans": plans, "region_points": 2})
    word = expect(reply, 200)
    if len(reply.json()["plans"]) != len(plans):
        raise Wrong(f"{len(reply.json()['plans'])} plans of {len(plans)}")
    return word


def accepted(world, reply, *statuses):
    """A job that may have been refused for a full queue."""
    word = expect(reply, *statuses, 429)
    if reply.status != 429:
        world.keep(reply.json())
    return word


def search(world, random):
    request = {"valve": world.any_valve(random), "search": search_of(random.randint(0, 1 << 63))}
    headers = {"Prefer": "wait=1"} if random.random() < 0.3 else {}
    return accepted(world, world.ask("POST", "/v1/plans", request, headers), 200, 202)


def search_twice(world, random):
    """The second time the key names the first job; with another body it is refused."""
    key = {"Idempotency-Key": f"key-{random.getrandbits(64)}"}
    request = {"valve": PRESET, "search": search_of(random.randint(0, 1 << 63))}
    first = world.ask("POST", "/v1/plans", request, key)
    word = accepted(world, first, 202)
    if first.status == 429:
        return word
    second = world.ask("POST", "/v1/plans", request, key)
    expect(second, 200, 202)
    job_id = first.json()["id"]
    if second.json()["id"] != job_id and not world.gone(job_id):
        raise Wrong("one key, two jobs")
    request["search"]["seed"] += 1
    expect(world.ask("POST", "/v1/plans", request, key), 422)
    return word


def study_cancelled(world, random):
    reply = world.ask("POST", "/v1/studies", {"valve": PRESET, "study": STUDY})
    word = accepted(world, reply, 202)
    if reply.status == 202 and random.random() < 0.8:
        job_id = reply.json()["id"]
        with world.lock:
            world.cancelled.add(job_id)
        expect(world.ask("POST", f"/v1/jobs/{job_id}:cancel"), 200, *world.gone(job_id))
    return word


def poll(world, random):
    job_id = world.any_job(random)
    reply = world.ask("GET", f"/v1/jobs/{job_id}")
    return expect(reply, 200, *world.gone(job_id))


def list_jobs(world, random):
    query = {"page_size": random.randint(1, 100)}
    if random.random() < 0.5:
        query["state"] = random.choice(ENDED + ("QUEUED", "RUNNING"))
    reply = world.ask("GET", "/v1/jobs?" + urllib.parse.urlencode(query))
    word = expect(reply, 200)
    token = reply.json()["next_page_token"]
    if token is not None:
        query["page_token"] = token
        expect(world.ask("GET", "/v1/jobs?" + urllib.parse.urlencode(query)), 200)
    return word


def result(world, random):
    job_id = world.any_job(random)
    part = random.choice(
        [
            "result",
            "plans",
            "plans/1",
            "plans/1/mesh?format=ply",
            "plans/1/picture",
            "plans/1/report",
            "report",
            "evaluations.csv",
            "files",
        ]
    )
    # A cancelled job may have no plan, a study has none.
    return expect(world.ask("GET", f"/v1/jobs/{job_id}/{part}"), 200, 404, 409)


def cancel(world, random):
    job_id = world.any_job(random)
    with world.lock:
        world.cancelled.add(job_id)
    body = random.choice([None, {}])
    return expect(world.ask("POST", f"/v1/jobs/{job_id}:cancel", body), 200, *world.gone(job_id))


def delete(world, random):
    job_id = world.any_job(random)
    with world.lock:
        maybe = job_id in world.jobs
        was_there = maybe and job_id not in world.deleted
        if maybe:
            world.deleted.add(job_id)
    reply = world.ask("DELETE", f"/v1/jobs/{job_id}")
    word = expect(reply, 204, 404, 409)
    with world.lock:
        if reply.status == 409 and was_there:
            world.deleted.discard(job_id)
    return word


def follow(world, random):
    """An event stream, dropped midway now and then."""
    job_id = world.any_job(random)
    path = f"/v1/jobs/{job_id}/events"
    if random.random() < 0.7:
        abandon(world.port, [head("GET", path)], linger=random.uniform(0.0, 1.0))
        return "dropped"
    return expect(world.ask("GET", path), 200, 204, *world.gone(job_id))


def valves(world, random):
    """A valve of its own: kept, kept again, read, removed."""
    valve = json.loads(json.dumps(world.valve))
    valve["pressure_kpa"] = 16 + random.random()
    validated = world.ask("POST", "/v1/valves:validate", valve)
    expect(validated, 200)
    if validated.json()["valid"] is not True:
        raise Wrong(f"not valid: {validated.body[:200]!r}")
    kept = world.ask("POST", "/v1/valves", valve)
    expect(kept, 201)
    path = kept.headers["location"]
    expect(world.ask("POST", "/v1/valves", valve), 200)
    expect(world.ask("GET", path), 200)
    word = expect(world.ask("DELETE", path), 204)
    expect(world.ask("GET", path), 404)
    return word


def valve_import(world, random):
    """Files of the contract's example, read in a process of their own."""
    skirt = {**EXAMPLES["one_skirt"]["value"], "triangles": random.randint(100, 300)}
    word = expect(world.ask("POST", "/v1/valves:import", skirt), 200, 201)
    expect(world.ask("POST", "/v1/imports:preview", {"files": [*skirt["leaflets"], skirt["annulus"]]}), 200)
    return word


def other_answers(world, random):
    path, more = random.choice(
        [
            ("/v1/scenes", {"frames": 3}),
            ("/v1/openings", {}),
            ("/v1/diagnoses", {}),
            ("/v1/pictures", {}),
            ("/v1/exports", {"format": random.choice(["stl", "vtk", "glb", "csv", "feb"])}),
            ("/v1/exports:files", {"formats": ["ply", "slicerheart"]}),
            ("/v1/comparisons", {"closed": {"valve": PRESET}, "reference": {"valve": PRESET, "plan": PLAN}}),
            ("/v1/reports", {"plans": [PLAN], "region_points": 2}),
        ]
    )
    valve = {} if path == "/v1/comparisons" else {"valve": world.any_valve(random)}
    return expect(world.ask("POST", path, valve | more), 200)


def kept_plans(world, random):
    """A plan of its own: kept, found, renamed, removed."""
    kept = world.ask("POST", "/v1/kept-plans", {"name": "Mine", "valve": PRESET, "plan": PLAN})
    expect(kept, 201)
    path = kept.headers["location"]
    expect(world.ask("GET", path), 200)
    expect(world.ask("GET", f"/v1/kept-plans?valve={PRESET}&page_size={random.randint(1, 100)}"), 200)
    expect(world.ask("PATCH", path, {"name": "Still mine"}), 200)
    word = expect(world.ask("DELETE", path), 204)
    expect(world.ask("GET", path), 404)
    return word


def small_reads(world, random):
    path = random.choice(
        [
            "/v1/presets",
            "/v1/rings",
            "/v1/valves",
            "/v1/kept-plans",
            "/healthz/live",
            "/healthz/ready",
            "/metrics",
            "/version",
            "/openapi.json",
            f"/v1/presets/{PRESET}",
            f"/v1/valves/{world.valve_id}",
        ]
    )
    return expect(world.ask(random.choice(["GET", "GET", "HEAD"]), path), 200)


def ended_jobs(world, seconds):
    """Ids of the jobs that must be there, all ended and with what they have come to; Wrong otherwise, or if for `seconds`
    none of those that run gets further."""
    running, deadline = None, time.monotonic() + seconds
    with world.lock:
        expected = [(job_id, kind) for job_id, kind in sorted(world.jobs.items()) if job_id not in world.deleted]
        cancelled = set(world.cancelled)
    for job_id, kind in expected:
        while True:
            reply = world.ask("GET", f"/v1/jobs/{job_id}")
            expect(reply, 200)
            job = reply.json()
            if job["state"] in ENDED:
                break
            progress = [
                (other["id"], other["progress"]["closures"])
                for other in world.ask("GET", "/v1/jobs?state=RUNNING").json()["jobs"]
            ]
            if progress != running:
                running, deadline = progress, time.monotonic() + seconds
            if time.monotonic() > deadline:
                raise Wrong(f"a job is still {job['state']}")
            time.sleep(0.1)
        if job["state"] == "FAILED" or (job["state"] == "CANCELLED" and job_id not in cancelled):
            raise Wrong(f"a job is {job['state']}: {job['problems']}")
        if job["state"] == "SUCCEEDED":
            expect(world.ask("GET", f"/v1/jobs/{job_id}/result"), 200)
            if kind == "plans" and not job["plans"]:
                raise Wrong("a search without plans")
    return [job_id for job_id, _ in expected]
