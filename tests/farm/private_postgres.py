"""A PostgreSQL server of one's own: in a folder, on a Unix socket, gone with the test."""

import glob
import os
import pathlib
import pwd
import shutil
import subprocess
import tempfile


def tool(name):
    found = sorted(glob.glob(f"/usr/lib/postgresql/*/bin/{name}"))
    return found[-1] if found else shutil.which(name)


# PostgreSQL does not run as root.
OTHER_USER = {"user": "postgres", "group": "postgres", "extra_groups": []} if os.geteuid() == 0 else {}


class PrivatePostgres:
    """The superuser "boss" needs no password; everyone else proves who they are (SCRAM)."""

    def __init__(self, settings=""):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="farm"))
        if OTHER_USER:
            owner = pwd.getpwnam("postgres")
            os.chown(self.folder, owner.pw_uid, owner.pw_gid)
        self.folder.chmod(0o711)
        self.data = self.folder / "data"
        self._run("initdb", "-D", self.data, "-U", "boss", "-A", "trust")
        (self.data / "pg_hba.conf").write_text("local all boss trust\nlocal all all scram-sha-256\n")
        with (self.data / "postgresql.conf").open("a") as file:
            file.write(f"unix_socket_directories = '{self.folder}'\nlisten_addresses = ''\n{settings}\n")
            file.write("dynamic_shared_memory_type = mmap\n")  # a container's /dev/shm is small, or goes
        self.start()

    def _run(self, name, *arguments):
        command = [tool(name), *map(str, arguments)]
        run = subprocess.run(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            cwd="/",
            timeout=60,
            **OTHER_USER,
        )
        assert run.returncode == 0, run.stdout

    def _control(self, *arguments):
        # Not through a pipe, which the server would keep open.
        subprocess.run(
            [tool("pg_ctl"), "-D", self.data, "-w", "-l", self.folder / "log", *arguments],
            stdout=subprocess.DEVNULL, check=True, cwd="/", timeout=60, **OTHER_USER,
        )  # fmt: skip

    def start(self):
        self._control("start")

    def crash_and_restart(self):
        self._control("-m", "immediate", "restart")

    def remove(self):
        self._control("-m", "immediate", "stop")
        shutil.rmtree(self.folder)

    def url(self, database, user="boss", password=""):
        return f"postgresql://{user}{password and ':'}{password}@/{database}?host={self.folder}"

    def sql(self, database, text, user="boss", password=""):
        """Rows of words."""
        run = subprocess.run(
            ["psql", "-XAtq", "-v", "ON_ERROR_STOP=1", self.url(database, user, password), "-c", text],
            capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        if run.returncode != 0:
            raise RuntimeError(run.stderr)
        return [line.split("|") for line in run.stdout.splitlines()]
