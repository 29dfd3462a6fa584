"""coapt-server with little memory: a request may fail, the service does not."""

import collections
import resource
import subprocess
import threading
import unittest

from process_runs import HANGS_S
from programs import SERVER
from server_runs import ServerTest

MIB = 1 << 20
# Eight million bytes each: many small values, nested ones, one long name, no end.
HOSTILE = [
    b'{"valve":[' + b"{}," * 2_660_000,
    b'{"valve":[' + b"[[1]]," * 1_330_000,
    b'{"valve":"' + b"x" * 7_900_000 + b'"}',
    b"[" * 31 + b"1" * 7_900_000,
]
AT_ONCE, ROUNDS = 16, 4


class LittleMemory(ServerTest):
    def flood(self, server):
        """How often which answer came; "none" for a connection without one."""
        answers = collections.Counter()

        def send(number):
            try:
                answers[server.ask("POST", "/v1/closures", HOSTILE[number % len(HOSTILE)]).status] += 1
            except OSError:
                answers["none"] += 1

        for _ in range(ROUNDS):
            threads = [threading.Thread(target=send, args=(number,)) for number in range(AT_ONCE)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
        return answers

    def test_bodies_that_do_not_fit_into_it_cost_their_answers_at_most(self):
        for limit in (384 * MIB, 512 * MIB, 2048 * MIB):
            with self.subTest(limit=limit):
                server = self.start_server(f"limited-{limit}.sqlite")
                resource.prlimit(server.process.pid, resource.RLIMIT_AS, (limit, limit))
                answers = self.flood(server)
                self.assertEqual(sum(answers.values()), AT_ONCE * ROUNDS)
                self.assertLessEqual(set(answers), {400, 422, 500, 503, "none"})
                self.assertEqual(server.ask("POST", "/v1/closures", {"valve": "human-normal"}).status, 200)

    def test_large_bodies_do_not_stay_in_it(self):
        before = self.server.resident_mib()
        self.flood(self.server)
        self.assertLess(self.server.resident_mib() - before, 300)

    def test_too_little_for_its_threads_is_said(self):
        command = f"ulimit -v 160000; exec {SERVER} --port 0 --db {self.folder}/none.sqlite"
        ended = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=HANGS_S)
        self.assertEqual(ended.returncode, 1, ended.stderr)
        self.assertRegex(ended.stderr, r"^coapt-server: .+\n$")


if __name__ == "__main__":
    unittest.main()
