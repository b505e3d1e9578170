"""conf.py -- Sphinx makes the manual in HTML of the repository's Markdown pages and public headers.

The top folder is the source: docs/, the READMEs and results of the tutorials and of the folders of the
code, and dem/include/*.h, which header.py turns into pages. The pages stay as GitHub shows them; what
Sphinx needs besides is added while it reads:

    contents     from the links of docs/README.md and of the index pages below it
    links        to files that are no pages: the file is copied; to folders: only the text
    formulas     $...$ and blocks ```math, by KaTeX in the browser, from a copy of Debian's libjs-katex
    index.html   leads to docs/README.html

SPDX-License-Identifier: GPL-3.0-or-later
"""
import posixpath
import re
import shutil
import sys
from html import escape
from pathlib import Path

from docutils.nodes import SkipNode
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.errors import ExtensionError

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))
from header import HeaderParser     # noqa: E402

KATEX = Path("/usr/share/javascript/katex")
PAGE = (".md", ".h")

project = "Suna"
author = copyright = "the authors of Suna"
version = release = re.search(r'DEM_VERSION "(.*)"', (ROOT/"dem/include/dem.h").read_text()).group(1)
extensions = ["myst_parser"]
root_doc = "docs/README"
include_patterns = ["*.md", "docs/*.md", "tutorials/README.md", "tutorials/*/*.md", "**/README.md", "dem/include/*.h"]
exclude_patterns = ["**/build", "debian", "**/runs", "**/lnInclude"]
source_suffix = {".md": "markdown", ".h": "header"}
myst_enable_extensions = ["dollarmath"]
myst_dmath_double_inline = True
myst_heading_anchors = 4
highlight_language = "none"
# a generated block may begin below its page's level; OpenFOAM's Make/files are not quite make's
suppress_warnings = ["myst.header", "misc.highlighting_failure"]

html_theme = "furo"
html_title = f"Suna {version}"
html_static_path = ["static"]
html_css_files = ["katex/katex.min.css", "suna.css"]
html_js_files = ["katex/katex.min.js", "formulas.js"]
html_math_renderer = "katex"
html_copy_source = False
html_show_sphinx = False

# pages whose links are their part of the contents
INDEX = ("docs/README", "tutorials/README")
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)#\s]+)(#[^)\s]*)?\)")


def page_of(docname, target, env):
    """The page to which a relative link leads, or None."""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(docname), target))
    name = posixpath.splitext(path)[0]
    return name if path.endswith(PAGE) and name in env.found_docs else None


def title(page):
    """The first heading of a page."""
    return re.search(r"^# (.+)$", (ROOT/(page + ".md")).read_text(encoding="utf-8"), re.M).group(1)


def toctree(caption, pages):
    lines = ["", "```{toctree}", ":hidden:", ":maxdepth: 1"] + ([f":caption: {caption}"] if caption else [])
    return "\n".join([*lines, "", *("/" + page for page in pages), "```", ""])


def contents(docname, text, env, taken):
    """A toctree for each heading of an index page; the same page stands in one only."""
    parts = re.split(r"^## (.+)$", text, flags=re.M)
    found = ""
    for caption, part in zip(parts[1::2], parts[2::2]):
        pages = []
        for _, target, _ in LINK.findall(part):
            page = page_of(docname, target, env)
            if page and page != docname and page not in taken:
                taken.add(page)
                pages.append(page)
        if pages:
            found += toctree(caption if docname == root_doc else "", pages)
    return found


def children(docname, env):
    """What belongs below a page that is no index: the results of a tutorial, the public headers."""
    folder = posixpath.dirname(docname)
    if docname == "docs/library":
        return sorted(name for name in env.found_docs if name.startswith("dem/include/"))
    if re.fullmatch(r"tutorials/\w+/README", docname) and folder + "/results" in env.found_docs:
        return [folder + "/results"]
    return []


def read(app, docname, source):
    """Add contents; make links to folders plain text."""
    text, env = source[0], app.env
    if docname.startswith("dem/include/") and not docname.endswith("README"):
        return
    folder = ROOT/posixpath.dirname(docname)

    def link(match):
        words, target, anchor = match.groups()
        page = page_of(docname, target, env)
        if page and words == posixpath.basename(target):            # its title says more
            return f"[{title(page)}]({target}{anchor or ''})"
        if ":" in target or page:
            return match.group(0)
        if target.endswith(".h") and (folder/target).is_file():     # to Sphinx the name of a page
            return "{download}`%s <%s>`" % (words.replace("`", ""), target)
        if not (folder/target).is_dir():
            return match.group(0)
        page = page_of(docname, target.rstrip("/") + "/README.md", env)
        return f"[{words}]({target.rstrip('/')}/README.md)" if page else words
    text = LINK.sub(link, text)
    text = re.sub(r"^```math\n(.*?)^```$", r"$$\n\1$$", text, flags=re.M | re.S)
    if docname in INDEX or docname == "docs/library":       # their contents change with other files
        env.note_reread()
    if docname in INDEX:
        text += contents(docname, text, env, {root_doc, *(INDEX if docname != root_doc else ())})
    elif children(docname, env):
        text += toctree("", children(docname, env))
    source[0] = text


def orphan(app, doctree):
    """Pages that no contents name are reached by links and by the search."""
    app.env.metadata[app.env.docname].setdefault("orphan", True)


def formula(self, node):
    self.body.append(f'<span class="math">{escape(node.astext())}</span>')
    raise SkipNode


def displayed(self, node):
    self.body.append(f'<div class="math">{escape(node.astext())}</div>')
    raise SkipNode


def finish(app, failed):
    if failed or app.builder.name != "html":
        return
    shutil.copytree(KATEX, Path(app.outdir, "_static/katex"), dirs_exist_ok=True, ignore=shutil.ignore_patterns(
        "contrib", "katex.js", "katex.css", "*.mjs"))
    start = root_doc + ".html"
    Path(app.outdir, "index.html").write_text(
        f'<!DOCTYPE html><meta charset="utf-8"><title>Suna</title><meta http-equiv="refresh" content="0; url={start}">'
        f'<a href="{start}">Suna</a>\n')


def setup(app):
    if "image/webp" not in StandaloneHTMLBuilder.supported_image_types:
        StandaloneHTMLBuilder.supported_image_types.append("image/webp")
    if not KATEX.is_dir():
        raise ExtensionError(f"no {KATEX} for the formulas; install Debian's libjs-katex")
    app.add_source_parser(HeaderParser)
    app.add_html_math_renderer("katex", (formula, None), (displayed, None))
    app.connect("source-read", read)
    app.connect("doctree-read", orphan)
    app.connect("build-finished", finish)
