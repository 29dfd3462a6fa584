"""Where a file of the repository stands in the site, and how a page's links are led there.

Markdown stays where it is read on a code host; the site's sources are copies whose links point at pages, pictures and
downloads of the site.
"""

import os
import pathlib
import re
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
NOTICE = "Research software, not a medical device; not for clinical decisions."

_PLACES = {
    "README.md": "overview.md",
    "docs/README.md": "documents.md",
    "docs/ROADMAP.md": "project/roadmap.md",
    "ARCHITECTURE.md": "project/architecture.md",
    "CHANGELOG.md": "project/changelog.md",
    "CONTRIBUTING.md": "project/contributing.md",
    "SECURITY.md": "project/security.md",
    "SUPPORT.md": "project/support.md",
    "docs/migration.md": "project/migration.md",
    "docs/site/index.md": "index.md",
    "docs/site/notebooks.md": "notebooks/index.md",
    "docs/man": "reference/commands/index.md",
    "clients/python/notebooks": "notebooks/index.md",
    "examples/gallery": "gallery/index.md",
    "core": "reference/cpp/index.md",
    "core/presets": "reference/presets/index.md",
    "server/openapi.json": "reference/rest/index.md",
}
_KINDS = (
    ("docs/man/", ".1.scd", "reference/commands/", ".md"),
    ("docs/site/python/", ".rst", "reference/python/", ".rst"),
    ("clients/python/notebooks/", ".ipynb", "notebooks/", ".md"),
)
_FENCE = re.compile(r"^\s*```.*?^\s*```\s*$", re.MULTILINE | re.DOTALL)
_COMMANDS = re.compile(r"```(\n(?:\$ )?(?:\S*/)?(?:coapt|make|cmake|curl|sudo|psql|head|examples/)\S* )")
_LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")


def place(path):
    """The site's page or file for one of the repository, by its path from the root; None: the site has none."""
    if path in _PLACES:
        return _PLACES[path]
    folder, _, name = path.partition("/")
    if folder in ("core", "search") and path.endswith(".h"):
        return f"reference/cpp/{path.removesuffix('.h')}.md"
    for beginning, end, there, new_end in _KINDS:
        if path.startswith(beginning) and path.endswith(end):
            return there + path.removeprefix(beginning).removesuffix(end) + new_end
    if not (ROOT / path).is_file():
        return None
    return name if folder == "docs" else path


class Gathering:
    """Copies documents and what they refer to into the folder of the site's sources. Files that are as they were keep their
    time, so that Sphinx reads only what has changed."""

    def __init__(self, target):
        self.target, self.kept, self._waiting = pathlib.Path(target), set(), []

    def write(self, place, content):
        file = self.target / place
        self.kept.add(file)
        content = content.encode() if isinstance(content, str) else content
        if not file.exists() or file.read_bytes() != content:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(content)

    def documents(self, paths):
        """These, and Markdown that they link to, which no list of contents has."""
        listed = set(paths)
        self._waiting = list(paths)
        done = set()
        while self._waiting:
            path = self._waiting.pop()
            if path not in done:
                done.add(path)
                text = self.linked((ROOT / path).read_text(encoding="utf-8"), path)
                self.write(place(path), text if path in listed else f"---\norphan: true\n---\n\n{text}")

    def linked(self, text, path):
        """Markdown of a file of the repository, its links led to their places in the site."""
        pieces, end = [], 0
        for fence in _FENCE.finditer(text):
            code = _COMMANDS.sub(r"```bash\1", fence.group(), count=1)
            pieces += [self._links(text[end : fence.start()], path), code]
            end = fence.end()
        return "".join([*pieces, self._links(text[end:], path)])

    def _links(self, text, path):
        def led(link):
            mark, words, target = link.groups()
            words = _LINK.sub(led, words)
            if re.match(r"[a-z]+:|#", target):
                return f"{mark}[{words}]({target})"
            file, hash, anchor = target.partition("#")
            origin = os.path.normpath(os.path.join(os.path.dirname(path), urllib.parse.unquote(file)))
            there = place(origin)
            if there is None:
                return words  # a folder of sources
            self._take(origin, there)
            return f"{mark}[{words}]({relative(there, place(path))}{hash}{anchor})"

        return _LINK.sub(led, text)

    def _take(self, origin, there):
        if origin.endswith(".md"):
            self._waiting.append(origin)
        elif not there.endswith((".md", ".rst")):
            self.write(there, (ROOT / origin).read_bytes())

    def finish(self):
        """Removes what an earlier gathering left."""
        for file in sorted(self.target.rglob("*"), reverse=True):
            if file.is_file() and file not in self.kept:
                file.unlink()
            elif file.is_dir() and not any(file.iterdir()):
                file.rmdir()


def relative(there, here):
    return os.path.relpath(there, os.path.dirname(here) or ".")


def escaped(text):
    """Plain text as Markdown."""
    return re.sub(r"([\\`*_\[\]<>|#])", r"\\\1", text)


def anchor(heading):
    """As GitHub and MyST make it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
