#!/usr/bin/env python3
"""Fails if a table of the documents says another number than its file in docs/figures, if a figure or picture has no row in
docs/figures/README.md or no document that shows it, or if a picture of the page is of another version.

Usage: tests/docs/check_figures.py [--anew COAPT]

--anew also makes the tables of closures and openings again with this program, in a minute or two, and compares.

What is wrong is told as FILE:LINE: what is printed, and what the file has. The last line counts the numbers that were compared.
"""

import argparse
import csv
import fnmatch
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES, IMAGES = ROOT / "docs/figures", ROOT / "docs/images"
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:,\d{3})*(?:\.\d+)?")
TABLES = []


def repeats(document, header, file):
    """Says that the table of `document` whose first line begins with `header` repeats `file`. What it decorates takes the file's
    rows, and answers with a function of a table row's cells: what stands in its cells, by their number from 0. A number, or list of
    numbers in the order in which they are printed; text is compared as it is."""
    return lambda expected: TABLES.append((document, header, file, expected))


def rows_of(file):
    if file.endswith(".json"):
        return json.loads((ROOT / "docs" / file).read_text(encoding="utf-8"))
    with (ROOT / "docs" / file).open(encoding="utf-8", newline="") as content:
        return list(csv.DictReader(content))


def by(rows, *keys):
    """Rows by the values of these columns."""
    return {tuple(row[key] for key in keys): row for row in rows}


def quantile(values, share):
    values = sorted(values)
    return values[min(int(share * len(values)), len(values) - 1)]


ACCURACY = "docs/researcher/accuracy.md"
SEARCH = "docs/researcher/search.md"


@repeats(ACCURACY, "| | 0.1, cold: ms, a second |", "figures/releases.csv")
def releases(rows):
    known = by(rows, "preset", "start")

    def expected(cells):
        cold, warm, predicted = (known[cells[0], start] for start in ("cold", "warm", "predicted"))
        pair = [[row[f"{age}_median_ms"], row[f"{age}_per_second"]] for row in (cold, warm) for age in ("old", "new")]
        new = [predicted["new_median_ms"], predicted["new_per_second"]]
        return dict(enumerate([*pair[:2], cold["time"], *pair[2:], warm["time"], new, predicted["time"]], 1))

    return expected


@repeats(ACCURACY, "| valve | triangles | crossing | leak mm²", "figures/closures.csv")
def closures(rows):
    known = by(rows, "valve", "method")

    def expected(cells):
        fast, thesis = (known[cells[0], method] for method in ("fast", "thesis"))
        return {
            1: fast["triangles"],
            2: {"false": "no", "true": "yes"}[fast["crossing"]],
            3: fast["leak_mm2"],
            4: fast["openings"],
            5: [fast["coaptation_mean_mm"], fast["coaptation_min_mm"]],
            6: [fast["sections_in_contact"], 9],
            7: fast["steps"],
            8: thesis["leak_mm2"],
            9: thesis["steps"],
        }

    return expected


@repeats(ACCURACY, "| triangles | 648 | 1,296 |", "figures/membranes.csv")
def membranes(rows):
    def expected(cells):
        leaks = [row["leak_mm2"] for row in rows if row["membrane"] == cells[0].split(",")[0]]
        return dict(enumerate(leaks, 1))

    return expected


@repeats(ACCURACY, "| triangles | 325 | 650 |", "figures/mesh.csv")
def mesh(rows):
    scenes = by((row for row in rows if row["trusted"] == "false"), "valve", "scene")
    rows = [row for row in rows if (row["valve"], row["scene"]) not in scenes]  # all at rest on every mesh

    def errors(triangles, large):
        for row in rows:
            leak, reference = float(row["leak_mm2"]), float(row["reference_leak_mm2"])
            if row["triangles"] == triangles and (reference > 10 if large else reference < 5):
                yield 100 * (leak - reference) / reference if large else abs(leak - reference)

    def column(what, triangles):
        if what.startswith("leak, median error"):
            relative = [abs(error) for error in errors(triangles, True)]
            return [statistics.median(relative), quantile(relative, 0.9)]
        if what.startswith("median of its signed error"):
            return [statistics.median(errors(triangles, True))]
        if what.startswith("leaks below 5 mm²"):
            small = list(errors(triangles, False))
            return [statistics.median(small), quantile(small, 0.9)]
        distances = [float(row["rms_mm"]) for row in rows if row["triangles"] == triangles]
        return [statistics.median(distances), quantile(distances, 0.9)]

    return lambda cells: {i: column(cells[0], size) for i, size in enumerate(("325", "650", "1300", "2600"), 1)}


