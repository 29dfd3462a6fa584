"""The C++ headers of core and search as pages, from Doxygen's XML: each reads like the header, from top to bottom."""

import re
import xml.etree.ElementTree as xml

from pages import ROOT, anchor, escaped, relative

# Two hundred headers would fill the contents of every page: their folder's page lists them.
_ALONE = "---\norphan: true\n---"
_FOLDER = re.compile(r"^(core|search)/")


def header_pages(folder):
    """Name and text of each page."""
    compounds = {}
    for entry in xml.parse(folder / "index.xml").getroot().iter("compound"):
        if entry.get("kind") in ("file", "namespace", "struct", "class"):
            compounds[entry.get("refid")] = xml.parse(folder / f"{entry.get('refid')}.xml").getroot()[0]
    homes, members = {}, {}
    for refid, compound in compounds.items():
        place = compound.find("location").get("file")
        if compound.get("kind") == "namespace":
            for member in filter(_public, compound.iter("memberdef")):
                members.setdefault(member.find("location").get("file"), []).append(member)
        elif compound.get("kind") != "file" and _FOLDER.match(place):
            homes[refid] = (place.removesuffix(".h") + ".md", anchor(_name(compound)))
    files = {one.find("location").get("file"): one for one in compounds.values() if one.get("kind") == "file"}
    files = {place: files[place] for place in sorted(files) if place.endswith(".h") and _FOLDER.match(place)}
    pages = {}
    for place, compound in files.items():
        page = _Page(place.removesuffix(".h") + ".md", homes)
        inner = [compounds[one.get("refid")] for one in compound.iter("innerclass") if one.get("refid") in compounds]
        pages[page.name] = page.text(place, [*inner, *members.get(place, [])])
    return pages | _lists(files)


def _lists(files):
    """A page for each folder, and one of all."""
    folders = {}
    for place in files:
        folders.setdefault(place.rpartition("/")[0], []).append(place)
    pages = {}
    for folder, places in folders.items():
        names = [place.rpartition("/")[2].removesuffix(".h") for place in places]
        entries = "\n".join(f"- [{name}.h]({name}.md): {_first_sentence(place)}" for name, place in zip(names, places))
        pages[f"{folder}/index.md"] = f"# {folder}\n\n{entries}\n"
    entries = "\n".join(f"- [{folder}]({folder}/index.md)" for folder in folders)
    words = (
        "Headers of the static library `libcoapt`, made by Doxygen and laid out as the headers are."
        " [The C++ library](../../engineer/library.md) says how a program is linked with it and which headers to begin with."
    )
    listed = "\n".join(f"{folder}/index" for folder in folders)
    pages["index.md"] = f"# C++ headers\n\n{words}\n\n{entries}\n\n```{{toctree}}\n:hidden:\n\n{listed}\n```\n"
    return pages


def _opening(place):
    """The comment that a header begins with, as paragraphs."""
    text = (ROOT / place).read_text(encoding="utf-8")
    lines = re.match(r"(?://.*\n)*", text).group().splitlines()
    return re.split(r"\n\s*\n", "\n".join(line.removeprefix("//").removeprefix(" ") for line in lines))


def _first_sentence(place):
    words = " ".join(_opening(place)[0].split())
    return escaped(re.split(r"(?<=[.:;]) ", words)[0].rstrip(":;"))


def _name(compound):
    return compound.findtext("compoundname").removeprefix("coapt::")


