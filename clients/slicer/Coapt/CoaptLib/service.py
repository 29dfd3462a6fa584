"""A coapt service, found or started, and requests to it that never wait: Slicer's event loop holds Python's lock, so that threads
would stand still, and a request that waits would freeze the window. Steps are generators of what they wait for; a timer calls
Task.poll(). Python 3.9, the standard library alone.
"""

import http.client
import io
import json
import os
import pathlib
import re
import secrets
import select
import shutil
import socket
import ssl
import subprocess
import tempfile
import time
import urllib.parse

MOST_BYTES = 256 << 20  # of an answer
SILENCE_S = 120.0  # of a service, after which a request is given up
LISTENS_S = 30.0  # that a program may take to listen
POLL_S = 0.4  # between questions how far a job is
_HERE = ("localhost", "127.0.0.1", "::1")
_ENDED = ("SUCCEEDED", "FAILED", "CANCELLED")
_BRIDGE = pathlib.Path(__file__).with_name("module.mjs")


class Trouble(Exception):
    """What is said to the user: whole sentences."""


class Refused(Trouble):
    """By a service, with every problem of the request."""

    def __init__(self, status, document):
        self.status = status
        self.problems = document.get("problems") or []
        said = [" ".join(filter(None, (one.get("path"), one["message"]))) for one in self.problems]
        super().__init__("\n".join(said) or document.get("detail") or f"The service answered {status}.")


class Service:
    """Where it is. kind: "service", or "module", the WebAssembly module by node, which neither imports nor exports."""

    def __init__(self, url, token="", kind="service"):
        parts = urllib.parse.urlsplit(url)
        if parts.scheme not in ("http", "https") or not parts.hostname:
            raise Trouble(f'"{url}" is no address of a service; it must be like http://127.0.0.1:8080.')
        if token and parts.scheme == "http" and parts.hostname not in _HERE:
            raise Trouble(f"{url} is not encrypted: others could read the token on the way. Use https.")
        self.url, self.token, self.kind = url.rstrip("/"), token, kind
        self.host, self.secure = parts.hostname, parts.scheme == "https"
        self.port = parts.port or (443 if self.secure else 80)
        self.path = parts.path.rstrip("/")
        self.addresses = []  # looked up once: the one step that may wait, of hosts that are not this machine

    def ask(self, method, path, body=None):
        return Exchange(self, method, path, body)

    def needs(self, what):
        if self.kind != "service":
            raise Trouble(f"The module that node runs cannot {what}. Start coapt-server, or give the address of one.")


class Answer:
    def __init__(self, status, body):
        self.status, self.body = status, body

    def json(self):
        return json.loads(self.body)


