#!/usr/bin/python3
"""check_files.py COAPT VALIDATE_GLB: writes valves with `coapt export` and reads every format with a reader that is not
ours: VTK, Khronos' glTF validator (VALIDATE_GLB is its command), Python's csv, json and XML with jsonschema. Then it damages
each file and expects the damage to be found. Prints what is wrong; exit code 1 if anything is."""

import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

import feb_rules
import read_vtk

HERE = pathlib.Path(__file__).resolve().parent
VALVES = {
    "plain": ["human-normal"],
    "repaired": ["human-functional-mr", "--plan", HERE / "plan.json"],
    # Chordae that insert between vertices.
    "imported": [HERE.parents[1] / "examples/valves/bodyparts3d.json"],
    "open": ["human-p2-prolapse", "--open"],
}
POINT_DATA = {"height_mm"}
FACE_DATA = {"leaflet", "segment", "crossing", "strain_circumferential", "strain_radial"}
LINE_DATA = {"chorda", "kind", "rest_length_mm", "diameter_mm", "tension_n"}
LINE_DATA |= {f"to_insertion_{axis}" for axis in "xyz"}
# Of SlicerHeart's Valve Quantification, preset mitral valve (MeasurementPreset.py, MeasurementPresetMitralValve.py) and
# module Orifice Area; names and units as there.
METRICS = {
    "Annulus circumference (3D)": "mm",
    "A-P distance": "mm",
    "AL-PM distance": "mm",
    "ALC-PMC distance": "mm",
    "Sphericity index (A-P / AL-PM)": "mm/mm",
    "Annulus height": "mm",
    "Annulus height above": "mm",
    "Annulus height below": "mm",
    "Annulus area (2D)": "mm*mm",
    "Tenting height": "mm",
    "Regurgitant orifice area": "mm*mm",
}
METRICS |= {
    f"Coaptation anterior - posterior height ({which})": "mm"
    for which in ["min", "mean", "max"] + [f"{percent}th percentile" for percent in (10, 25, 50, 75, 90)]
}


def export(coapt, folder, arguments):
    """All formats of a valve."""
    formats = ["glb", "vtk", "ply", "obj", "stl", "mrk.json", "feb"] + (["csv"] if "--open" not in arguments else [])
    outputs = [part for format in formats for part in ("-o", folder / f"valve.{format}")]
    subprocess.run(
        [coapt, "export", *arguments, *outputs, "-o", f"{folder}/folder/"], check=True, stderr=subprocess.DEVNULL
    )


def section(text, name):
    """The lines of a section of a VTK file, as they are printed."""
    lines = text.splitlines()
    first = next((i for i, line in enumerate(lines) if line.split()[:1] == [name]), None)
    if first is None:
        return []
    return lines[first + 1 : first + 1 + int(lines[first].split()[1])]


def check_vtk(path, has_faces=True, has_lines=True):
    data, problems = read_vtk.read(path)
    text = path.read_text()
    lines, faces = section(text, "LINES"), section(text, "POLYGONS")
    if read_vtk.cells(data) != (len(lines), len(faces)) or data.GetNumberOfPoints() != len(section(text, "POINTS")):
        problems.append("VTK reads other numbers of points, lines or triangles than the file holds")
    if bool(lines) != has_lines or bool(faces) != has_faces:
        problems.append("lines or triangles are missing, or there are some too many")
    expected = (
        POINT_DATA if has_faces else set(),
        (FACE_DATA if has_faces else set()) | (LINE_DATA if has_lines else set()),
    )
    if read_vtk.arrays(data) != expected:
        problems.append(f"data are {read_vtk.arrays(data)}")
    if "SPACE=LPS" not in text.splitlines()[1]:
        problems.append("SPACE=LPS is missing")
    if max(map(len, text.splitlines())) >= 255:
        problems.append("a line is longer than FEBio Studio reads")
    if has_faces and not 300.0 < read_vtk.area(data) < 3000.0:
        problems.append(f"the leaflets have an area of {read_vtk.area(data):.0f} mm2")
    return problems


def check_chordae(lines_path, mesh_path):
    """Every line ends where another begins, or at a vertex of the mesh: compared as printed."""
    text = lines_path.read_text()
    points = section(text, "POINTS")
    pieces = [tuple(map(int, line.split()[1:])) for line in section(text, "LINES")]
    begins = {points[start] for start, _ in pieces}
    vertices = set(section(mesh_path.read_text(), "POINTS"))
    loose = [end for _, end in pieces if points[end] not in begins | vertices]
    return [f"{len(loose)} chordae end at no vertex of {mesh_path.name}"] if loose or not pieces else []


def check_mesh(path, vtk_path):
    """The same triangles as the leaflets in VTK's own format."""
    data, problems = read_vtk.read(path)
    reference, _ = read_vtk.read(vtk_path)
    if data.GetNumberOfPolys() != reference.GetNumberOfPolys():
        return problems + [f"has {data.GetNumberOfPolys()} triangles, not {reference.GetNumberOfPolys()}"]
    if abs(read_vtk.area(data) - read_vtk.area(reference)) > 0.01:
        problems.append("has another area")
    if max(abs(a - b) for a, b in zip(data.GetBounds(), reference.GetBounds())) > 1e-4:
        problems.append("lies elsewhere")
    return problems


