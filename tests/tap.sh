# tap.sh -- for suites in bash that run the program dem: `. ../tap.sh` in the suite's folder, then
# claim and finish.
#
#   $dem                      the program, built if necessary; DEM=... in the environment names another
#   $work                     a folder for this run, removed at the end (kept with SUNA_KEEP=1)
#   claim "what" command ...  prints "ok" when the command succeeds
#   later "what" command ...  a claim in the background, at most $at_once at a time (most of a short run
#                             is the start of MPI, which waits)
#   collect                   waits for these and prints them
#   skip "what" why           prints "ok ... # SKIP why"
#   ranks N command ...       the command on N ranks, ended after SUNA_TEST_LIMIT seconds (default 120)
#                             (other programs: after 600, see watch)
#   printed_hash FILE         the fingerprint that a run printed
#   picture FILE NAME:BYTES   the items of a .vtp file, one a line, sorted: the named columns (the first
#   ...                       is "points") with their bytes per item; the same lines from any ranks
#   c_test SUITE/test_NAME    builds and runs a test in C, which prints its own TAP
#   take COMMAND ...          a program that prints TAP (tap.py); its claims are counted with ours
#   python_with MODULE ...    prints a python3 that has these modules
#   differs, agrees, equals, lacks, thorough, brief    see claims.sh
#   finish                    prints the plan and sets the exit status
#
# SPDX-License-Identifier: GPL-3.0-or-later

here=$PWD
. "${BASH_SOURCE[0]%/*}/claims.sh"
. "${BASH_SOURCE[0]%/*}/mpi/setup"
dem=${DEM:-$here/../../dem/build/dem}
if [ -z "${DEM-}" ] && ! built=$(make --no-print-directory -C ../../dem -j "$(nproc)" library \
    program 2>&1)
then
    echo "Bail out! the program dem cannot be built"
    echo "$built" | tail -n 20
    exit 1
fi
work=$(mktemp -d) || exit 1
"${BASH_SOURCE[0]%/*}/watch" $$ &
watch=$!
disown        # so that `wait` does not wait for it
# not a process that got its number
end_watch() { [ "$(cut -d' ' -f4 "/proc/$watch/stat" 2> /dev/null)" != $$ ] || kill "$watch"; }
trap 'end_watch; [ -n "${SUNA_KEEP-}" ] || rm -rf "$work"' EXIT
claims=0 failures=0 run_limit=${SUNA_TEST_LIMIT:-120}

claim()
{
    local what=$1
    shift
    claims=$((claims + 1))
    if "$@"
    then
        echo "ok $claims - $what"
    else
        echo "not ok $claims - $what"
        echo "#   failed: $*"
        failures=$((failures + 1))
        return 1
    fi
}

at_once=12
waiting=()

later()
{
    local k=${#waiting[@]}
    waiting+=("$1")
    shift
    (
        if "$@" > "$work/later.$k" 2>&1; then touch "$work/later.$k.good"; else echo \
            "#   failed: $*" >> "$work/later.$k"; fi
    ) &
    while [ "$(jobs -rp | wc -l)" -ge $at_once ]; do wait -n; done
}

collect()
{
    local k
    wait
    for k in "${!waiting[@]}"
    do
        claim "${waiting[$k]}" test -e "$work/later.$k.good" || cat "$work/later.$k"
        rm -f "$work/later.$k" "$work/later.$k.good"
    done
    waiting=()
}

skip()
{
    claims=$((claims + 1))
    echo "ok $claims - $1 # SKIP $2"
}

ranks()
{
    local n=$1
    shift
    if [ "$n" -eq 1 ]
    then
        timeout -k 5 "$run_limit" "$@"
    else
        timeout -k 5 "$run_limit" mpirun -np "$n" "$@"
    fi
}

printed_hash()
{
    sed -n 's/^hash //p' "$1"
}

picture()
{
    local file=$1 cells columns=() column start at
    shift
    cells=$(LC_ALL=C sed -n \
        's/.*NumberOfVerts="\([0-9]*\)" NumberOfLines="\([0-9]*\)".*/\1 \2/p;/<AppendedData/q' \
        "$file")
    cells=$((${cells/ /+}))
    at=$(LC_ALL=C grep -abo -m 1 'encoding="raw">' "$file" | head -n 1 | cut -d: -f1)
    for column in "$@"
    do
        start=$(LC_ALL=C sed -n \
            "s/.* Name=\"${column%:*}\" .* offset=\"\([0-9]*\)\".*/\1/p;/<AppendedData/q" "$file")
        tail -c +$((at + 17 + start + 8 + 1)) "$file" | head -c $((cells*${column#*:})) |
            od -An -v -tx1 -w"${column#*:}" > "$work/column.${#columns[@]}"
        columns+=("$work/column.${#columns[@]}")
    done
    paste "${columns[@]}" | sort
}

c_test()
{
    local build
    build=$(cd "$(dirname "$dem")" && pwd)
    if make --no-print-directory -C "$here/../../dem" BUILD="$build" "$build/tests/$1" > \
        "$work/c_test.log" 2>&1
    then
        (cd "$here/.." && timeout -k 5 "${SUNA_TEST_LIMIT:-600}" "$build/tests/$1") || failures=$((failures + 1))
    else
        claim "$1 can be built" false || sed 's/^/#   /' "$work/c_test.log" | tail -n 20
    fi
}

take()
{
    local line
    while IFS= read -r line
    do
        case $line in
        ok\ *) claims=$((claims + 1)); echo "ok $claims - ${line#ok * - }" ;;
        not\ ok\ *) claims=$((claims + 1)) failures=$((failures + 1))
            echo "not ok $claims - ${line#not ok * - }" ;;
        '#'*) echo "$line" ;;
        esac
    done < <("$@" 2>&1 | tee "$work/taken")
    claim "all these claims were made" grep -q '^1\.\.[1-9]' "$work/taken"
}

python_with()
{
    local python modules=$*
    for python in ${SUNA_PYTHON+"$SUNA_PYTHON"} python3 /usr/bin/python3
    do
        "$python" -c "import ${modules// /, }" 2> /dev/null && echo "$python" && return
    done
}

finish()
{
    echo "1..$claims"
    [ "$failures" -eq 0 ] && [ "$claims" -gt 0 ]
}
