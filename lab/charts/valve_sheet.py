#!/usr/bin/python3
"""Valves, closed and open, on one sheet: do a surgeon and an echo reader recognise them?

  lab/charts/valve_sheet.py [OUTPUT] [--plans] [--coapt build/release/bin/coapt]

The pictures of `coapt close --render` and `coapt open --render`, cut to their views. Eight valves: six presets, a clip behind which it leaks on one
side, and a healthy valve whose loose commissural chordae let a commissure fold. With --plans six diseased valves, four presets and two that are
made from the healthy one, each before and after the first plan of a search (300 evaluations, a minute of a core each).
"""

import argparse
import json
import pathlib
import subprocess
import tempfile
import textwrap

from PIL import Image, ImageDraw, ImageFont

CALIBRATED = "examples/calibration/human-normal.json"
EDGE_TO_EDGE = "examples/plans/edge-to-edge.json"
FOLDING = ["--commissural-slack", "1.4", "--commissure-height-mm", "8"]
LOOSE = ["--commissural-slack", "1.5"]
COMMISSURE = ["--rupture", "A1", "--rupture", "P1"]
CLEFTS = ["--cleft-depth-mm", "8"]
# Name and what is written over it; a valve is a preset, or made below.
VALVES = {
    "human-normal": "normal",
    "human-functional-mr": "functional (tethered)",
    "fibroelastic-flail": "flail P2",
    "barlow": "Barlow",
    "marfan": "Marfan",
    "hypertrophic": "hypertrophic",
    "clip": "Marfan behind a clip",
    "fold": "fold of a commissure",
}
REPAIRED = {
    "human-functional-mr": "functional (tethered)",
    "human-p2-prolapse": "prolapse of P2",
    "commissure": "flail anterolateral commissure",
    "barlow": "Barlow",
    "marfan": "Marfan",
    "clefts": "clefts on either side of P2",
}
EVALUATIONS = 300
ATRIAL, SECTION = (20, 120, 890, 830), (950, 100, 1580, 620)  # of a picture, pixels
WIDE, GAP, LINE, WORDS = 330, 8, 15, 4  # pixels, but for lines of words about a plan
COLOURS = 96


def font(size):
    return ImageFont.truetype("DejaVuSans.ttf", size)


def made_valve(coapt, name, folder):
    """What is closed: a preset or file, and options for the plan that it is closed with."""
    if name == "clip":
        plan = json.loads(pathlib.Path(EDGE_TO_EDGE).read_text())
        plan["steps"] = [step for step in plan["steps"] if step["step"] == "edge_to_edge"]
        return "marfan", kept_plan(plan, folder / "clip.json")
    if name == "fold":
        valve = folder / "fold.json"
        subprocess.run([coapt, "valve", "make", "--dimensions", CALIBRATED, *FOLDING, "-o", valve], check=True)
        return valve, []
    if name == "commissure":
        loose, valve = folder / "loose.json", folder / "commissure.json"
        subprocess.run([coapt, "valve", "make", "--dimensions", CALIBRATED, *LOOSE, "-o", loose], check=True)
        subprocess.run([coapt, "valve", "remodel", loose, *COMMISSURE, "-o", valve], check=True)
        return valve, []
    if name == "clefts":
        valve = folder / "clefts.json"
        subprocess.run([coapt, "valve", "make", "--dimensions", CALIBRATED, *CLEFTS, "-o", valve], check=True)
        return valve, []
    return name, []


def kept_plan(plan, file):
    file.write_text(json.dumps(plan))
    return ["--plan", file]


def first_plan(coapt, name, valve, folder):
    """Options for the first plan of a search, and its steps in words."""
    command = [coapt, "plan", valve, "--threads", "1", "--evaluations", str(EVALUATIONS), "--json"]
    told = subprocess.run(command, capture_output=True, text=True, check=True)
    first = json.loads(told.stdout)["plans"][0]
    return kept_plan(first["plan"], folder / f"{name}-plan.json"), "; ".join(first["description"])


def make_picture(coapt, command, valve, plan, picture):
    """The picture, and the figure that is written into it."""
    told = subprocess.run(
        [coapt, command, valve, *plan, "--render", picture, "--json"], capture_output=True, text=True, check=True
    )
    answer = json.loads(told.stdout)
    if command == "close":
        figure = f"leak {answer['leak_mm2']:.1f} ± {answer['leak']['error_mm2']:.1f} mm²"
    else:
        figure = f"opens to {0.01 * answer['opening_area_mm2']:.1f} cm²"
    return Image.open(picture).convert("RGB"), figure


def cell(picture, box):
    part = picture.crop(box)
    return part.resize((WIDE, WIDE * part.height // part.width), Image.Resampling.LANCZOS)


def column(heading, parts):
    print(" | ".join(heading.split("\n")), flush=True)
    y = 6 + LINE * (1 + heading.count("\n"))
    sheet = Image.new("RGB", (WIDE, y + sum(part.height + GAP for part in parts)), "white")
    pen = ImageDraw.Draw(sheet)
    pen.text((6, 3), heading, "black", font(12))
    for part in parts:
        sheet.paste(part, (0, y))
        y += part.height + GAP
    return sheet


def valve_column(coapt, name, folder):
    valve, plan = made_valve(coapt, name, folder)
    closed, leak = make_picture(coapt, "close", valve, plan, folder / f"{name}-closed.png")
    opened, opening = make_picture(coapt, "open", valve, plan, folder / f"{name}-open.png")
    parts = [cell(closed, ATRIAL), cell(closed, SECTION), cell(opened, ATRIAL)]
    return column(f"{VALVES[name]}\n{leak}, {opening}", parts)


def plan_column(coapt, name, folder):
    valve, _ = made_valve(coapt, name, folder)
    plan, words = first_plan(coapt, name, valve, folder)
    before, leak = make_picture(coapt, "close", valve, [], folder / f"{name}-before.png")
    closed, left = make_picture(coapt, "close", valve, plan, folder / f"{name}-closed.png")
    opened, opening = make_picture(coapt, "open", valve, plan, folder / f"{name}-open.png")
    views = [(before, ATRIAL), (before, SECTION), (closed, ATRIAL), (closed, SECTION), (opened, ATRIAL)]
    lines = (textwrap.wrap(words, 46) + WORDS * [""])[:WORDS]
    figures = f"{leak.removesuffix(' mm²')} → {left.removeprefix('leak ')}, {opening}"
    return column("\n".join([REPAIRED[name], figures, *lines]), [cell(*view) for view in views])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, help="default: a file of docs/images")
    parser.add_argument("--plans", action="store_true", help="six valves before and after their first plan")
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        draw, names, across = (plan_column, REPAIRED, 3) if options.plans else (valve_column, VALVES, 4)
        columns = [draw(options.coapt, name, pathlib.Path(folder)) for name in names]
    high = columns[0].height
    sheet = Image.new("RGB", (across * (WIDE + GAP), -(-len(columns) // across) * high), "white")
    for i, one in enumerate(columns):
        sheet.paste(one, (i % across * (WIDE + GAP), i // across * high))
    output = options.output or pathlib.Path("docs/images") / ("first-plans.png" if options.plans else "valves.png")
    sheet.quantize(COLOURS, dither=Image.Dither.NONE).save(output, optimize=True)


if __name__ == "__main__":
    main()
