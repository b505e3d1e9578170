#!/bin/bash
# factorial.sh -- eight runs with and without rolling resistance, unequal beads and a frit, one
# core a run.
#
#   ./factorial.sh FOLDER [OPTION ...]    OPTIONs go to every Allrun, such as -end 10
#
# Copies of this case run in FOLDER; a finished run is kept, a stopped one continues from its last
# written time. All start poured at random, with cells of 2 mm and E = 1e6 Pa. At the end the table;
# to keep it: store.py -beside "WHAT RAN WHERE" factorial plain=FOLDER/plain ...
#
# SPDX-License-Identifier: GPL-3.0-or-later

[ $# -ge 1 ] || { sed -n '2,/^$/s/^# \{0,1\}//p' "$0"; exit 1; }
mkdir -p "$1" || exit 1
to=$(cd "$1" && pwd)
shift
cd "${0%/*}" || exit 1
. ../../coupling/setup/environment || exit 1

names=()
for rolling in "" rolling
do
    for sizes in "" sizes
    do
        for frit in "" frit
        do
            name=$rolling$sizes$frit
            names+=("${name:-plain}")
        done
    done
done

# go_on CASE: a run that was stopped, from its last written time
go_on()
{
    cd "$1" && echo "startFrom latestTime;" >> system/options &&
        demPimpleFoam > log.demPimpleFoam.again && grep -q '^End' log.demPimpleFoam.again &&
        "${SUNA_PYTHON:-python3}" compare.py
}

# one NAME OPTION ...
one()
{
    local name=$1 case="$to/$1" options=(-np 1 -pour -fine -modulus 1e6)
    shift
    [ ! -e "$case/result.csv" ] || return 0
    case $name in *rolling*) options+=(-rolling 0.1) ;; esac
    case $name in *sizes*) options+=(-sizes) ;; esac
    case $name in *frit*) options+=(-frit) ;; esac
    if [ -e "$case/log.demPimpleFoam" ] && [ -e "$case/0.1" ]
    then
        go_on "$case"
    else
        rm -rf "$case" && mkdir "$case" &&
            cp -r 0.orig constant system measured ./*.py ./*.dem column Allrun Allclean "$case" &&
            "$case/Allrun" "${options[@]}" "$@"
    fi > "$to/log.$name" 2>&1 || echo "factorial: $name failed; see $to/log.$name" >&2
}

# as many runs at once as there are cores
for name in "${names[@]}"
do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]
    do
        wait -n
    done
    one "$name" "$@" &
done
wait
"${SUNA_PYTHON:-python3}" beside.py "${names[@]/#/$to/}"
