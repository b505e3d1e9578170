"""One source builds with OpenFOAM.com v1912 and later.

Other versions are refused with a sentence, before the build and by the compiler. Only compat.H tests for a version,
and each version finds its function there.

SUNA_FOAM_TREES names source trees of OpenFOAM.com, separated by colons: all sources compile with each, some minutes.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from case import *

top = here.parents[2]


def run(*command, env=None):
    return subprocess.run(command, env=env, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)


# ---- Allwmake, in an environment as a version has it ---------------------------------------------

wmake = work/"foam/wmake/wmake"
wmake.parent.mkdir(parents=True)
wmake.write_text("#!/bin/sh\necho built\n")
wmake.chmod(0o755)


def refused(version, words, api=""):
    """Allwmake ends with one message that has these words, and builds nothing."""
    env = {"PATH": f"{wmake.parent}:/usr/bin:/bin", "WM_PROJECT": "OpenFOAM", "WM_PROJECT_DIR": str(work/"foam"),
           "WM_PROJECT_VERSION": version, "FOAM_API": api}
    done = run("bash", top/"Allwmake", "-s", env=env)
    claim(f"{version} is refused", done.returncode == 1 and words in done.stdout and "built" not in done.stdout
          and done.stdout.count("\n") <= 2, done.stdout)


for version in ("9", "10", "11", "12", "13", "dev"):
    refused(version, f"OpenFOAM {version}, not OpenFOAM.com v1912 or later")
refused("v1906", "older than v1912", "1906")
refused("v1812", "older than v1912")

# ---- programs of another version in PATH ------------------------------------------------------------

# an environment as of a version whose programs are not built: only its library is there
library = work/"foam/platforms/lib/libOpenFOAM.so"
library.parent.mkdir(parents=True)
library.touch()
checker = here.parents[1]/"foam_programs"
done = run("bash", checker, env={**os.environ, "WM_PROJECT_DIR": str(work/"foam"), "FOAM_LIBBIN": str(library.parent),
                                 "WM_PROJECT_VERSION": "v2512"})
claim("a program that belongs to another version is told", done.returncode == 1 and re.search(
    "^/.*/pimpleFoam belongs to another OpenFOAM", done.stdout, re.M), done.stdout)
done = run("bash", checker)
claim("the programs here belong to the sourced one", done.returncode == 0 and " pimpleFoam " in done.stdout, done.stdout)

# ---- the compiler, with declarations of each version ------------------------------------------------

headers = work/"headers"
headers.mkdir()
mpi = run("mpicc", "--showme:compile").stdout.split()


def compiled(source, *options):
    return run("g++", "-fsyntax-only", *options, f"-I{headers}", f"-I{top}/coupling/common", f"-I{top}/dem/include", *mpi,
               "-x", "c++", source)


def first_error(words, *options):
    """compat.H, the first include of all sources, does not compile, and the first error has these words."""
    return words in re.search(".*error.*", compiled(top/"coupling/common/compat.H", "-std=c++11", *options).stdout)[0]


claim("without the macro of OpenFOAM.com the first error names the requirement",
      first_error("Suna builds with OpenFOAM.com v1912 or later"))
claim("with an older version the first error names the requirement",
      first_error("Suna needs OpenFOAM.com v1912 or later", "-DOPENFOAM=1906"))

use = work/"use.C"
use.write_text("""#include "compat.H"
void write(const Foam::regIOobject& io) { Foam::demWriteAscii(io); }
int main() { int i = 0; Foam::demBroadcast(i); return i; }
""")
for name in ("regIOobject.H", "Time.H"):
    (headers/name).touch()


def finds(version, standard, broadcast, write):
    """This version, with this name of Pstream::broadcast and these arguments of writeObject, finds its function."""
    (headers/"Pstream.H").write_text(f"""
namespace Foam
{{
    template<class T> struct List {{ List(int); T& operator[](int); }};
    struct Pstream
    {{
        template<class T> static void {broadcast}(T&) {{}}
        template<class T> static void gatherList(T&);
        static int nProcs(), myProcNo();
    }};
    struct Time {{ int writeCompression() const {{ return 0; }} }};
    struct IOstream {{ static const int ASCII = 0, currentVersion = 2; }};
    struct IOstreamOption {{ static const int ASCII = 0; IOstreamOption(int, int) {{}} }};
    struct regIOobject {{ const Time& time() const; bool writeObject({write}) const; }};
}}
""")
    done = compiled(use, f"-std={standard}", "-Wall", "-Werror", f"-DOPENFOAM={version}")
    claim(f"v{version} finds its function", done.returncode == 0, done.stdout)


# Pstream has scatter up to v2112, which is deprecated from v2412 on; writeObject has another argument from v2012 on
finds(1912, "c++11", "scatter", "int, int, int, bool")
finds(2112, "c++11", "scatter", "IOstreamOption, bool")
for version, standard in ((2206, "c++11"), (2312, "c++14"), (2412, "c++17")):
    finds(version, standard, "broadcast", "IOstreamOption, bool")

# ---- the sources ------------------------------------------------------------------------------------

sources = [path for part in ("coupling", "solvers") for path in (top/part).rglob("*.[CH]")
           if path.name != "compat.H" and not {"lnInclude", "Make"} & set(path.relative_to(top).parts)]


def lines(pattern):
    """The lines of the sources that have this expression."""
    return [f"{path}: {line}" for path in sources for line in path.read_text().splitlines() if re.search(pattern, line)]


claim("the sources are found", len(sources) > 80)
found = lines(r"OPENFOAM *[<>=]|defined *\( *OPENFOAM|ifn?def *OPENFOAM")
claim("only compat.H depends on the version", not found, *found)
# up to v2512
found = lines(r"Pstream::(scatter\(|scatterList|listCombineScatter|mapCombineScatter|combineScatter)"
              r"|IDLList|PhaseIncompressible|\.good\(\)|throwing\(")
claim("deprecated or removed functions are not called", not found, *found)

trees = os.environ.get("SUNA_FOAM_TREES", "").split(":")
for tree in filter(None, trees):
    done = run(here/"compile", tree)
    claim(f"all sources compile without a warning with {tree}", done.returncode == 0, done.stdout)
if trees == [""]:
    skip("sources compile with other versions", "SUNA_FOAM_TREES names no source tree of OpenFOAM.com")
finish()
