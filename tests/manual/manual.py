#!/usr/bin/env python3
"""manual.py -- run the code blocks of the manual: docs/*.md, README.md, READMEs of the tutorials. TAP.

    manual.py WORK [PAGE ...]        in a sourced environment; WORK is a folder for what runs write

A comment directly before a block says how it is run; FOLDER is below the page's own folder in WORK,
where the names of the repository's folders lead to the repository, and drop.dem is the scene of docs/first-scene.md. $ROOT is the repository.

    <!-- run: FOLDER -->                    the shell commands run there, in the order of the page
    <!-- run: FOLDER; after: COMMAND -->    after a command that makes them short
    <!-- run: FOLDER; prints: TEXT -->      their output must contain this text
    <!-- save: FILE; after: COMMAND -->     the block becomes this file, after a command or none
    <!-- scene: ENTRIES -->                 scene; these entries are added
    <!-- case: ENTRIES -->                  demProperties of the bed of docs/first-bed.md, likewise
    <!-- controlDict -->                    added to system/controlDict of that bed
    <!-- text: WHY -->                      neither run nor looked up
    <!-- excerpt: FILE -->                  a part of this file of the repository
    <!-- dem effects -->, <!-- test: ... -->     compared by another suite

Without a comment a block is recognised:

    scene       entries of a scene only. What lacks comes from BASE; dem plan and a short dem run
    case        the same with entries of a coupled case: demPimpleFoam -plan in the bed
    commands    each program exists, and each option is in its -help or in its text
    printed     fenced: of each line, three words in a row (twice two) are in a message of the
                sources
    formula     indented, or fenced as math: not looked up; html_pages.py reads math

SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

import blocks

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(ROOT, "tests"))
from tap import claim, finish        # noqa: E402

LIMIT = 100                                                # s, of a block
SCENE = """materials effects pairs walls domain insert start outlets forces bonds fluid time
           neighbours averages write groups""".split()
CASE = ["coupling"]
BASE = {
    "materials": "materials { glass { density 2500; youngsModulus 1e7; } }",
    "effects": "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.9; } "
               "mindlin { friction 0.3; } }",
    "insert": "insert { grains { type lattice; count 100; diameter 1e-3; min (0 0 0); "
              "max (0.01 0.01 0.05); } }",
    "walls": "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }",
    "time": "time { end 0.001; }",
    "write": "write { interval 0.001; vtk no; }",
}
# programs that are not ours: their options are not looked up
SYSTEM = """apt-get awk blockMesh cat cd chrt cp curl decomposePar export git ln mkdir mpicc mpirun mv
            pimpleFoam python3 reconstructPar rm sed source taskset touch . sudo""".split()


class Wrong(Exception):
    """what is wrong with a block"""


def entries(text):
    """The entries of a dictionary at its top level, {word: text}; None if it is no dictionary."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.S)
    found, at = {}, 0
    while text[at:].strip():
        word = re.compile(r"\s*(\w+)\s*\{").match(text, at)
        if not word:
            return None
        depth, end = 1, word.end()
        while depth and end < len(text):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
        if depth:
            return None
        found[word.group(1)] = found.get(word.group(1), "") + text[at:end].strip() + "\n"
        at = end
    return found or None


class Messages:
    """Do the sources contain these words?"""

    def __init__(self):
        text = ""
        for folder in ("dem", "coupling", "solvers", "python", "tests", "tutorials"):
            for path, names, files in os.walk(os.path.join(ROOT, folder)):
                names[:] = [n for n in names if n not in ("build", "lnInclude", "stored", "beds", "manual")]
                for name in files:
                    if re.search(r"\.([cCHh]|py|sh)$|^(All)?run$|^demProgress$|^study$", name):
                        own = open(os.path.join(path, name), encoding="utf-8",
                                   errors="replace").read()
                        if name.endswith((".c", ".C", ".h", ".H")):            # literals, joined
                            own = re.sub(r'"\s*(<<)?\s*"', "", own)
                            own = "\n".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', own))
                        text += re.sub(r"\\n", " ", own) + "\n"
        self.text = " " + " ".join(re.findall(r"[A-Za-z]{2,}", text)) + " "

    def lack(self, line):
        """the line, if no three words of it in a row are there"""
        words = re.findall(r"[A-Za-z]{2,}", line)
        threes = [" " + " ".join(words[k:k + 3]) + " " for k in range(len(words) - 2)]
        twos = {" " + " ".join(words[k:k + 2]) + " " for k in range(len(words) - 1)}
        return len(words) > 3 and not re.match(r"(dem|demCost) -?\w", line) and \
            not any(t in self.text for t in threes) and sum(t in self.text for t in twos) < 2


