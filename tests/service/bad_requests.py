"""Requests that are wrong or meant to harm, and what must come of them: a refusal that says why, or,
where the client has broken the connection, its end."""

import json

from good_requests import PLAN, PRESET
from wire import Wrong, abandon, expect, head, post, send

BODIES = (
    "/v1/closures",
    "/v1/openings",
    "/v1/diagnoses",
    "/v1/physiology",
    "/v1/kept-plans",
    "/v1/evaluations",
    "/v1/preferences",
    "/v1/plans",
    "/v1/studies",
    "/v1/valves",
    "/v1/valves:validate",
)
MEBIBYTE = 1 << 20


def no_json(world, random):
    body = random.choice(
        [
            b"",
            b"{",
            b"}",
            b"[1,]",
            b"{'valve': 1}",
            b'{"valve": NaN}',
            b'{"valve": Infinity}',
            b'{"valve": 1e400}',
            b'{"valve": "' + b"\xff\xfe" + b'"}',
            b'{"valve": "\\ud800"}',
            b"\x00" * 100,
            b"\xef\xbb\xbf",
            b"{} {}",
            b'{"valve": 01}',
            b"[" * 100000,
            b'{"valve":' * 50000,
            b'{"valve": "' + b"x" * MEBIBYTE,
        ]
    )
    return expect(send(world.port, [post(random.choice(BODIES), body)]), 400)


def wrong_shape(world, random):
    """JSON, but not what was asked for."""
    wrong = random.choice([None, True, 0, -1, 1e300, 18446744073709551615, "", "x" * 5000, [], [[]], {}, {"x": {}}])
    path, body = random.choice(
        [
            ("/v1/closures", {"valve": wrong}),
            ("/v1/closures", {"valve": PRESET, "plan": wrong or 7}),
            ("/v1/closures", {"valve": PRESET, "x": wrong}),
            ("/v1/closures", {}),
            ("/v1/evaluations", {"valve": PRESET, "plans": wrong}),
            ("/v1/evaluations", {"valve": PRESET, "plans": [PLAN], "region_points": -1}),
            ("/v1/evaluations", {"valve": PRESET, "plans": [PLAN] * 5000, "region_points": 1089}),
            ("/v1/plans", {"valve": PRESET, "search": {"evaluations": wrong or "x"}}),
            ("/v1/plans", {"valve": PRESET, "search": {"seed": -1}}),
            ("/v1/plans", {"valve": PRESET, "search": {"evaluations": 10**9}}),
            ("/v1/plans", {"valve": PRESET, "search": {"rules": {"forbidden": ["nothing-of-this-name"]}}}),
            ("/v1/studies", {"valve": PRESET, "study": {"name": wrong}}),
            ("/v1/studies", {"valve": PRESET, "study": {"name": "ring", "displacement_step_mm": 4}}),
            ("/v1/studies", {"valve": PRESET}),
            ("/v1/valves", {"schema": "coapt.valve/1", "leaflets": wrong}),
            ("/v1/kept-plans", {"name": wrong, "valve": PRESET}),
            ("/v1/kept-plans", {"name": "x", "valve": PRESET, "plan": wrong}),
        ]
    )
    return expect(world.ask("POST", path, body), 422)


def damaged_valve(world, random):
    """A real valve with one value replaced."""
    valve = json.loads(json.dumps(world.valve))
    place = valve
    while True:
        key = random.choice(list(place)) if isinstance(place, dict) else random.randrange(len(place))
        if not isinstance(place[key], (dict, list)) or not place[key] or random.random() < 0.2:
            break
        place = place[key]
    place[key] = random.choice([None, -1, 1e300, -1e-300, 2**40, "x", [], {}, True, [[1]], 0])
    path = random.choice(["/v1/closures", "/v1/valves:validate"])
    reply = world.ask("POST", path, {"valve": valve} if path == "/v1/closures" else valve)
    return expect(reply, *((200, 422) if path == "/v1/closures" else (200,)))


def large_body(world, random):
    """Over the limit: declared, or found out while it arrives."""
    path = random.choice(BODIES)
    if random.random() < 0.7:
        length = random.choice([65 * MEBIBYTE, 1 << 40])
        return expect(send(world.port, [post(path, b"{", Content_Length=length)]), 413)
    chunk = b"100000\r\n" + b" " * MEBIBYTE + b"\r\n"
    return expect(
        send(world.port, [head("POST", path, Transfer_Encoding="chunked")] + [chunk] * 70), 413, or_closed=True
    )