class _Page:
    def __init__(self, name, homes):
        self.name, self._homes, self._last = name, homes, ""

    def text(self, place, things):
        folder = place.rpartition("/")[0]
        parts = [_ALONE, f"[{folder}](index.md)", f"# {place}", *map(escaped, _opening(place))]
        parts.append(f'```cpp\n#include "{place}"\n```')
        for one in sorted(things, key=_line):
            parts += self._class(one) if one.tag == "compounddef" else self._member(one)
        return "\n\n".join(part for part in parts if part) + "\n"

    def _class(self, compound):
        name = _name(compound)
        parts = [
            f"## {escaped(name)}",
            f"```cpp\n{_template(compound)}{compound.get('kind')} {name}\n```",
            *self._said(compound),
        ]
        entries = [self._entry(_declaration(one), one) for one in compound.iter("memberdef") if _public(one)]
        return [*parts, "\n".join(entries)]

    def _member(self, member):
        """A function, an alias or a constant; overloads stand below one heading."""
        name = member.findtext("name")
        parts = [] if name == self._last else [f"## {escaped(name)}"]
        self._last = name
        if member.get("kind") == "enum":
            parts += [f"```cpp\nenum class {name}\n```", *self._said(member)]
            return [*parts, "\n".join(self._entry(one.findtext("name"), one) for one in member.iter("enumvalue"))]
        return [*parts, f"```cpp\n{_declaration(member)};\n```", *self._said(member)]

    def _entry(self, term, thing):
        """Of a list: a member, and what is said of it."""
        said = " ".join(self._said(thing)).replace("\n", " ")
        return f"- `{term}`" + (f": {said}" if said else "")

    def _said(self, thing):
        """Paragraphs of its comments."""
        texts = [
            self._inline(one).strip() for one in [thing.find("briefdescription"), thing.find("detaileddescription")]
        ]
        return [text for text in texts if text]

    def _inline(self, node):
        """What Doxygen makes of a comment."""
        pieces = [escaped(node.text or "")]
        for child in node:
            inside = self._inline(child).strip()
            if child.tag == "computeroutput":
                inside = f"`{''.join(child.itertext())}`"
            elif child.tag == "ref" and child.get("refid") in self._homes:
                page, heading = self._homes[child.get("refid")]
                inside = f"[{inside}]({relative(page, self.name)}#{heading})"
            elif child.tag in ("para", "itemizedlist", "simplesect", "parameterlist"):
                inside = f"{_LEADS.get(child.get('kind'), '')}{inside}\n\n"
            elif child.tag == "listitem":
                inside = f"- {inside}\n"
            elif child.tag == "parameteritem":
                names = ", ".join(f"`{one.text}`" for one in child.iter("parametername"))
                inside = f"{names}: {self._inline(child.find('parameterdescription')).strip()}\n\n"
            pieces += [inside, escaped(child.tail or "")]
        return "".join(pieces)


_LEADS = {"pre": "Before: ", "return": "Returns ", "post": "After: ", "note": "Note: "}


def _public(member):
    kept = member.get("prot") == "public" and member.get("kind") in ("function", "variable", "enum", "typedef")
    return kept and not member.findtext("name", "").startswith(("operator", "@"))


def _line(thing):
    return int(thing.find("location").get("line"))


def _template(thing):
    """template <...>, empty for what is none."""
    parameters = thing.find("templateparamlist")
    if parameters is None:
        return ""
    words = [" ".join(filter(None, (one.findtext("type"), one.findtext("declname")))) for one in parameters]
    return f"template <{', '.join(words)}>\n"


def _declaration(member):
    kind = "".join(member.find("type").itertext()) if member.find("type") is not None else ""
    words = [kind, member.findtext("name") + (member.findtext("argsstring") or "")]
    if member.get("kind") == "typedef":
        text = (
            f"using {member.findtext('name')} = {kind}"
            if "using" in member.findtext("definition", "")
            else " ".join(words)
        )
    else:
        start = member.find("initializer")
        text = " ".join(filter(None, words)) + (
            "" if start is None else " " + " ".join("".join(start.itertext()).split())
        )
    text = re.sub(r"\s*([&*])(?=\w)", r"\1 ", text).replace("coapt::", "").replace(" {}", "{}")
    text = re.sub(r"(?<=\w)=(?=\w|\{)", " = ", text)
    return _template(member) + re.sub(r"(?<=[(<]) | (?=[>)])", "", text).replace("  ", " ")
