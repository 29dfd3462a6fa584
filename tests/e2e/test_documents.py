"""Commands in the documents: each names a command and flags that are there, and those of coapt run."""

import itertools
import os
import pathlib
import re
import shutil
import subprocess
import unittest

from helps import commands, flags, help_of
from plan_runs import VALVE
from programs import COAPT, NO_COMPETENT_PLAN, NOT_CLOSED, OK, SOURCE, ProgramTest, small_valve

FENCE = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINE = re.compile(r"(?:\$ )?(?:\S*/)?(coapt(?:-[a-z]+)?) (?=\S)(.*)$")
DOCUMENTS = sorted([SOURCE / "README.md", *(SOURCE / "docs").rglob("*.md"), *(SOURCE / "examples").rglob("*.md")])

# Flags that make a documented command short here. What it has of them already gets these values.
SHORTER = {
    "plan": "--evaluations 12 --plans 1 --region-points 2 --fine-levels 0 --model-draws 0 --no-evidence",
    "evaluate": "--region-points 2 --no-evidence",
    "valve make": "--triangles 200",
}
# Commands that are not run here, by a part of them, with the reason.
NOT_RUN = {
    "coapt-": "is another program: e2e.server, e2e.live, e2e.farm_studies, lab",
    "--farm": "needs a farm: e2e.farm_studies",
    "--server": "needs a service: e2e.through_service",
    "coapt study": "takes minutes: e2e.study and e2e.population run them shortened",
    "coapt valve calibrate": "takes minutes: e2e.valve runs it shortened",
    "coapt fit": "takes a minute: e2e.fit",
    "coapt population": "takes a minute: e2e.population",
    "coapt design": "takes minutes: e2e.design",
    "coapt train": "takes a minute: e2e.train",
    "--ring": "needs a ring that was designed: e2e.design",
    "|": "is several commands in one line",
    "leaflets.nrrd": "is a segmentation of the reader's: e2e.label_map imports one",
    "segmentation.seg.nrrd": "is a segmentation of the reader's: e2e.label_map imports one",
    "map.seg.nrrd": "is made by a script before: e2e.label_map_plan runs these lines",
    "FEM-model/": "is a folder of SlicerHeart's: e2e.valve imports one",
    ".inp": "is a model of Abaqus of 20 MB",
    "trivalve.json": "is made of it",
    "--converge": "takes half a minute: e2e.close runs it on a small valve",
    "--accuracy": "takes half a minute: e2e.close runs it on a small valve",
    "trials.csv": "is a learner's answers: e2e.train scores some",
    "--answers": "is an expert's answers: e2e.prefer learns from some",
    "weights.json": "is what was learned from them: e2e.prefer",
    "> ": "is a case for an expert, of 20 plans: e2e.prefer",
    "a.stl": "is a segmentation of the reader's: e2e.valve imports some",
    "frame_19.vtu": "is another code's result: e2e.compare reads such files",
}
# What documents take for given, by name: a preset, a preset's closed leaflets, or a file of examples/.
GIVEN_VALVES = {"valve.json": VALVE} | {f"{name}.json": "human-normal" for name in "abc"}
GIVEN_SHAPES = ("segmented.stl", "closed.vtk", "fine.ply")
SHEETS = "valves/source/bodyparts3d"
GIVEN_FILES = {
    **{name: "plans/ring.json" for name in ("ring.json", "ring30.json", "mine.json")},
    "yours.json": "plans/own-ring.json",
    "a.obj": f"{SHEETS}/anterior_leaflet_sheet.obj",
    "p.obj": f"{SHEETS}/posterior_leaflet_sheet.obj",
    "ring.csv": f"{SHEETS}/annulus_centerline.csv",
    "chordae.csv": f"{SHEETS}/chordae.csv",
}


def command_lines(*more):
    """Document, program and words of each; of tutorials (`console`), which make tutorials-check follows, on request."""
    for document in DOCUMENTS:
        for language, block in FENCE.findall(document.read_text(encoding="utf-8")):
            for line in block.splitlines() if language in ("", "sh", "bash", *more) else ():
                if language == "console" and not line.startswith("$ "):
                    continue
                if found := LINE.match(line):
                    yield document.relative_to(SOURCE), found[1], found[2].split(" # ")[0].split("  #")[0].rstrip(" &")


class Documents(ProgramTest):
    def test_every_command_and_flag_in_them_is_there(self):
        known = {}
        for program in ("coapt", "coapt-farm", "coapt-server", "coapt-live", "coapt-lab"):
            binary = pathlib.Path(COAPT).with_name(program)
            if binary.exists():
                for words, text in commands(binary):
                    known[" ".join([program, *words[1:]])] = flags(text)
                known.setdefault(program, set()).update(flags(help_of(binary)))
        wrong, seen = [], 0
        for document, program, line in command_lines("console"):
            names = [name for name in known if f"{program} {line} ".startswith(f"{name} ")]
            if program not in known or "|" in line.split(" ")[-1] or re.search(r"[a-z]\|[a-z]", line):
                continue
            seen += 1
            for flag in re.findall(r"(?<=\s)--?[a-z][\w-]*", f" {line}"):
                if flag not in known[max(names, key=len)]:
                    wrong.append(f"{document}: {program} {line}: {flag}")
        self.assertEqual(wrong, [])
        self.assertGreater(seen, 60)

    def shortened(self, line):
        """The command with flags that make it short."""
        command = next((one for one in SHORTER if f"{line} ".startswith(f"{one} ")), None)
        if command is None:
            return line
        for flag, value in re.findall(r"(--?[a-z-]+)(?: (\d+))?", SHORTER[command]):
            line = re.sub(rf" {flag} \d+", "", line) + f" {flag} {value}".rstrip()
        return line

    def test_commands_of_coapt_run(self):
        given = self.folder / "given"
        given.mkdir()
        for name, preset in GIVEN_VALVES.items():
            shutil.copy(small_valve(preset), given / name)
        for name in GIVEN_SHAPES:
            self.run_ok("close", VALVE, "--closed", given / name)
        for name, example in GIVEN_FILES.items():
            (given / name).write_bytes((SOURCE / "examples" / example).read_bytes())
        shutil.copytree(given, given / "patients", ignore=lambda _, names: set(names) - {"a.json", "b.json"})
        (given / "examples").symlink_to(SOURCE / "examples")
        paths = {"PATH": f"{pathlib.Path(COAPT).parent}:{os.environ['PATH']}"}
        failed, ran, known = [], 0, set()
        for document, lines in itertools.groupby(command_lines(), lambda one: one[0]):
            folder = self.folder / str(document).replace("/", "-")
            shutil.copytree(given, folder, symlinks=True)
            for _, program, line in lines:
                if any(part in f"{program} {line}" for part in NOT_RUN):
                    continue
                command = f"{program} {self.shortened(line)}"
                words = re.sub(r" -o \S+", "", command).split()
                read = [file.read_bytes() for word in words if (file := folder / word).is_file()]
                ran += 1
                if (command, *read) in known:  # from another document
                    continue
                known.add((command, *read))
                run = subprocess.run(
                    command, shell=True, cwd=folder, env=os.environ | paths, capture_output=True, text=True
                )
                if run.returncode not in (OK, NOT_CLOSED, NO_COMPETENT_PLAN):
                    failed.append(f"{document}: {command}: {run.returncode}: {run.stderr}")
        self.assertEqual(failed, [])
        self.assertGreater(ran, 25)


if __name__ == "__main__":
    unittest.main()