@repeats(ACCURACY, "| | own mesh | refined once | made anew |", "figures/refined.csv")
def refined(rows):
    known = by(rows, "valve")
    names = ("leak_mm2", "refined_mm2", "anew_mm2")
    return lambda cells: dict(enumerate((known[(cells[0].split(",")[0],)][name] for name in names), 1))


@repeats(ACCURACY, "| valve | leak, nominal | mean | model ±", "figures/model.csv")
def model_leaks(rows):
    def expected(cells):
        row = next(one for one in rows if one["valve"] == cells[0] and one.get("area", "leak") == "leak")
        names = ("as_it_is_mm2", "mean_mm2", "sd_mm2")
        last = {4: [row["p5_mm2"], row["p95_mm2"]], 5: [row["untrusted"], row["draws"]]}
        return dict(enumerate((row[name] for name in names), 1)) | last

    return expected


@repeats(ACCURACY, "| parameter, factor of the valve's own value", "figures/model.csv")
def model_shares(rows):
    known = by((row for row in rows if row.get("area", "leak") == "leak"), "valve", "parameter")
    valves = ("human-functional-mr", "human-p2-prolapse", "human-normal")

    def expected(cells):
        if cells[0].startswith("predicted"):
            return {i: known[valve, "chordal length"]["predicted_share"] for i, valve in enumerate(valves, 2)}
        found = [known[valve, cells[0].split(",")[0]] for valve in valves]
        limits = {0: [found[0]["lower"], found[0]["upper"]]}
        names = ("sobol_first", "sobol_total", "effect_mm2")
        return limits | {i: [row[name] for name in names] for i, row in enumerate(found, 2)}

    return expected


@repeats("docs/researcher/diseases.md", "| preset | from sources | assumed | leak |", "figures/diseases.csv")
def diseases(rows):
    known = by(rows, "valve")

    def expected(cells):
        row = known[(cells[0].split(",")[0].strip("`"),)]
        leak = [row["leak_mm2"], row["leak_error_mm2"]][: 2 if "±" in cells[3] else 1]
        return {3: leak, 4: row["coaptation_area_percent"], 5: row["tenting_height_mm"]}

    return expected


@repeats("docs/researcher/model.md", "| valve | no ring | 24 mm |", "figures/openings.csv")
def openings(rows):
    known = by(rows, "valve", "ring_mm")

    def expected(cells):
        found = [known[cells[0].strip("`"), ring] for ring in "none 24 26 28 30 32 34 36".split()]
        for cell, row in zip(cells[1:], found):
            if ("leaks" in cell) != (float(row["leak_mm2"]) > 1.0):
                return {0: f"{cells[0]}, ring {row['ring_mm']}: a leak of {row['leak_mm2']} mm²"}
        return {i: [row["opening_cm2"], row["gradient_mmhg"]] for i, row in enumerate(found, 1)}

    return expected


@repeats(SEARCH, "| | valves | indicated first plan |", "figures/indications.csv")
def indications(rows):
    def expected(cells):
        members = cells[0].startswith("members")
        found = [row for row in rows if row["valve"].startswith("member-") == members]
        right = sum(row["indicated"] == "true" for row in found)
        return {1: len(found), 2: right, 3: sum(row["type"] == row["diagnosed"] for row in found)}

    return expected


@repeats(SEARCH, "| valve | first plan | reserve, mm |", "figures/challenges.csv")
def challenges(rows):
    known = by(rows, "valve")
    names = "durability_mm first_plan ring_acceptable ring_durability_mm challengers beat_first ahead_of_first".split()

    def expected(cells):
        bears, _, *others = (known[(cells[0],)][name] for name in names)
        return {2: bears} | dict(enumerate(others, 4))

    return expected


