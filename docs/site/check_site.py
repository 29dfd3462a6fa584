#!/usr/bin/python3
"""Fails if a link of the built site leads nowhere, if a page loads anything from elsewhere, or does not say what coapt is
not.

Usage: docs/site/check_site.py SITE
"""

import html.parser
import pathlib
import sys
import urllib.parse

from pages import NOTICE

LOADS = {("img", "src"), ("script", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("video", "src")}
# Words that lead a browser, but load nothing.
ELSEWHERE = {"canonical", "author", "license"}


class Page(html.parser.HTMLParser):
    """links: each with whether it is loaded; anchors; text."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors, self.text = [], set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        named = dict(attributes)
        self.anchors.update(named[name] for name in ("id", "name") if named.get(name))
        for name in ("href", "src"):
            if named.get(name) and named.get("rel") not in ELSEWHERE:
                self.links.append((named[name], (tag, name) in LOADS))

    def handle_data(self, data):
        self.text.append(data)


def problem(site, pages, path, link, loaded):
    address = urllib.parse.urlsplit(link)
    if address.scheme in ("http", "https") or address.netloc:
        return "is loaded from elsewhere" if loaded else None
    if address.scheme in ("data", "mailto"):
        return None
    if address.scheme or address.path.startswith("/"):
        return "does not lead into the site"
    target = path if not address.path else (path.parent / urllib.parse.unquote(address.path)).resolve()
    if not target.is_relative_to(site) or not target.is_file():
        return "no such file"
    anchor = urllib.parse.unquote(address.fragment)
    if anchor and target in pages and anchor not in pages[target].anchors:
        return "no such place on the page"
    return None


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    wrong = [] if site / "index.html" in pages else ["index.html: there is none"]
    for path, page in pages.items():
        name = path.relative_to(site)
        if NOTICE not in " ".join("".join(page.text).split()):
            wrong.append(f"{name}: does not say: {NOTICE}")
        for link, loaded in page.links:
            if reason := problem(site, pages, path, link, loaded):
                wrong.append(f"{name}: {link}: {reason}")
    links = sum(len(page.links) for page in pages.values())
    print("\n".join(wrong or [f"{len(pages)} pages, {links} links"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