def wrong_length(world, random):
    path = random.choice(BODIES)
    value = random.choice(["-1", "x", "1e3", "0x10", "18446744073709551616", "1, 2", "+5", "", "5 5"])
    return expect(send(world.port, [post(path, b"{}   ", Content_Length=value)], half_close=True), 400, 411, 413)


def no_length(world, random):
    return expect(send(world.port, [head("POST", random.choice(BODIES))]), 411, 400)


def bad_chunks(world, random):
    body = random.choice(
        [
            b"zz\r\n{}\r\n0\r\n\r\n",
            b"-1\r\n",
            b"ffffffffffffffffff\r\n{}",
            b"2\r\n{}XX0\r\n\r\n",
            b"\r\n\r\n",
            b"2\n{}\n0\n\n",
        ]
    )
    pieces = [head("POST", random.choice(BODIES), Transfer_Encoding="chunked"), body]
    return expect(send(world.port, pieces, half_close=True), 400, 413, 431, or_closed=True)


def odd_chunks(world, random):
    """The library below reads sizes like strtoul and takes extensions of any length. With one request a
    connection there is nothing that this could smuggle."""
    size = random.choice([b"0x2", b"+2", b" 2", b"2 x", b"2;" + b"x" * 100000])
    pieces = [head("POST", "/v1/closures", Transfer_Encoding="chunked"), size + b"\r\n{}\r\n0\r\n\r\n"]
    return expect(send(world.port, pieces), 422, 400)


def truncated_body(world, random):
    """Less than was announced, then the end."""
    if random.random() < 0.5:
        pieces = [post(random.choice(BODIES), b'{"valve": ', Content_Length=random.randint(11, 100000))]
    else:
        pieces = [head("POST", random.choice(BODIES), Transfer_Encoding="chunked"), b'5\r\n{"va']
    return expect(send(world.port, pieces, half_close=True), 400, 408, or_closed=True)


def two_lengths(world, random):
    """What front and back server could read as different numbers of requests."""
    hidden = head("GET", "/version")
    request = random.choice(
        [
            post("/v1/closures", b"{}", Transfer_Encoding="chunked"),
            b"POST /v1/closures HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2\r\nContent-Length: 30\r\n\r\n{}",
            post("/v1/closures", b"{}", Transfer_Encoding="xchunked"),
            post("/v1/closures", b"{}", Transfer_Encoding="gzip, chunked"),
            b"POST /v1/closures HTTP/1.1\r\nHost: localhost\r\nContent-Length : 2\r\n\r\n{}",
            b"GET /version HTTP/1.1\r\nHost: localhost\r\n X: folded\r\n\r\n",
        ]
    )
    return expect(send(world.port, [request + hidden], half_close=True), 400, 411, 415, 422, 501)


def pipelined(world, random):
    """One request a connection: the second is not answered (wire.read_reply would see it)."""
    first = random.choice([head("GET", "/version"), post("/v1/nothing", b"{}"), post("/v1/closures", b"{}")])
    return expect(send(world.port, [first + head("GET", "/healthz/live") * random.randint(1, 20)]), 200, 404, 422)


def header_bomb(world, random):
    pieces = random.choice(
        [
            [head("GET", "/version", X="x" * random.choice([40_000, 4_000_000]))],
            [b"GET /version HTTP/1.1\r\nHost: localhost\r\n" + b"X: y\r\n" * 20_000 + b"\r\n"],
            [head("GET", "/version", **{"x" * 100_000: "y"})],
        ]
    )
    return expect(send(world.port, pieces), 431, 400)


def odd_path(world, random):
    path, statuses = random.choice(
        [
            ("/" + "v" * 100_000, (414, 431)),
            ("/v1/jobs?page_token=" + "x" * 100_000, (414, 431)),
            ("/v1/%2e%2e/%2e%2e/etc/passwd", (400, 404)),
            ("/v1/../../etc/passwd", (400, 404)),
            ("/v1/presets/..%2f..%2fetc%2fpasswd", (400, 404)),
            ("/v1/valves/%00", (400, 404)),
            ("/v1/presets/human-normal%00", (400, 404)),
            ("/v1/jobs/%ff%fe", (400, 404)),
            ("/v1/jobs/%zz", (400, 404)),
            ("/v1/jobs/x/files/..%2f..%2fx", (400, 404)),
            ("//v1//jobs", (400, 404)),
            ("/v1/jobs/", (400, 404)),
            ("/v1/jobs?page_size=0", (422, 400)),
            ("/v1/jobs?page_size=1e9", (422, 400)),
            ("/v1/jobs?page_token=x", (422, 400)),
            ("/v1/jobs?state=NONE", (422, 400)),
            ("/", (200, 404)),  # with and without a page
            ("/v1/jobs/' OR 1=1 --".replace(" ", "%20"), (404,)),
            ("http://localhost/version", (200, 400, 404)),
            ("/v1/valves/" + "a" * 5000, (404,)),
            ("*", (400, 404)),
            ("", (400,)),
        ]
    )
    return expect(send(world.port, [head("GET", path)]), *statuses)