def check_glb(path, validate, vtk_path, animated):
    result = subprocess.run([*validate, path], capture_output=True, text=True)
    problems = (result.stdout + result.stderr).splitlines() if result.returncode else []
    if problems:
        return problems
    bounds, played, problems = read_vtk.glb(path)
    low_x, high_x, low_y, high_y, low_z, high_z = read_vtk.read(vtk_path)[0].GetBounds()
    # Metres; y to the atrium, z posterior; tubes and the ring are thicker than lines.
    expected = [low_x, high_x, low_z, high_z, -high_y, -low_y]
    if max(abs(1e3 * a - b) for a, b in zip(bounds, expected)) > 1.5:
        problems.append(f"bounds are {bounds} m, not {expected} mm")
    if bool(played) != animated:
        problems.append("is animated" if played else "is not animated")
    if played and (max(abs(a - b) for a, b in zip(played[1], bounds)) > 1e-5 or played[0] == played[1]):
        problems.append("its animation does not end in the valve that is shown")
    return problems


def check_markups(path):
    schema = json.loads((HERE / "markups.schema.json").read_text())
    try:
        document = json.loads(path.read_text())
    except ValueError as error:
        return [str(error)]
    return [
        f"/{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}"
        for e in jsonschema.Draft7Validator(schema).iter_errors(document)
    ]


def check_csv(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    problems = [
        f"{row['Metric']} in {row['Unit']} is none of SlicerHeart's"
        for row in rows
        if METRICS.get(row["Metric"]) != row["Unit"]
    ]
    problems += [f"{row['Metric']} is {row['Value']}" for row in rows if not math.isfinite(float(row["Value"]))]
    return problems + [f"{name} is missing" for name in METRICS.keys() - {row["Metric"] for row in rows}]


def checks(folder, validate, name):
    """(file, a function without arguments that lists what is wrong with it)"""
    sheets = folder / "folder"
    valve = folder / "valve.vtk"
    yield valve, lambda: check_vtk(valve) + check_chordae(valve, sheets / "leaflets.vtk")
    yield sheets / "Chords_mesh.vtk", lambda: (
        check_vtk(sheets / "Chords_mesh.vtk", has_faces=False)
        + check_chordae(sheets / "Chords_mesh.vtk", sheets / "leaflets.vtk")
    )
    for sheet in ("leaflets", "anterior_leaflet", "posterior_leaflet"):
        yield sheets / f"{sheet}.vtk", lambda path=sheets / f"{sheet}.vtk": check_vtk(path, has_lines=False)
    for format in ("ply", "obj", "stl"):
        path = folder / f"valve.{format}"
        yield path, lambda path=path: check_mesh(path, sheets / "leaflets.vtk")
    glb = folder / "valve.glb"
    yield glb, lambda: check_glb(glb, validate, valve, animated=name != "open")
    for path in [folder / "valve.mrk.json", *sorted(sheets.glob("*.mrk.json"))]:
        yield path, lambda path=path: check_markups(path)
    for path in [folder / "valve.csv", sheets / "measurements.csv"] if name != "open" else []:
        yield path, lambda path=path: check_csv(path)
    yield folder / "valve.feb", lambda: feb_rules.problems_of(folder / "valve.feb")


def damaged(path, content):
    """The same file with one thing wrong in it."""
    lines = content.rstrip().split(b"\n")
    if path.suffix == ".vtk" and b"LINES" in content:  # the end of the last chorda is moved by what nobody sees
        last = next(i for i, line in enumerate(lines) if line.startswith(b"LINES")) - 1
        lines[last] += b"1" if b"." in lines[last].split()[-1] else b".1"
        return b"\n".join(lines) + b"\n"
    if path.suffix in (".vtk", ".obj"):
        return b"\n".join(lines[:-1]) + b"\n"
    if path.suffix == ".ply":  # VTK itself dies of a file that is cut off
        first = lines.index(b"end_header") + 1
        return b"\n".join([*lines[:first], b"99 0 0", *lines[first + 1 :]]) + b"\n"
    if path.suffix == ".stl":
        return content[:-25]
    replacements = {
        ".glb": (b'"VEC3"', b'"VEC2"'),
        ".json": (b'"defined"', b'"preview"'),
        ".csv": (b",mm\n", b",cm\n"),
        ".feb": (b'discrete_set="1.1', b'discrete_set="0.1'),
    }
    old, new = replacements[path.suffix]
    if path.suffix == ".csv":
        old, new = b",mm,", b",cm,"
    assert old in content, path
    return content.replace(old, new, 1)


def main(coapt, *validate):
    wrong = files = 0
    with tempfile.TemporaryDirectory() as root:
        for name, arguments in VALVES.items():
            folder = pathlib.Path(root) / name
            folder.mkdir()
            export(coapt, folder, arguments)
            for path, check in checks(folder, validate, name):
                files += 1
                for problem in check():
                    wrong += 1
                    print(f"{name}/{path.relative_to(folder)}: {problem}")
                if name != "repaired":
                    continue
                content = path.read_bytes()
                path.write_bytes(damaged(path, content))
                if not check():
                    wrong += 1
                    print(f"{name}/{path.relative_to(folder)}: damage was not found")
                path.write_bytes(content)
    print(f"{files} files read, {wrong} problems")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
