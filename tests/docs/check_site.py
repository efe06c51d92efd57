#!/usr/bin/python3
"""Checks a site: targets of links and pictures exist, and pages load nothing from other sites, and no JavaScript
modules, which browsers do not load from files:  check_site.py SITE"""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADS = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src")}


class Page(HTMLParser):
    """Returns anchors of a page, its links, and the files that it loads."""

    def __init__(self, path):
        super().__init__()
        self.places, self.links, self.loaded = {""}, [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.places.add(value)
            if value and (tag, name) in LOADS:
                self.loaded.append(value)
            elif value and (tag, name) == ("a", "href"):
                self.links.append(value)


def problems(site, pages):
    for path, page in pages.items():
        for target in page.links + page.loaded:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                if target in page.loaded and parts.scheme != "data":
                    yield f"{path.relative_to(site)} loads {target}"
                continue
            there = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not there.is_file():
                yield f"{path.relative_to(site)}: no file {target}"
            elif there in pages and unquote(parts.fragment) not in pages[there].places:
                yield f"{path.relative_to(site)}: no place {target}"


def problems_of_parts(site):
    """Returns files that style sheets and scripts load in turn."""
    for path in site.glob("_static/**/*.css"):
        for target in re.findall(r"url\(['\"]?(?!data:)([^'\")]+)", path.read_text(encoding="utf-8")):
            if urlsplit(target).netloc or target.startswith("/") or not (path.parent / target).is_file():
                yield f"{path.relative_to(site)}: no file {target}"
    for path in [*site.glob("_static/*.js"), *site.glob("_static/scripts/*.js")]:
        if re.search(r"^(import|export) ", path.read_text(encoding="utf-8"), re.MULTILINE):
            yield f"{path.relative_to(site)} is a module"


def problems_of_search(site):
    """Checks that the search fetches nothing, which browsers forbid for pages on disk: its index is a script."""
    if "searchindex.js" not in Page(site / "search.html").loaded or not (site / "searchindex.js").is_file():
        yield "search.html does not load its index as a script"
    options = site / "_static/documentation_options.js"
    if "SHOW_SEARCH_SUMMARY: false" not in options.read_text(encoding="utf-8"):
        yield "search.html fetches the pages that it finds for summaries"


def main():
    site = Path(sys.argv[1]).resolve()
    # Explorers have other tests.
    pages = {path: Page(path) for path in site.rglob("*.html") if "_downloads" not in path.parts}
    found = sorted({*problems(site, pages), *problems_of_parts(site), *problems_of_search(site)})
    print("\n".join(found))
    print(f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, {len(found)} problems")
    return 1 if found or len(pages) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