class Exchange:
    """One request over a connection of its own. poll() goes on as far as it can without waiting."""

    def __init__(self, service, method, path, body=None):
        content = b"" if body is None else json.dumps(body).encode()
        host = f"[{service.host}]" if ":" in service.host else service.host
        head = [f"{method} {service.path}{path} HTTP/1.1", f"Host: {host}:{service.port}", "Connection: close"]
        if service.token:
            head.append(f"Authorization: Bearer {service.token}")
        if body is not None:
            head += ["Content-Type: application/json", f"Content-Length: {len(content)}"]
        self.service, self.socket, self._connected, self._error, self._answer = service, None, False, None, None
        self._out, self._in = memoryview("\r\n".join([*head, "", ""]).encode("latin-1") + content), bytearray()
        self._addresses, self._heard = None, time.monotonic()

    def poll(self):
        """Whether it has ended."""
        if self._answer is None and self._error is None:
            try:
                self._go_on()
            except (BlockingIOError, ssl.SSLWantReadError, ssl.SSLWantWriteError):
                pass
            except OSError as error:
                self._end(f"No service answers at {self.service.url} ({error.strerror or error}).")
            except (http.client.HTTPException, ValueError) as error:
                self._end(f"{self.service.url} does not answer as a coapt service does ({type(error).__name__}).")
            if self._answer is None and self._error is None and time.monotonic() - self._heard > SILENCE_S:
                self._end(f"{self.service.url} has said nothing for {SILENCE_S:.0f} s.")
        return self._answer is not None or self._error is not None

    def outcome(self):
        """The Answer.

        :raises Trouble: there is none, or it is a refusal
        """
        if self._error:
            raise Trouble(self._error)
        answer = self._answer
        if answer.status == 401:
            raise Trouble(
                f"The service at {self.service.url} asks for a token, or for another one (see its first lines)."
            )
        if answer.status >= 400:
            try:
                document = answer.json()
            except ValueError:
                document = {}
            raise Refused(answer.status, document)
        return answer

    def drop(self):
        """Hangs up: the service stops computing for it."""
        if self.socket is not None:
            self.socket.close()
            self.socket = None

    def _end(self, error):
        self._error = error
        self.drop()

    def _go_on(self):
        if not self._connected:
            self._connect()
        while self._out:
            self._out = self._out[self.socket.send(self._out) :]
            self._heard = time.monotonic()
        while part := self.socket.recv(1 << 18):
            self._in += part
            self._heard = time.monotonic()
            if len(self._in) > MOST_BYTES:
                return self._end(f"{self.service.url} answered with more than {MOST_BYTES >> 20} MiB.")
        response = http.client.HTTPResponse(_Received(bytes(self._in)))
        response.begin()
        self._answer = Answer(response.status, response.read())
        self.drop()

    def _connect(self):
        service = self.service
        if self._addresses is None:
            if not service.addresses:
                service.addresses = socket.getaddrinfo(service.host, service.port, type=socket.SOCK_STREAM)
            self._addresses = list(service.addresses)
        if self.socket is None:
            family, kind, protocol, _, address = self._addresses.pop(0)
            self.socket = socket.socket(family, kind, protocol)
            self.socket.setblocking(False)
            self.socket.connect_ex(address)
        _, ready, failed = select.select([], [self.socket], [self.socket], 0)
        error = self.socket.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR) if ready or failed else 0
        if error and self._addresses:
            self.drop()
        elif error:
            raise OSError(error, os.strerror(error))
        if not ready or error:
            raise BlockingIOError
        if service.secure:
            self.socket = ssl.create_default_context().wrap_socket(
                self.socket, server_hostname=service.host, do_handshake_on_connect=False
            )
        self._connected = True


class _Received:
    """What HTTPResponse reads."""

    def __init__(self, content):
        self._content = content

    def makefile(self, mode):
        return io.BytesIO(self._content)


class Pause:
    def __init__(self, seconds):
        self._until = time.monotonic() + seconds

    def poll(self):
        return time.monotonic() >= self._until

    def outcome(self):
        return None

    def drop(self):
        pass


class Task:
    """Steps under way. They yield exchanges and pauses, whose outcomes come back, and text, which is what is being done; what they
    return is the result. `job` is that of the service which they follow."""

    def __init__(self, steps):
        self._steps, self._awaited, self.said = steps, None, ""
        self.result, self.error, self.ended = None, None, False

    def poll(self):
        """Whether it has ended. Errors of the program itself are raised."""
        try:
            while not self.ended and (self._awaited is None or self._awaited.poll()):
                try:
                    outcome = None if self._awaited is None else self._awaited.outcome()
                except Trouble as trouble:
                    following = self._steps.throw(trouble)
                else:
                    following = self._steps.send(outcome)
                if isinstance(following, str):
                    self.said, self._awaited = following, None
                else:
                    self._awaited = following
        except StopIteration as stop:
            self.result, self.ended = stop.value, True
        except Trouble as trouble:
            self.error, self.ended = trouble, True
        return self.ended

    def cancel(self):
        """Asks the steps to end; those that follow a job cancel it and end with its best so far."""
        if self.ended:
            return
        if self._awaited is not None:
            self._awaited.drop()
        self._awaited = None
        try:
            following = self._steps.throw(Cancelled("Cancelled."))
            self._awaited = None if isinstance(following, str) else following
        except StopIteration as stop:
            self.result, self.ended = stop.value, True
        except Trouble as trouble:
            self.error, self.ended = trouble, True


class Cancelled(Trouble):
    """By the user."""


def waited(steps, between=lambda: time.sleep(0.02)):
    """The result of steps, for scripts and tests; `between` is called until they have ended.

    :raises Trouble: they end so
    """
    task = Task(steps)
    while not task.poll():
        between()
    if task.error:
        raise task.error
    return task.result


