#!/usr/bin/python3
"""Eight valves, closed and open, on one sheet: do a surgeon and an echo reader recognise them?

  lab/charts/valve_sheet.py [OUTPUT] [--coapt build/release/bin/coapt]

The pictures of `coapt close --render` and `coapt open --render`, cut to their views: six presets, a clip behind which it leaks on one side, and a
healthy valve whose loose commissural chordae let a commissure fold.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

from PIL import Image, ImageDraw, ImageFont

CALIBRATED = "examples/calibration/human-normal.json"
EDGE_TO_EDGE = "examples/plans/edge-to-edge.json"
FOLDING = ["--commissural-slack", "1.4", "--commissure-height-mm", "8"]
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
ATRIAL, SECTION = (20, 120, 890, 830), (950, 100, 1580, 620)  # of a picture, pixels
ACROSS, WIDE, GAP, HEADING = 4, 330, 8, 36
COLOURS = 96


def font(size):
    return ImageFont.truetype("DejaVuSans.ttf", size)


def make_picture(coapt, command, name, folder):
    """The picture, and the figure that is written into it."""
    valve, plan = name, []
    if name == "clip":
        valve, plan = "marfan", ["--plan", folder / "clip.json"]
        steps = json.loads(pathlib.Path(EDGE_TO_EDGE).read_text())
        steps["steps"] = [step for step in steps["steps"] if step["step"] == "edge_to_edge"]
        (folder / "clip.json").write_text(json.dumps(steps))
    if name == "fold":
        valve = folder / "fold.json"
        subprocess.run([coapt, "valve", "make", "--dimensions", CALIBRATED, *FOLDING, "-o", valve], check=True)
    picture = folder / f"{name}-{command}.png"
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


def column(coapt, name, folder):
    closed, leak = make_picture(coapt, "close", name, folder)
    opened, opening = make_picture(coapt, "open", name, folder)
    print(f"{VALVES[name]}: {leak}, {opening}", flush=True)
    parts = [cell(closed, ATRIAL), cell(closed, SECTION), cell(opened, ATRIAL)]
    high = HEADING + sum(part.height + GAP for part in parts)
    sheet = Image.new("RGB", (WIDE, high), "white")
    pen = ImageDraw.Draw(sheet)
    pen.text((6, 3), f"{VALVES[name]}\n{leak}, {opening}", "black", font(12))
    y = HEADING
    for part in parts:
        sheet.paste(part, (0, y))
        y += part.height + GAP
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=pathlib.Path("docs/images/valves.png"))
    parser.add_argument("--coapt", type=pathlib.Path, default=pathlib.Path("build/release/bin/coapt"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        columns = [column(options.coapt, name, pathlib.Path(folder)) for name in VALVES]
    high = columns[0].height
    sheet = Image.new("RGB", (ACROSS * (WIDE + GAP), -(-len(columns) // ACROSS) * high), "white")
    for i, one in enumerate(columns):
        sheet.paste(one, (i % ACROSS * (WIDE + GAP), i // ACROSS * high))
    sheet.quantize(COLOURS, dither=Image.Dither.NONE).save(options.output, optimize=True)


if __name__ == "__main__":
    main()
