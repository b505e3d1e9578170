# claims.sh -- conditions for claims, shared by tap.sh and soak/tap. A missing file fulfils none
# of them.
#
#   differs A B         both files exist, are not empty, and differ
#   agrees A B          both files exist, are not empty, and have the same bytes
#   equals A B          both texts are not empty and equal
#   lacks FILE PATTERN  the file exists, is not empty, and no line matches
#   claim_tables "what" FILE ...
#                       claims that these are CSV that any reader takes without options
#                       (csv_tables.py): Python's, and pandas where it is installed
#   thorough            status 0 in a long run (./Alltest -long): all ranks, compilers and cases
#   brief               status 0 in a quick run (./Alltest quick)
#
# SPDX-License-Identifier: GPL-3.0-or-later

differs()
{
    [ -s "$1" ] && [ -s "$2" ] || { echo "#   $1 or $2 is empty or not there"; return 1; }
    ! cmp -s "$1" "$2" || { echo "#   $1 and $2 are the same"; return 1; }
}

agrees()
{
    [ -s "$1" ] && [ -s "$2" ] || { echo "#   $1 or $2 is empty or not there"; return 1; }
    cmp "$1" "$2"
}

equals()
{
    [ -n "$1" ] && [ "$1" = "$2" ] || { echo "#   '$1' is not '$2', or both are empty"; return 1; }
}

lacks()
{
    [ -s "$1" ] || { echo "#   $1 is empty or not there"; return 1; }
    ! grep -e "$2" "$1" | sed "s|^|#   $1: |" | grep .
}

csv_tables=$(cd "${BASH_SOURCE[0]%/*}" && pwd)/csv_tables.py
claim_tables()
{
    local what=$1 python
    shift
    claim "$what, plain CSV" "${SUNA_PYTHON:-python3}" "$csv_tables" "$@"
    for python in "${SUNA_PYTHON:-python3}" /usr/bin/python3
    do
        if "$python" -c 'import pandas' 2> /dev/null
        then
            claim "$what, as pandas.read_csv(FILE) takes them" "$python" "$csv_tables" -pandas "$@"
            return
        fi
    done
    skip "$what, as pandas.read_csv(FILE) takes them" "no Python here has pandas (Debian: python3-pandas)"
}

thorough() { [ -n "${SUNA_LONG-}" ]; }
brief() { [ -n "${SUNA_QUICK-}" ]; }
