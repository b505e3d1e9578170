# debian.sh -- builds the Debian packages in a copy of the tree, unpacks them and runs what they bring;
# part of `run` in a long run (5 minutes).
# SPDX-License-Identifier: GPL-3.0-or-later

if ! command -v dpkg-buildpackage > /dev/null || ! command -v dh > /dev/null || ! command -v dh_python3 > /dev/null
then
    skip "Debian packages" "no dpkg-dev, debhelper and dh-python"
    return
fi

build_packages()
{
    mkdir -p "$work/packages/suna" &&
        tar -C "$root" --exclude-vcs --exclude-from="$here/unwanted" -cf - . |
        tar -C "$work/packages/suna" -xf - && cd "$work/packages/suna" || return 1
    dpkg-buildpackage -us -uc -b
}
claim "dpkg-buildpackage -us -uc -b" quiet eval '(build_packages)'
unpack()
{
    local package
    for package in libdem"${version%%.*}" libdem-dev suna-dem python3-suna
    do
        dpkg -x "$work/packages/${package}_${version}"_*.deb "$work/unpacked" || return 1
    done
}
claim "the four packages are there" quiet unpack
claim "the program of suna-dem has the hash of the program in the build folder" \
    equals "$(hash_of "$work/unpacked/usr/bin/dem")" "$(hash_of "$(realpath "$dem")")"
claim "python3-suna loads the library of libdem${version%%.*}, which has the same hash" equals \
    "$(outside env PYTHONPATH="$work/unpacked/usr/lib/python3/dist-packages" "$python" -c '
import suna
sim = suna.Simulation("materials { ball { density 2500; youngsModulus 1e7; } } effects { hertz {} }"
    "insert { two { type list; diameter 1e-3; positions ((0 0 0) (1.00137e-3 0 0));"
    "velocities ((0.5 0 0) (-0.5 0 0)); } }")
sim.advance(3e-4)
print(sim.hash)')" "$(hash_of "$(realpath "$dem")")"
if command -v cmake > /dev/null
then
    # the files are below another root than the one that they are made for
    prefix=$work/unpacked/usr
    claim "find_package(suna) with libdem-dev" quiet configure C "$version"
    claim "a program with each library of libdem-dev" quiet cmake --build "$work/C$version"
fi
if command -v lintian > /dev/null
then
    claim "lintian has no error and no warning" quiet lintian --allow-root --fail-on error,warning "$work"/packages/*.changes
fi
