#!/usr/bin/env python3
"""What a farm costs as it grows: a private PostgreSQL, 64 workers whose tasks take 1.8 s, 1 to 128 whose tasks take 0.2 s, and runs of
10^4 to 10^7 items in tasks of 256 with answers of 17 bytes. Writes docs/figures/farm.csv. The machine must be quiet otherwise.

Usage: lab/farm/growth.py build/release/bin [docs/figures/farm.csv]
"""

import csv
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/farm"))

from private_postgres import PrivatePostgres  # noqa: E402

COLUMNS = ["workers", "task_ms", "items", "tasks", "adding_s", "seconds", "tasks_per_s", "ms_per_task"]
COLUMNS += ["computing_share", "bytes_per_item"]


def measure(programs, postgres, number, **options):
    database = f"load{number}"
    postgres.sql("postgres", f"CREATE DATABASE {database}")
    url = postgres.url(database)
    subprocess.run([programs / "coapt-farm", "init", "--db", url], check=True, stdout=subprocess.DEVNULL)
    words = [word for name, value in options.items() for word in ("--" + name.replace("_", "-"), str(value))]
    run = subprocess.run([programs / "farm_load", "--db", url, *words], check=True, capture_output=True, text=True)
    postgres.sql("postgres", f"DROP DATABASE {database}")
    print(run.stdout, end="", flush=True)
    return json.loads(run.stdout)


def main():
    programs = pathlib.Path(sys.argv[1])
    output = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else ROOT / "docs/figures/farm.csv"
    postgres = PrivatePostgres("max_connections = 200\nmax_wal_size = '4GB'")
    try:
        rows = [measure(programs, postgres, 0, workers=64, tasks=2560, task_ms=1800)]
        for number, workers in enumerate((1, 4, 16, 64, 128), 100):
            rows.append(measure(programs, postgres, number, workers=workers, tasks=30 * workers, task_ms=200))
        for power in (4, 5, 6, 7):
            tasks = 10**power // 256 + 1
            rows.append(measure(programs, postgres, power, workers=8, tasks=tasks, task_ms=0))
    finally:
        postgres.remove()
    with output.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows([f"{row[column]:.6g}" for column in COLUMNS] for row in rows)


if __name__ == "__main__":
    main()