def wrong_method(world, random):
    method, path = random.choice(
        [
            ("GET", "/v1/closures"),
            ("GET", "/v1/plans"),
            ("DELETE", "/v1/plans"),
            ("PUT", "/v1/valves/x"),
            ("PATCH", "/v1/jobs"),
            ("POST", "/healthz/live"),
            ("POST", "/v1/jobs"),
            ("OPTIONS", "/v1/plans"),
            ("TRACE", "/version"),
            ("CONNECT", "localhost:80"),
            ("BREW", "/v1/plans"),
            ("get", "/version"),
            ("G" * 5000, "/version"),
        ]
    )
    return expect(send(world.port, [head(method, path, Content_Length=0)]), 400, 404, 405, 431, 501)


def wrong_type(world, random):
    body = random.choice([b'--x\r\nContent-Disposition: form-data; name="valve"\r\n\r\n1\r\n--x--\r\n', b"{}"])
    headers = random.choice(
        [{"Content_Type": "multipart/form-data; boundary=x"}, {"Content_Encoding": "gzip"}, {"Content_Encoding": "br"}]
    )
    return expect(send(world.port, [post(random.choice(BODIES), body, **headers)]), 415)


def foreign(world, random):
    """A page in a browser of this machine, or a name that was bound to it."""
    path = random.choice(["/v1/jobs", "/metrics", "/version"])
    if random.random() < 0.5:
        host = random.choice(["evil.example", "localhost.evil.example", "127.0.0.1.evil.example:80", "", "[::1"])
        return expect(send(world.port, [head("GET", path, Host=host)]), 421, 400)
    origin = random.choice(["http://evil.example", "null", "https://localhost.evil.example", "http://127.0.0.1:1"])
    return expect(send(world.port, [head("GET", path, Origin=origin)]), 403)


def no_http(world, random):
    noise = random.choice(
        [
            b"\x16\x03\x01\x02\x00" + random.randbytes(200),
            b"\r\n" * 10,
            random.randbytes(500),
            b"GET\r\n\r\n",
            b"GET /version\r\n\r\n",
            b"GET /version HTTP/9.9\r\n\r\n",
            b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
            b"\x00" * 1000,
        ]
    )
    return expect(
        send(world.port, [noise], half_close=True), 400, 404, 405, 408, 414, 421, 431, 501, 505, or_closed=True
    )


def slow_headers(world, random):
    pieces = [head("GET", "/version")[:-4]] + [b"\r\nX-%d: y" % i for i in range(30)]
    return expect(send(world.port, pieces, pause=1.0), 408, or_closed=True)


def slow_body(world, random):
    pieces = [post("/v1/closures", b"{", Content_Length=1000)] + [b" "] * 100
    return expect(send(world.port, pieces, pause=1.0, seconds=120), 408, or_closed=True)


def half_closed(world, random):
    """All is said and the client's half closed: it still gets its answer."""
    request = json.dumps({"valve": PRESET}).encode()
    return expect(send(world.port, [post("/v1/closures", request)], half_close=True), 200)


def abandoned(world, random):
    pieces = random.choice(
        [
            [],
            [b"GET /ver"],
            [head("GET", "/metrics")],
            [head("GET", "/openapi.json")],
            [post("/v1/closures", json.dumps({"valve": world.valve}).encode())],
            [post("/v1/closures", b'{"valve"', Content_Length=5000)],
            [head("POST", "/v1/closures", Transfer_Encoding="chunked"), b"5\r\n"],
        ]
    )
    abandon(world.port, pieces, linger=random.choice([0.0, 0.0, 0.2]))
    return "left"


def expects_continue(world, random):
    """Expect: 100-continue, with a body that will be refused, or that does not come before the word."""
    reply = send(world.port, [post("/v1/closures", b"", Content_Length=1 << 40, Expect="100-continue")])
    if reply is not None and reply.status == 100:
        raise Wrong("asked for a body that is too large")
    return expect(reply, 413, 417)