METHODS = {
    "random search over plans": "random",
    "random search over variables": "random_variables",
    "NLopt MLSL + BOBYQA": "mlsl_lds_bobyqa",
    "dlib": "dlib_find_min_global",
}


@repeats(SEARCH, "| method | 5 | 2 | 1 |", "figures/ert.csv")
def ert(rows):
    known = by(rows, "method", "target_mm2")

    def expected(cells):
        method = METHODS.get(cells[0], cells[0].lower().removeprefix("nlopt ").replace(" ", "_"))
        return {i: known[method, target]["ert_closures"] for i, target in enumerate("5 2 1 0.5 0.2 0.1 0".split(), 1)}

    return expected


@repeats(SEARCH, "| lattice (plans, of which accepted)", "figures/front.csv")
def front(rows):
    def expected(cells):
        name = cells[0].split()[0]
        found = by((row for row in rows if row["lattice"] == name), "method", "share")
        any_row = next(iter(found.values()))
        told = {0: [any_row["plans"], any_row["accepted"]]}
        for i, method in enumerate(("coapt", "pagmo_nsga2", "pagmo_moead", "random"), 1):
            pair = [found[method, share] for share in ("0.9", "0.99")]
            told[i] = [pair[0]["closures"], pair[1]["closures"]]
            if pair[1]["reached"] != pair[1]["runs"]:  # too few to have a median
                told[i][1:] = [pair[1]["reached"], pair[1]["runs"]]
        return told

    return expected


@repeats("docs/researcher/files.md", "| tips seen / drawn | leak | after import |", "figures/closed_import.csv")
def closed_import(rows):
    known = by(rows, "valve", "tips")

    def expected(cells):
        seen, drawn = (known[cells[0].split(",")[0].strip("`"), tips] for tips in ("seen", "drawn"))
        fitted = [one[name] for one in (seen, drawn) for name in ("fitted_leak_mm2", "fitted_leak_sd_mm2")]
        return {
            1: seen["leak_mm2"],
            2: [seen["imported_leak_mm2"], drawn["imported_leak_mm2"]],
            3: fitted,
            4: [seen["surface_rms_mm"], drawn["surface_rms_mm"]],
        }

    return expected


@repeats("docs/researcher/studies.md", "| | AL | PM | both |", "figures/anchors.csv")
def anchors(rows):
    known = by(rows, "protocol", "class", "objective")
    protocols = {
        "by the thesis's look-up": ("lookup-clamped", "sd"),
        "every position closed": ("closed", "sd"),
        "each anchor at its own best length": ("optimum", "sd"),
        "less sensitive to suture length, every position closed": ("closed", "length sensitivity"),
    }

    def expected(cells):
        protocol, objective = protocols[cells[0]]
        found = [known[protocol, muscles, objective] for muscles in ("AL", "PM", "both")]
        return {i: 100 * int(row["trigone_wins"]) / int(row["anatomies"]) for i, row in enumerate(found, 1)}

    return expected


@repeats("docs/researcher/texas-trivalve.md", "| | node to node, rms | node to surface", "figures/trivalve_slack.csv")
def trivalve(rows):
    known = by(rows, "start", "state", "part")
    states = {
        "slack as measured": ("known", "as measured"),
        "every tree as long as straight lines": ("straight", "before"),
        "fitted": ("straight", "fitted"),
    }

    def expected(cells):
        everywhere, held_out = (known[(*states[cells[0]], part)] for part in ("all", "held out"))
        pair = [held_out["node_rms_mm"], held_out["surface_rms_mm"]]
        return {1: everywhere["node_rms_mm"], 2: everywhere["surface_rms_mm"], 3: pair}

    return expected


