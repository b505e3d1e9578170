# wheel.sh -- the source distribution and the wheel without MPI that is made of it: its name, what its library needs, and
# the bouncing ball in an environment that has nothing but numpy and cffi; part of `run`. By default not optimised: it is
# the build that is tested; in a long run the wheel of a release, and the sets of `make dist`.
# SPDX-License-Identifier: GPL-3.0-or-later

if ! "$python" -c 'import sys, importlib.util as u
sys.exit(not all(map(u.find_spec, ("cffi", "numpy", "pip", "setuptools", "venv", "wheel"))))' 2> /dev/null
then
    skip "the wheel" "no python3 with cffi, numpy, pip, setuptools, venv and wheel"
    return
fi
wheels=$work/wheels
make_wheel()
{
    local flags='-O0 -DDEM_NO_CLONES'
    ! thorough || flags=
    (cd "$root/python" && "$python" -c "
from setuptools.build_meta import build_sdist
build_sdist('$wheels')") && (cd "$work" && SUNA_MPI=no DEM_CFLAGS=$flags PYTHONPATH= "$python" -m pip wheel --no-index \
        --no-build-isolation --no-deps -w "$wheels" "$wheels"/suna-"$version".tar.gz) && rm -rf "$root"/python/suna.egg-info
}
mkdir -p "$wheels"
claim "a source distribution, and a wheel without MPI of it" quiet make_wheel
wheel=$(echo "$wheels"/*.whl)
claim "the wheel is for each Python 3, and for each Linux with this C library or a later one" \
    eval '[[ ${wheel##*/} =~ ^suna-$version-py3-none-manylinux_2_([0-9]+)_$(uname -m).whl$ ]]'
oldest=${BASH_REMATCH[1]}
(mkdir "$work/wheel" && cd "$work/wheel" && "$python" -m zipfile -e "$wheel" .)
claim "its library needs the C library only" \
    equals "$(objdump -p "$work/wheel/suna/libdem.so" |
    sed -n 's/ *NEEDED *//p' | grep -v '^ld-linux' | sort | xargs)" "libc.so.6 libm.so.6"
claim "... of version 2.$oldest at most" equals "$(objdump -T "$work/wheel/suna/libdem.so" |
    sed -n 's/.*GLIBC_2\.\([0-9]*\).*/\1/p' | sort -n | tail -n 1 | awk '{ print ($1 > 17) ? $1 : 17 }')" "$oldest"
claim "it contains the licence" agrees "$root/COPYING" "$work/wheel/suna/COPYING"
metadata() { grep -qx "$1" "$work/wheel/suna-$version.dist-info/METADATA"; }
claim "its metadata have the version, and that it needs numpy and cffi" \
    eval 'metadata "Version: $version" && metadata "Requires-Dist: numpy" && metadata "Requires-Dist: cffi"'

# an environment without the packages of the system; numpy, cffi and what cffi needs are links to them
empty=$work/empty
make_empty()
{
    local needed file
    "$python" -m venv --without-pip "$empty" && mkdir "$work/needed" &&
        needed=$("$python" -c '
import importlib, os
for name in "numpy", "cffi", "_cffi_backend", "pycparser", "ply":
    try:
        file = importlib.import_module(name).__file__
        print(os.path.dirname(file) if file.endswith("__init__.py") else file)
    except ImportError:
        pass') || return 1
    for file in $needed; do ln -s "$file" "$work/needed"; done
    echo "$work/needed" > "$(echo "$empty"/lib/python3*/site-packages)/needed.pth"
    "$python" -m pip --python "$empty/bin/python" install --no-index --no-deps "$wheel"
}
claim "pip installs it in an empty environment" quiet make_empty
# alone COMMAND ...: in this environment, without the source tree, MPI's programs or variables
alone()
{
    (cd "$work/outside" && env -i "$empty/bin/python" "$@")
}
claim "there is no mpi4py, scipy or other package of the system" eval '! alone -c "import scipy" 2> "$work/log"'
claim "the bouncing ball: each rebound reaches e^2 of the height before" \
    quiet alone "$root/python/examples/bounce.py"
claim "it has the bits of the library with MPI" equals "$(alone -c "
import suna
sim = suna.Simulation('$root/tests/cost/pair.dem')
sim.advance(float('$(sed -n 's/.*end *\([0-9.e-]*\);.*/\1/p' "$root/tests/cost/pair.dem" | head -n 1)'))
print(sim.hash)")" "$(hash_of "$(realpath "$dem")")"
claim "a communicator is refused with the cure" eval 'alone -c "
import suna
class Comm:
    def py2f(self): return 0
    def Dup(self): return self
suna.Simulation(\"$root/tests/cost/pair.dem\", comm=Comm())" 2>&1 | tail -n 1 | grep -q "SunaError.*no MPI"'

if thorough
then
    dist()
    {
        git clone -q "$root" "$work/release" && make -C "$work/release/dem" dist PYTHON="$python" &&
            (cd "$work/release/dem/build/dist" && ls "suna-$version.tar.xz" "python/suna-$version.tar.gz" python/*.whl)
    }
    claim "make dist" quiet dist
    claim "the source has the files of the commit" equals "$(cd "$root" && git ls-tree -r --name-only HEAD | sort)" \
        "$(tar -tf "$work/release/dem/build/dist/suna-$version.tar.xz" | sed -n "s|^suna-$version/||p" | grep -v '/$' |
            grep . | sort)"
fi
