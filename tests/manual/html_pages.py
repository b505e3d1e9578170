#!/usr/bin/env python3
"""html_pages.py -- checks the manual in HTML, as `make -C docs html` leaves it. Prints TAP.

    html_pages.py FOLDER

Links and anchors lead somewhere inside the folder; nothing that a page loads comes from a network; the
search index knows words and where they stand; each declaration of a public header has an anchor; KaTeX
reads every formula (needs node).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json
import os
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT/"tests"))
from tap import claim, finish, skip        # noqa: E402

KATEX = "/usr/share/javascript/katex/katex.min.js"
LOADED = {"script": "src", "img": "src", "link": "href"}


class Page(HTMLParser):
    """ids, links, what it loads, and formulas of a page."""

    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.loaded, self.formulas = set(), [], [], []
        self.formula = None
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        own = dict(attributes)
        self.ids.add(own.get("id"))
        if tag in LOADED and own.get(LOADED[tag]) and own.get("rel") not in ("index", "search", "next", "prev", "canonical"):
            self.loaded.append(own[LOADED[tag]])
        elif tag == "a" and own.get("href"):
            self.links.append(own["href"])
        if own.get("class") == "math":
            self.formula = tag
            self.formulas.append("")

    def handle_endtag(self, tag):
        if tag == self.formula:
            self.formula = None

    def handle_data(self, data):
        if self.formula:
            self.formulas[-1] += data


def dead(pages, path, target):
    """Does a link of a page lead nowhere?"""
    parts = urlsplit(target)
    if parts.scheme or parts.netloc:
        return False
    file = Path(os.path.normpath(path.parent/unquote(parts.path))) if parts.path else path
    if file.suffix != ".html":
        return not file.exists()
    return file not in pages or bool(parts.fragment) and unquote(parts.fragment) not in pages[file].ids


def pages_with(index, stem):
    """Names of the pages in which the search finds a word of this stem."""
    # older Sphinx writes names without quotation marks
    own = json.loads(re.sub(r"([{,])(\w+):", r'\1"\2":', index[index.index("{"):index.rindex("}") + 1]))
    places = [own[kind].get(stem, []) for kind in ("terms", "titleterms")]
    return {own["docnames"][k] for found in places for k in ([found] if isinstance(found, int) else found)}


def check_formulas(formulas):
    what = "KaTeX reads all %d formulas" % len(formulas)
    if not shutil.which("node"):
        skip(what, "no node")
        return
    script = """const katex = require(%s);
for (const text of JSON.parse(require("fs").readFileSync(0)))
    try { katex.renderToString(text); } catch (error) { console.log(text + ": " + error.message); }""" % json.dumps(KATEX)

    def faults(texts):
        return subprocess.run(["node", "-e", script], input=json.dumps(texts), stdout=subprocess.PIPE,
                              universal_newlines=True, check=True).stdout.splitlines()
    claim(what, not faults(formulas), faults(formulas))
    claim("a formula with a mistake is noticed", len(faults([r"\frac{1}", r"a"])) == 1)


def main():
    folder = Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    wrong = ["%s: %s" % (path.relative_to(folder), target) for path, page in pages.items()
             for target in page.links + page.loaded if dead(pages, path, target)]
    claim("%d pages: links and anchors lead somewhere" % len(pages), len(pages) > 60 and not wrong, wrong)
    claim("a link to a missing page or anchor is noticed",
          dead(pages, folder/"index.html", "docs/zebra.html") and dead(pages, folder/"docs/heat.html", "#zebra"))
    wrong = ["%s: %s" % (path.relative_to(folder), target) for path, page in pages.items()
             for target in page.loaded if urlsplit(target).netloc]
    claim("pages load nothing from a network", not wrong, wrong)

    index = (folder/"searchindex.js").read_text(encoding="utf-8")
    found = pages_with(index, "restitut")
    claim("the search finds restitution in %d pages" % len(found),
          {"docs/theory-contact", "docs/effects", "tutorials/rebound/README"} <= found and
          "docs/kernels" not in found, sorted(found))
    for header in sorted((ROOT/"dem"/"include").glob("*.h")):
        calls = set(re.findall(r"^\w[\w *]*?\b(dem_\w+)\(", header.read_text(), re.M))
        text = (folder/"dem"/"include"/(header.stem + ".html")).read_text(encoding="utf-8")
        lack = sorted(name for name in calls if name not in text)
        claim("%s: its %d calls are on its page" % (header.name, len(calls)), not lack, lack)
    check_formulas([text for page in pages.values() for text in page.formulas])
    finish()


if __name__ == "__main__":
    main()