# Sentences with numbers of a file: where, a pattern whose groups are numbers, the file, and what they are.
PROSE = (
    (
        "docs/researcher/studies.md",
        r"Of (\d+) findings (\d+) agree",
        "figures/porcine-thesis-findings.json",
        lambda found: [len(found), sum(one["agrees"] for one in found)],
    ),
    (
        "docs/ROADMAP.md",
        r"The real valve leaks ([\d.]+) / ([\d.]+) / ([\d.]+) mm² at ([\d,]+) / ([\d,]+) / ([\d,]+) triangles",
        "figures/closures.csv",
        lambda rows: [row[name] for name in ("leak_mm2", "triangles") for row in real_valves(rows)],
    ),
    (
        "README.md",
        r"the valve above, which leaks (\d+) ± \d+ mm²",
        "figures/closures.csv",
        lambda rows: [by(rows, "valve", "method")["bodyparts3d-leaking", "fast"]["leak_mm2"]],
    ),
    (
        "docs/experiments.md",
        r"Against release 0.1 in one run .*: cold ([\d.]+) to ([\d.]+),",
        "figures/releases.csv",
        lambda rows: [limit(float(row["time"]) for row in rows if row["start"] == "cold") for limit in (min, max)],
    ),
    (
        "docs/engineer/farm.md",
        r"40 tasks of 1.8 s each \| ([\d.]+) %",
        "figures/farm.csv",
        lambda rows: [100 * float(next(row for row in rows if row["task_ms"] == "1800")["computing_share"])],
    ),
    (
        "docs/engineer/farm.md",
        r"1, 4, 16, 64, 128 workers \| ([\d.]+), ([\d.]+), ([\d.]+), ([\d.]+), ([\d.]+) %",
        "figures/farm.csv",
        lambda rows: [100 * float(row["computing_share"]) for row in rows if row["task_ms"] == "200"],
    ),
)


def real_valves(rows):
    known = by(rows, "valve", "method")
    return [known[f"bodyparts3d{mesh}", "fast"] for mesh in ("", "-1400", "-2600")]


def prose_problems():
    wrong, compared = [], 0
    for document, pattern, file, values in PROSE:
        text = (ROOT / document).read_text(encoding="utf-8")
        found = re.search(pattern, text)
        if found is None:
            wrong.append(f"{document}: nothing is like {pattern!r}, of {file}")
            continue
        line = text.count("\n", 0, found.start()) + 1
        for printed, value in zip(found.groups(), values(rows_of(file)), strict=True):
            compared += 1
            if not agrees(printed, value):
                wrong.append(f"{document}:{line}: prints {printed}, the file has {float(value):.6g} ({file})")
    return wrong, compared


def tables(text):
    """First line's number and rows of cells of each table."""
    lines, at = text.splitlines(), 0
    while at < len(lines):
        begun, found = at, []
        while at < len(lines) and lines[at].lstrip().startswith("|"):
            found.append([cell.strip() for cell in lines[at].strip().strip("|").split("|")])
            at += 1
        if found:
            yield begun + 1, lines[begun].strip(), found
        at = max(at, begun + 1)


def agrees(printed, value):
    """Whether a printed number is this one, rounded to the digits that it has."""
    text = printed.replace(",", "")
    decimals = len(text.partition(".")[2])
    return abs(float(text) - float(value)) <= 0.5 * 10**-decimals * (1 + 1e-9) + 1e-9


def cell_problem(cell, expected):
    """What is wrong, or nothing; how many numbers were compared."""
    if isinstance(expected, str) and not NUMBER.fullmatch(expected):
        return (None if cell == expected else f"prints {cell!r}, the file has {expected!r}"), 1
    values = expected if isinstance(expected, list) else [expected]
    printed = NUMBER.findall(cell)
    if len(printed) < len(values):
        return f"prints {cell!r}, the file has {values}", len(values)
    wrong = [(text, value) for text, value in zip(printed, values) if not agrees(text, value)]
    told = "; ".join(f"prints {text}, the file has {float(value):.6g}" for text, value in wrong)
    return told or None, len(values)