def followed(service, job, said):
    """Steps: the job when it has ended. Cancelled, it is the service that ends it, so that its best so far is there.

    :param said: text of a job, which is what is being done
    """
    while job["state"] not in _ENDED:
        yield said(job)
        try:
            yield Pause(POLL_S)
            job = (yield service.ask("GET", job["links"]["self"])).json()
        except Cancelled:
            job = (yield service.ask("POST", job["links"]["cancel"], {})).json()
    if job["state"] == "FAILED":
        raise Trouble("\n".join(one["message"] for one in job["problems"]) or "The job failed.")
    return job


class Started:
    """A program that listens on a free port of this machine, with a token of its own and a folder that goes with it."""

    def __init__(self, command, kind):
        self.kind, self.token = kind, secrets.token_hex(16)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="coapt-"))  # for this account alone
        (self.folder / "token").write_text(self.token + "\n")
        (self.folder / "token").chmod(0o600)
        self.log = self.folder / "log"
        try:
            with self.log.open("w") as log:
                self.process = subprocess.Popen(
                    [part.format(folder=self.folder) for part in command],
                    stdin=subprocess.PIPE,  # its end tells the module that Slicer is gone
                    stdout=log,
                    stderr=subprocess.STDOUT,
                )
        except OSError as error:
            shutil.rmtree(self.folder, ignore_errors=True)
            raise Trouble(f"{command[0]} cannot be started ({error.strerror}).") from error

    def listening(self):
        """Steps: the Service."""
        yield f"starting {self.kind} ..."
        for _ in range(int(LISTENS_S / 0.05)):
            said = self.log.read_text(errors="replace")
            if place := re.search(r"http://127\.0\.0\.1:\d+", said):
                return Service(place.group(), self.token, self.kind)
            if self.process.poll() is not None:
                break
            yield Pause(0.05)
        self.stop()
        raise Trouble(f"coapt does not start: {said.strip() or 'it said nothing'}")

    def stop(self):
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(5)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process.stdin.close()
        shutil.rmtree(self.folder, ignore_errors=True)


class Finder:
    """The service of a session: the one at an address, else a coapt-server that it starts, else the module by node.

    :param settings: any of url, token, server (a program), module (the npm package's folder); what is left out is looked for
    """

    def __init__(self, settings=None, environment=os.environ):
        self.settings = {name: value.strip() for name, value in (settings or {}).items() if value and value.strip()}
        self.environment, self.service, self.started = environment, None, None

    def found(self):
        """Steps: the Service, which takes work."""
        if self.service is None or (self.started and self.started.process.poll() is not None):
            self.stop()
            service = yield from self._looked_for()
            yield f"asking {service.url} ..."
            yield service.ask("GET", "/v1/presets")  # with the token, unlike /healthz
            self.service = service
        return self.service

    def stop(self):
        if self.started:
            self.started.stop()
        self.service = self.started = None

    def _looked_for(self):
        url = self.settings.get("url") or self.environment.get("COAPT_SERVER")
        if url:
            return Service(url, self.settings.get("token") or self.environment.get("COAPT_TOKEN", ""))
        server = self.settings.get("server") or self._program("coapt-server")
        if server:
            flags = ["--port", "0", "--db", "{folder}/coapt.sqlite", "--token-file", "{folder}/token"]
            self.started = Started([server, *flags], "service")
            return (yield from self.started.listening())
        node, module = self._program("node"), self.settings.get("module") or self.environment.get("COAPT_MODULE")
        if node and module:
            if not (pathlib.Path(module) / "index.js").is_file():
                raise Trouble(f"{module} is not the folder of coapt's npm package: it holds no index.js.")
            self.started = Started(
                [node, str(_BRIDGE), str(pathlib.Path(module).resolve()), "{folder}/token"], "module"
            )
            return (yield from self.started.listening())
        raise Trouble(
            "There is no coapt here. Give the address of a service, or the path of coapt-server; without either, node and the "
            "folder of coapt's npm package close and plan valves, but cannot import segmentations."
        )

    def _program(self, name):
        return shutil.which(name, path=self.environment.get("PATH"))
