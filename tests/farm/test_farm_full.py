"""A disk without room: workers and coordinators wait, nothing is lost."""

import os
import shutil
import subprocess
import unittest

from farm_runs import FarmTest, Request, wait_until
from private_postgres import OTHER_USER


def mount(*arguments):
    return subprocess.run(["mount", "-t", "tmpfs", *arguments], capture_output=True, text=True)


class Full(FarmTest):
    def setUp(self):
        super().setUp()
        if not OTHER_USER:
            self.skipTest("only root may mount a small file system")
        small = self.postgres.folder / "small"
        small.mkdir()
        mounted = mount("-o", "size=2m", "none", str(small))
        if mounted.returncode != 0:
            self.skipTest(f"no small file system: {mounted.stderr}")
        self.addCleanup(subprocess.run, ["umount", "-l", str(small)])
        shutil.chown(small, "postgres", "postgres")
        os.chmod(small, 0o700)
        self.small = small
        self.postgres.sql("postgres", f"CREATE TABLESPACE small LOCATION '{small}'")
        self.sql("ALTER TABLE coapt_farm.result SET TABLESPACE small")
        self.addCleanup(self.postgres.sql, "postgres", f"DROP DATABASE {self.name} WITH (FORCE)")

    def test_a_full_disk_is_waited_for(self):
        request = Request(400, task_items=10, ms=0)
        self.farm("add", "-", "--check-share", "0", stdin=request.bytes())
        self.sql("ALTER TABLE coapt_farm.result ALTER bytes SET STORAGE EXTERNAL")  # what is compressed takes no room
        worker = self.worker(TOY_SIZE="10000")  # 4 MB in all
        said = [worker.stderr.readline().decode()]
        while "retrying" not in said[-1]:
            said.append(worker.stderr.readline().decode())
        self.assertIn("could not extend file", said[-1])
        self.assertLess(self.done(), 40)
        self.assertEqual(mount("-o", "remount,size=64m", "none", str(self.small)).returncode, 0)
        wait_until(lambda: self.status()["runs"][0]["state"] == "done")
        answers = request.answers()
        expected = b"".join(answers[8 * i : 8 * i + 8] + b"x" * 10_000 for i in range(400))
        self.assertEqual(self.farm("fetch", 1, TOY_SIZE="10000").stdout, expected)
        self.assertIsNone(worker.poll())


if __name__ == "__main__":
    unittest.main()
