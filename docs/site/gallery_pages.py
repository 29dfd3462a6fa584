"""Pages of the gallery: the scripts of examples/gallery by group, each with its picture, its text and what it prints."""

import pathlib
import re

from pages import ROOT, escaped

GALLERY = ROOT / "examples/gallery"
LANGUAGES = {".py": "python", ".sh": "bash", ".cpp": "cpp"}
_FIRST = re.compile(r'"""(.*?)"""|(?://|#) ?([^\n]*)', re.DOTALL)
_GROUP = re.compile(r"^\| \[(\w+)\]\(\1\) \| (.+?) \|$", re.MULTILINE)


def groups():
    """Folders with what they show, in the order of the gallery's README."""
    return _GROUP.findall((GALLERY / "README.md").read_text(encoding="utf-8"))


def scripts(folder):
    return sorted(path for path in (GALLERY / folder).iterdir() if path.suffix in LANGUAGES)


def title(script):
    return script.stem.replace("_", " ").capitalize()


def sentence(script):
    """What it shows: its docstring, or its first comment."""
    first = _FIRST.match(script.read_text(encoding="utf-8"))
    if first is None:
        raise ValueError(f"{script}: begins with no sentence that says what it shows")
    return " ".join((first[1] or first[2]).split())


def gallery_pages(made):
    """Every page and picture by its place below gallery/. `made`: folder that run.py wrote."""
    made, found, parts = pathlib.Path(made), {}, [INTRODUCTION]
    for folder, shows in groups():
        parts.append(f"## {shows}\n\n::::{{container}} gallery\n")
        for script in scripts(folder):
            picture = picture_of(made, script)
            small = picture.with_name(f"{script.stem}-small.png")
            small = small if small.exists() else picture
            place = f"{folder}/{script.stem}"
            for file in {picture, small}:
                found[f"{folder}/{file.name}"] = file.read_bytes()
            found[f"{place}.md"] = _page(script, picture)
            parts.append(
                f":::{{container}} thumbnail\n[![{escaped(title(script))}]({folder}/{small.name})]({place}.md)\n\n"
                f"[{escaped(title(script))}]({place}.md)\n:::\n"
            )
        parts.append("::::\n")
    names = "\n".join(place.removesuffix(".md") for place in found if place.endswith(".md"))
    found["index.md"] = "\n".join(parts) + f"\n```{{toctree}}\n:hidden:\n\n{names}\n```\n"
    return found


def picture_of(made, script):
    for end in (".png", ".svg"):
        if (file := made / script.parent.name / (script.stem + end)).exists():
            return file
    raise FileNotFoundError(f"{script}: no picture in {made}: examples/gallery/run.py makes it")


INTRODUCTION = """# Gallery

Each picture is made by the short script beside it, which was run when this site was made: in Python, on the command line, by a
service, in C++. They lie in `examples/gallery`; `make gallery` runs them all.
"""


def _page(script, picture):
    printed = picture.with_suffix(".txt").read_text(encoding="utf-8").rstrip()
    parts = [
        f"# {title(script)}",
        escaped(sentence(script)),
        f"![{escaped(title(script))}]({picture.name})",
        f"`{script.relative_to(ROOT)}`",
        f"```{LANGUAGES[script.suffix]}\n{script.read_text(encoding='utf-8').rstrip()}\n```",
    ]
    if printed:
        parts.append(f"It prints:\n\n```text\n{printed}\n```")
    return "\n\n".join(parts) + "\n"
