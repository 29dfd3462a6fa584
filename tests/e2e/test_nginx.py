"""examples/deploy/coapt.nginx.conf as it is, but for ports and paths, before a service with a token."""

import os
import random
import secrets
import shutil
import socket
import ssl
import subprocess
import time
import unittest

from process_runs import HANGS_S
from programs import SOURCE
from server_runs import ServerTest, search_of

SITE = SOURCE / "examples/deploy/coapt.nginx.conf"
NAME = "coapt.example.org"
NGINX = shutil.which("nginx", path=os.environ["PATH"] + ":/usr/sbin")


def free_ports(count):
    """Below those that the kernel hands out for port 0: another test would get them before nginx does."""
    ports = []
    for port in random.sample(range(20000, 32000), 1000):
        try:
            socket.create_server(("127.0.0.1", port)).close()
        except OSError:
            continue
        ports.append(port)
        if len(ports) == count:
            break
    return ports


@unittest.skipUnless(NGINX and shutil.which("openssl"), "needs nginx and openssl (package group proxy)")
class Nginx(ServerTest):
    def setUp(self):
        self.token = secrets.token_urlsafe(32)
        super().setUp()
        self.port, self.plain_port = free_ports(2)
        self.make_certificate()
        self.start_nginx()

    def start_server(self):
        token_file = self.folder / "token"
        token_file.touch(mode=0o600)
        token_file.write_text(self.token + "\n")
        return super().start_server(
            "jobs.sqlite", "--token-file", token_file, "--allow-host", NAME, "--behind-proxy", "--running-jobs", 1
        )

    def make_certificate(self):
        subprocess.run(
            [
                "openssl",
                "req",
                "-x509",
                "-newkey",
                "ec",
                "-pkeyopt",
                "ec_paramgen_curve:prime256v1",
                "-nodes",
                "-days",
                "1",
                "-subj",
                f"/CN={NAME}",
                "-addext",
                f"subjectAltName=DNS:{NAME}",
                "-keyout",
                self.folder / "key.pem",
                "-out",
                self.folder / "certificate.pem",
            ],
            check=True,
            capture_output=True,
        )

    def site(self):
        text = SITE.read_text()
        for shipped, here in [
            ("listen 443 ", f"listen 127.0.0.1:{self.port} "),
            ("listen 80;", f"listen 127.0.0.1:{self.plain_port};"),
            ("127.0.0.1:8080", f"127.0.0.1:{self.server.port}"),
            (f"/etc/ssl/certs/{NAME}.pem", str(self.folder / "certificate.pem")),
            (f"/etc/ssl/private/{NAME}.key", str(self.folder / "key.pem")),
        ]:
            self.assertIn(shipped, text)
            text = text.replace(shipped, here)
        return self.write("site.conf", text)

    def start_nginx(self):
        folders = "".join(
            f"{kind}_temp_path {self.folder / kind};\n" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi")
        )
        configuration = self.write(
            "nginx.conf",
            "".join(
                [
                    "daemon off;\nworker_processes 1;\n",
                    "user root;\n" if os.getuid() == 0 else "",
                    f"pid {self.folder / 'nginx.pid'};\nerror_log {self.folder / 'error.log'};\n",
                    "events { worker_connections 256; }\nhttp {\naccess_log off;\n",
                    folders,
                    f"include {self.site()};\n}}\n",
                ]
            ),
        )
        command = [NGINX, "-p", str(self.folder), "-c", str(configuration), "-e", str(self.folder / "error.log")]
        tested = subprocess.run([*command, "-t"], capture_output=True, text=True)
        self.assertEqual(tested.returncode, 0, tested.stderr)
        process = subprocess.Popen(command)
        self.addCleanup(process.wait, 30)
        self.addCleanup(process.terminate)
        deadline = time.monotonic() + HANGS_S
        while True:
            try:
                socket.create_connection(("127.0.0.1", self.port), timeout=1).close()
                return
            except OSError:
                self.assertLess(time.monotonic(), deadline, (self.folder / "error.log").read_text())
                time.sleep(0.05)

    @property
    def url(self):
        return f"https://{NAME}:{self.port}"

    def curl_with_headers(self, path, *arguments, token=True):
        bearer = ["-H", f"Authorization: Bearer {self.token}"] if token else []
        return super().curl_with_headers(
            path,
            "--cacert",
            self.folder / "certificate.pem",
            "--resolve",
            f"{NAME}:{self.port}:127.0.0.1",
            "--resolve",
            f"{NAME}:{self.plain_port}:127.0.0.1",
            *bearer,
            *arguments,
        )

    def test_a_search_goes_through_with_the_token_and_not_without(self):
        status, headers, _ = self.curl_with_headers("/v1/jobs", token=False)
        self.assertEqual((status, headers["www-authenticate"]), (401, "Bearer"))
        job = self.submit(search_of(1))
        deadline = time.monotonic() + HANGS_S
        while job["state"] in ("QUEUED", "RUNNING"):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.2)
            job = self.curl(job["links"]["self"])[2]
        self.assertEqual(job["state"], "SUCCEEDED")
        status, headers, _ = self.curl_with_headers("/version")
        self.assertIn("coapt-notice", headers)
        self.assertIn("strict-transport-security", headers)

    def test_pages_of_this_name_may_ask_and_others_not(self):
        self.assertEqual(self.curl("/v1/presets", "-H", f"Origin: https://{NAME}")[0], 200)
        self.assert_problem(self.curl("/v1/presets", "-H", "Origin: https://evil.example"), 403)

    def follow(self, job):
        """A connection on which the job's events come."""
        context = ssl.create_default_context(cafile=self.folder / "certificate.pem")
        plain = socket.create_connection(("127.0.0.1", self.port), timeout=60)
        connection = context.wrap_socket(plain, server_hostname=NAME)
        self.addCleanup(connection.close)
        connection.sendall(
            (
                f"GET {job['links']['events']} HTTP/1.1\r\nHost: {NAME}\r\n"
                f"Authorization: Bearer {self.token}\r\n\r\n"
            ).encode()
        )
        return connection

    def test_one_address_cannot_take_all_streams(self):
        job = self.submit(search_of(1, evaluations=5000))
        streams = [self.follow(job) for _ in range(9)]
        statuses = [stream.recv(12).split()[1] for stream in streams]
        self.assertEqual((statuses[:8], statuses[8]), ([b"200"] * 8, b"429"))
        self.assertEqual(self.post(job["links"]["cancel"], {})[0], 200)

    def test_events_arrive_one_by_one(self):
        """A queued job has one event and then none: a proxy that buffers would keep it."""
        running, queued = self.submit(search_of(1, evaluations=5000)), self.submit(search_of(2))
        with self.follow(queued) as connection:
            received = b""
            while b"event: state" not in received:
                part = connection.recv(4096)
                self.assertTrue(part, received)
                received += part
            self.assertIn(b"text/event-stream", received)
            # It came while the job was still in the queue, and so while the stream was open.
            self.assertEqual(self.curl(queued["links"]["self"])[2]["state"], "QUEUED")
        for job in (running, queued):
            self.assertEqual(self.post(job["links"]["cancel"], {})[0], 200)

    def test_what_is_too_large_or_too_often_is_a_problem_in_json(self):
        large = self.folder / "large.json"
        with large.open("wb") as file:
            file.truncate(65 << 20)
        status, headers, body = self.curl_with_headers("/v1/closures", "--data-binary", f"@{large}")
        self.assertEqual((status, headers["content-type"]), (413, "application/problem+json"), body)
        self.assertEqual(self.curl("/version", "--http1.1", "-H", "X: " + "x" * 20000)[2]["status"], 400)
        statuses = [self.curl("/version")[0] for _ in range(20)]
        self.assertEqual(set(statuses), {200})
        many = subprocess.run(
            [
                "curl",
                "--silent",
                "--parallel",
                "--parallel-max",
                "30",
                "--cacert",
                self.folder / "certificate.pem",
                "--resolve",
                f"{NAME}:{self.port}:127.0.0.1",
                "--write-out",
                "%{http_code}\n",
                *["-o", "/dev/null", f"{self.url}/healthz/live"] * 200,
            ],
            capture_output=True,
            text=True,
        )
        self.assertEqual(set(many.stdout.split()), {"200", "429"})

    def test_a_service_that_is_down_is_a_problem_in_json(self):
        self.server.stop()
        status, content_type, body = self.curl("/version")
        self.assertEqual((status, content_type, body["status"]), (502, "application/problem+json", 502))

    def test_plain_http_is_sent_to_tls(self):
        status, headers, _ = self.curl_with_headers(f"http://{NAME}:{self.plain_port}/version", token=False)
        self.assertEqual((status, headers["location"]), (301, f"https://{NAME}/version"))


if __name__ == "__main__":
    unittest.main()