def table_problems():
    wrong, compared = [], 0
    for document, header, file, expectation in TABLES:
        text = (ROOT / document).read_text(encoding="utf-8")
        found = [table for table in tables(text) if table[1].startswith(header)]
        if len(found) != 1:
            wrong.append(f"{document}: {len(found)} tables begin with {header!r}, of {file}")
            continue
        expected_of = expectation(rows_of(file))
        for line, cells in enumerate(found[0][2][2:], found[0][0] + 2):
            try:
                expected = expected_of(cells)
            except (KeyError, StopIteration) as error:
                wrong.append(f"{document}:{line}: {cells[0]}: no such row in {file}: {error}")
                continue
            for place, value in expected.items():
                told, count = cell_problem(cells[place], value)
                compared += count
                if told:
                    wrong.append(f"{document}:{line}: {cells[0]}, column {place}: {told} ({file})")
    return wrong, compared


def tracked(*patterns):
    told = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", *patterns],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    return [path for path in told.stdout.splitlines() if (ROOT / path).exists()]


def figure_problems():
    """Of files of docs/figures and docs/images: each has a row of the list, pictures a document that shows them."""
    rows = (FIGURES / "README.md").read_text(encoding="utf-8")
    named = {word for cell in re.findall(r"^\| (.*?) \|", rows, re.MULTILINE) for word in re.findall(r"[\w*.-]+", cell)}
    documents = [path for path in tracked("*.md") if path != "docs/figures/README.md"]
    shown = "\n".join((ROOT / path).read_text(encoding="utf-8") for path in documents)
    for path in tracked("docs/figures/*", "docs/images/*"):
        name = pathlib.PurePath(path).name
        if name == "README.md":
            continue
        if not any(fnmatch.fnmatch(name, pattern) for pattern in named):
            yield f"{path}: has no row in docs/figures/README.md"
        if name.endswith((".png", ".svg")) and name not in shown:
            yield f"{path}: no document shows it"


def version_problems():
    """Pictures of the page carry its version; pictures.mjs writes which into page.json beside them."""
    version = re.search(r"project\(coapt VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    made = json.loads((IMAGES / "page.json").read_text(encoding="utf-8"))
    if made["version"] != version:
        yield f"docs/images/page.json: pictures of version {made['version']}, not {version}: make web-pictures"
    pictures = {pathlib.PurePath(path).name for path in tracked("docs/images/page-*.png")}
    for name in sorted(pictures ^ set(made["pictures"])):
        yield f"docs/images/{name}: not made with the pictures that page.json lists"


def page_problems():
    """Each page of docs/ stands in a table of docs/README.md."""
    listed = (ROOT / "docs/README.md").read_text(encoding="utf-8")
    for path in tracked("docs/*.md"):
        inside = path.removeprefix("docs/")
        if not inside.startswith("site/") and inside != "README.md" and f"]({inside})" not in listed:
            yield f"{path}: docs/README.md does not list it"


ANEW = {f"{name}.csv": f"{name}_table.py" for name in ("closures", "diseases", "refined", "openings")}


def anew_problems(coapt):
    """Tables that take a minute or two, made by this program, line by line."""
    with tempfile.TemporaryDirectory() as folder:
        for name, script in ANEW.items():
            made = pathlib.Path(folder) / name
            command = [ROOT / "lab/closures" / script, *anew_arguments(script, coapt, made)]
            subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
            old, new = (file.read_text(encoding="utf-8").splitlines() for file in (FIGURES / name, made))
            for line, (before, after) in enumerate(zip(old, new), 1):
                if before != after:
                    yield f"docs/figures/{name}:{line}: has {before}, {coapt} makes {after}"
            if len(old) != len(new):
                yield f"docs/figures/{name}: has {len(old)} lines, {coapt} makes {len(new)}"


def anew_arguments(script, coapt, made):
    return [made, "--coapt", coapt] if script == "openings_table.py" else [coapt, made]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--anew", metavar="COAPT", type=pathlib.Path)
    arguments = parser.parse_args()
    (wrong, compared), (others, more) = table_problems(), prose_problems()
    wrong += [*others, *figure_problems(), *version_problems(), *page_problems()]
    if arguments.anew:
        wrong += anew_problems(arguments.anew.resolve())
    print(
        "\n".join(
            [
                *wrong,
                f"{compared + more} numbers of {len(TABLES)} tables and {len(PROSE)} sentences compared, {len(wrong)} problems",
            ]
        )
    )
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