class Manual:
    """The blocks of pages, run and counted."""

    def __init__(self, work):
        self.work = work
        self.counted, self.messages, self.helps = {}, None, {}
        with open(os.path.join(ROOT, "docs", "first-scene.md"), encoding="utf-8") as page:
            self.first = [b.text for b in blocks.of("", page.read())
                          if b.marker == "test: first.dem"][0]
        self.foam = shutil.which("demPimpleFoam") and shutil.which("blockMesh")

    def folder(self, page):
        path = os.path.join(self.work, page.replace("/", "_").replace(".md", ""))
        if not os.path.isdir(path):
            os.makedirs(path)
            for name in ("dem", "tests", "tutorials", "coupling", "solvers", "docs", "python"):
                os.symlink(os.path.join(ROOT, name), os.path.join(path, name))
            with open(os.path.join(path, "drop.dem"), "w") as out:
                out.write(self.first)
        return path

    def shell(self, text, folder, limit=LIMIT):
        """Run commands; returns what they print, raises where one fails."""
        os.makedirs(folder, exist_ok=True)
        done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", text], cwd=folder,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, errors="replace", timeout=limit)
        if done.returncode:
            raise Wrong("\n".join(done.stdout.strip().split("\n")[-8:]))
        return done.stdout

    # ------------------------------------------------------------------------------ scenes and cases

    def scene(self, block, more):
        own = entries(block.text + more) or {}
        own = {word: text for word, text in own.items() if word not in CASE}
        if "start" in own:
            raise Wrong("a scene with start needs a marker")
        text = "".join(own.get(w, BASE.get(w, "")) + "\n" for w in SCENE if w in own or w in BASE)
        folder = self.folder(block.page)
        name = "line%d.dem" % block.line
        with open(os.path.join(folder, name), "w") as out:
            out.write(text)
        end = float((re.search(r"\bend\s+([\d.e+-]+)\s*;", own.get("time", "")) or [0, 1])[1])
        self.shell("dem plan %s && dem run -set time/end %g -set write/interval %g %s" %
                   (name, min(end, 5e-4), min(end, 5e-4), name), folder)

    def bed(self):
        """The case of docs/first-bed.md, its patches called inlet and outlet."""
        made = os.path.join(self.work, "case", "bed")
        if not os.path.isdir(made):
            page = open(os.path.join(ROOT, "docs", "first-bed.md"), encoding="utf-8").read()
            text = [b.text for b in blocks.of("docs/first-bed.md", page) if b.marker == "run: ."][0]
            self.shell(re.sub(r"\btop\b", "outlet", re.sub(r"\bplate\b", "inlet", text)),
                       os.path.dirname(made))
            self.shell("sed -i 's/count 1400/count 100/' constant/demProperties && blockMesh",
                       made)
        copy = os.path.join(self.work, "case", "run")
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(made, copy)
        return copy

    def case(self, block, more):
        if not self.foam:
            return "no OpenFOAM"
        folder = self.bed()
        name = os.path.join(folder, "constant", "demProperties")
        base = entries(re.sub(r"FoamFile[^\n]*\n", "", open(name).read()))
        own = entries(re.sub(r"FoamFile[^\n]*\n", "", block.text) + more)
        settle = "start" in own
        base.pop("start")
        if "materials" in own or re.search(r"\bpatch \w", block.text):
            base.pop("walls")               # of another material; a patch that particles pass is no wall
        base.update(own)
        if "coupling" in own and "rho" not in own["coupling"]:
            base["coupling"] = own["coupling"].replace("{", "{ rho 1.2;", 1)
        with open(name, "w") as out:
            out.write("FoamFile { version 2.0; format ascii; class dictionary; "
                      "object demProperties; }\n" + "".join(base.values()))
        self.shell("demPimpleFoam -settle; demPimpleFoam -plan" if settle else
                   "demPimpleFoam -plan", folder)
        return None

    def control(self, block):
        if not self.foam:
            return "no OpenFOAM"
        folder = self.bed()
        own = block.text
        if not own.strip().startswith("functions"):
            own = "functions { %s }" % own
        self.shell("sed -i '/^start /d' constant/demProperties; "
                   "sed -i 's/^endTime .*/endTime 0.001;/' system/controlDict; "
                   "cat >> system/controlDict << 'END'\n%s\nEND\n%s" %
                   (own, "demPimpleFoam" if "demCloud" not in own else
                    "pimpleFoam > log; grep '^Suna: 100 particles' log"), folder)
        return None

    # ------------------------------------------------------------------------------------ commands

    def commands(self, text):
        """[[word, ...], ...] of shell text, without comments and without the words behind a gap
        of two and more spaces that tell what a command does."""
        found = []
        for line in re.sub(r"\\\n\s*", " ", text).split("\n"):
            line = re.split(r"\s#|\s{2,}|(?<=\w)\s{4,}", line.strip())[0]
            for part in re.split(r"\s*(?:&&|\|\||[;|])\s*", line):
                try:
                    words = shlex.split(part)
                except ValueError:
                    return None
                while words and re.match(r"\w+=", words[0]):
                    words = words[1:]
                if words and words[0] == "mpirun":
                    words = words[1:]
                    while words and words[0].startswith("-"):
                        words = words[2:]
                if words:
                    found.append(words)
        return found

    def known(self, word, page):
        """The program that a word of a page calls, or None."""
        here = os.path.dirname(os.path.join(ROOT, page))
        if "/" in word:
            for folder in (here, ROOT):
                path = os.path.normpath(os.path.join(folder, word))
                if os.access(path, os.X_OK) and os.path.isfile(path):
                    return path
            return None
        return word if word in SYSTEM or word == "make" else shutil.which(word)

    def is_shell(self, block):
        found = self.commands(block.text)
        return bool(found) and all(
            re.match(r"(\.|~)?/?[\w./-]+$", words[0]) and
            (words[0] in SYSTEM + ["make", "dem", "demPimpleFoam", "demCost", "demProgress"] or
             words[0].startswith("./") or
             words[0].startswith(("tests/", "tutorials/", "dem/build")))
            for words in found)

    def help(self, program):
        """What a program tells of itself: its -help, and the text of a script."""
        if program not in self.helps:
            text = ""
            script = os.path.isfile(program) and open(program, "rb").read(2) == b"#!"
            if script and os.path.basename(program) != "demCost":
                text = open(program, encoding="utf-8", errors="replace").read()
                for other in ("settings.py", "speed.py", "compare.py"):
                    beside = os.path.join(os.path.dirname(program), other)
                    text += open(beside).read() if os.path.exists(beside) else ""
            else:
                calls = [[program, "-help"]]
                if os.path.basename(program) == "dem":
                    calls = [[program, c, "-help"] for c in ("run", "plan", "cost", "effects")]
                for call in calls:
                    text += subprocess.run(call, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                           universal_newlines=True, timeout=20).stdout
            self.helps[program] = text
        return self.helps[program]

    def look_up(self, block):
        place = block.page
        for words in self.commands(block.text):
            if words[0] == "cd":
                if not os.path.isdir(os.path.join(os.path.dirname(os.path.join(ROOT, place)), words[1])) \
                        and not os.path.isdir(os.path.join(ROOT, words[1])) \
                        and words[1] not in ("bed",):
                    raise Wrong("no folder " + words[1])
                for folder in (os.path.dirname(place), ""):
                    if os.path.isdir(os.path.join(ROOT, folder, words[1])):
                        place = os.path.join(folder, words[1], "x")
                        break
                continue
            program = self.known(words[0], place)
            if program is None and not self.foam and words[0].startswith("dem"):
                continue
            if program is None:
                raise Wrong("no program " + words[0])
            if words[0] == "make":
                only = [w for w in words if w.startswith("ONLY=")]
                for name in only:
                    if not glob.glob(os.path.join(ROOT, "tests", name[5:] + "*")):
                        raise Wrong("no test " + name)
                targets = [w for w in words[1:] if not re.match(r"-|dem$|\w+=|\d", w)]
                self.shell("make -n -C dem %s > /dev/null" % " ".join(targets), ROOT)
                continue
            if words[0] in SYSTEM:
                continue
            for word in words[1:]:
                if re.match(r"--?[A-Za-z]", word) and not re.search(
                        r"(?<![\w-])-?%s\b" % re.escape(word), self.help(program)):
                    raise Wrong("%s does not know %s" % (words[0], word))
            if program.endswith("/Alltest"):
                for word in words[1:]:
                    if not word.startswith("-") and word != "quick" and \
                            not os.path.exists(os.path.join(ROOT, "tests", word, "run")):
                        raise Wrong("no suite " + word)

    # ---------------------------------------------------------------------------------------- blocks

    def kind(self, block):
        """how a block is run, the rest of its marker"""
        marker = block.marker or ""
        match = re.match(r"(run|save|scene|case|text|test|excerpt):\s*(.*)$", marker, flags=re.S)
        if match:
            kind, rest = match.groups()
            return ("elsewhere", "") if kind == "test" else (kind, rest)
        if marker in ("controlDict", "dem effects", "scene", "case"):
            return ("elsewhere" if marker == "dem effects" else marker), ""
        found = entries(re.sub(r"FoamFile[^\n]*\n", "", block.text))
        if found and all(word in SCENE + CASE for word in found):
            coupled = "coupling" in found or re.search(r"\b(patch \w|inside mesh)", block.text)
            return ("case" if coupled else "scene"), ""
        if found and list(found) == ["functions"]:
            return "controlDict", ""
        if not block.language and self.is_shell(block):
            return "commands", ""
        if block.language == "math":
            return "formula", ""
        if block.language:
            raise Wrong("say in a comment before the block how it is run")
        return ("printed" if block.fenced else "formula"), ""

    def run(self, block, kind, rest):
        first, *options = [part.strip() for part in re.split(r";\s*(?=after:|prints:)", rest)]
        options = dict(o.split(":", 1) for o in options)
        if kind == "run":
            if re.search(r"demPimpleFoam|blockMesh|[a-z]Foam\b", block.text) and not self.foam:
                return "no OpenFOAM"
            printed = self.shell(options.get("after", "") + "\n" + block.text,
                                 os.path.join(self.folder(block.page), first))
            if options.get("prints", "").strip() not in printed:
                raise Wrong("did not print%s, but\n%s" % (options["prints"], printed[-600:]))
        elif kind == "save":
            name = os.path.join(self.folder(block.page), first)
            self.shell(options.get("after", ""), self.folder(block.page))
            os.makedirs(os.path.dirname(name), exist_ok=True)
            with open(name, "w") as out:
                out.write(block.text)
        elif kind == "excerpt":
            with open(os.path.join(ROOT, first), encoding="utf-8") as file:
                if block.text not in file.read():
                    raise Wrong("no part of " + first)
        elif kind == "scene":
            self.scene(block, rest)
        elif kind == "case":
            return self.case(block, rest)
        elif kind == "controlDict":
            return self.control(block)
        elif kind == "commands":
            self.look_up(block)
        elif kind == "printed":
            self.messages = self.messages or Messages()
            for line in block.text.split("\n"):
                if self.messages.lack(line):
                    raise Wrong("in no message of the sources: " + line)
        return None

    def check(self, block):
        kind, bad, skipped, began = "?", "", None, time.monotonic()
        try:
            kind, rest = self.kind(block)
            skipped = self.run(block, kind, rest)
        except Wrong as wrong:
            bad = str(wrong)
        except subprocess.TimeoutExpired:
            bad = "took longer than %d s" % LIMIT
        what = {"text": "text (%s)" % (rest if kind == "text" else "")}.get(kind, kind)
        self.counted[kind] = self.counted.get(kind, 0) + 1
        claim("%s:%d %s%s" % (block.page, block.line, what, " # SKIP " + skipped if skipped else ""),
              not bad, bad)
        if time.monotonic() - began > 5.0:
            print("# that took %.0f s" % (time.monotonic() - began), flush=True)


def main():
    os.chdir(ROOT)
    os.environ["ROOT"] = ROOT
    manual = Manual(os.path.abspath(sys.argv[1]))
    pages = sys.argv[2:] or sorted(glob.glob("docs/*.md")) + ["README.md", "tutorials/README.md"] + \
        sorted(glob.glob("tutorials/*/README.md"))
    for page in pages:
        with open(page, encoding="utf-8") as file:
            for block in blocks.of(page, file.read()):
                manual.check(block)
    print("# blocks: " + ", ".join("%d %s" % (n, k) for k, n in sorted(manual.counted.items())))
    finish()


if __name__ == "__main__":
    main()
