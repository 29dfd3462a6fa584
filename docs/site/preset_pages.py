"""Pages of the presets: what each is, its picture, its dimensions, and its figures beside those measured in hearts."""

import json
import pathlib

from pages import ROOT, escaped

INTRODUCTION = """# Presets

Valves that every command knows by name: `coapt close human-normal`. Human diseases are the healthy human valve, remodelled
([diseases](../../researcher/diseases.md)); pig hearts have the measured dimensions of the thesis. None is a patient. The last column
counts published ranges of [physiology](../../researcher/physiology.md) that a valve meets.

| preset | what it is | leak, mm² | annulus, mm | leaflets, mm² | ranges met |
|---|---|---|---|---|---|
"""


def number(value, digits=3):
    return "" if value is None else f"{value:.{digits}g}"


def leak_of(preset):
    leak = preset["closure"]["leak"]
    error = leak["error_mm2"]
    return f"{leak['area_mm2']:.1f}" + ("" if error is None else f" ± {error:.1f}")


def has_range(row):
    return row["low"] is not None or row["high"] is not None


def range_of(row):
    low, high = row["low"], row["high"]
    if low is None or high is None:
        return f"{number(low)} or more" if low is not None else f"{number(high)} at most" if high is not None else ""
    return f"{number(low)} to {number(high)}"


def met_of(preset):
    """Ranges that are met, of those that are published for its kind of valve and have a value."""
    judged = [row for row in preset["physiology"] if has_range(row)]
    return f"{sum(row['verdict'] == 'met' for row in judged)} of {len(judged)}"


def dimensions_of(preset):
    valve, measure = preset["valve"], preset["closure"]
    chordae = ", ".join(f"{count} {kind}" for kind, count in valve["chordae"].items())
    return {
        "Saddle peak to mid-posterior": f"{valve['saddle_to_mid_posterior_mm']:.1f} mm",
        "Between the commissures": f"{valve['commissures_mm']:.1f} mm",
        "Leaflets, unstressed": f"{valve['leaflet_area_mm2']:.0f} mm²",
        "Chordae": f"{chordae}; {valve['ruptured_chordae']} ruptured",
        "Pressure": f"{valve['pressure_kpa']:g} kPa",
        "Mesh": f"{valve['triangles']} triangles",
        "Leak": f"{leak_of(preset)} mm²",
        "Tenting height": f"{measure['tenting_height_mm']:.1f} mm",
    }


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def preset_page(preset):
    name = preset["name"]
    parts = [
        f"# {name}",
        f"{preset['title']}. {preset['about']}",
        f"![{name}, closed: from the atrium and in section]({name}.png)",
        table(["", ""], [[what, value] for what, value in dimensions_of(preset).items()]),
        "\n".join(f"- {escaped(line)}" for line in preset["valve"]["provenance"]),
    ]
    rows = [
        [
            f"{escaped(row['what'])}, {row['unit']}" if row["unit"] else escaped(row["what"]),
            number(row["value"]),
            range_of(row),
            f"**{row['verdict']}**" if row["verdict"] in ("below", "above", "unknown") else row["verdict"],
            escaped(row["source"] or ""),
        ]
        for row in preset["physiology"]
    ]
    parts += ["## Beside hearts", f"`coapt study physiology {name}`: {met_of(preset)} published ranges are met."]
    parts.append(table(["quantity", "value", "range", "verdict", "source"], rows))
    if (file := ROOT / f"examples/calibration/{name}.json").exists():
        parts.append(
            f"## As a file\n\nIts dimensions and disease, for `coapt valve make --dimensions`:\n\n```json\n{file.read_text().strip()}\n```"
        )
    return "\n\n".join(parts) + "\n"


def preset_pages(made):
    """Every page and picture by its place below reference/presets/. `made`: folder that run_presets.py wrote."""
    made = pathlib.Path(made)
    names, found, rows = json.loads((made / "presets.json").read_text()), {}, []
    for name in names:
        preset = json.loads((made / f"{name}.json").read_text(encoding="utf-8"))
        found[f"{name}.md"] = preset_page(preset)
        found[f"{name}.png"] = (made / f"{name}.png").read_bytes()
        annulus = f"{preset['valve']['saddle_to_mid_posterior_mm']:.1f} x {preset['valve']['commissures_mm']:.1f}"
        area = f"{preset['valve']['leaflet_area_mm2']:.0f}"
        rows.append([f"[{name}]({name}.md)", preset["title"], leak_of(preset), annulus, area, met_of(preset)])
    lines = "\n".join("| " + " | ".join(row) + " |" for row in rows)
    contents = "\n".join(names)
    found["index.md"] = f"{INTRODUCTION}{lines}\n\n```{{toctree}}\n:hidden:\n\n{contents}\n```\n"
    return found
