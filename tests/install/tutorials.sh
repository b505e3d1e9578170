# tutorials.sh -- claims about tutorials/Allrun, Allclean and Alltest, with two cases of a few lines;
# part of `run`. The real cases run in the suites tutorials and grains.
# SPDX-License-Identifier: GPL-3.0-or-later

make_cases()
{
    mkdir -p "$work/tree/tutorials/"{good,bad} "$work/tree/tests/"{grains,tutorials} &&
        cp "$root/tutorials/"All{run,clean,test} "$work/tree/tutorials/" && cd "$work/tree" || return 1
    printf '#!/bin/sh\necho "$0 $*"; touch "${0%%/*}/result.csv"\n' > tutorials/good/Allrun
    printf '#!/bin/sh\nexit 3\n' > tutorials/bad/Allrun
    printf '#!/bin/sh\nrm -f "${0%%/*}/result.csv"\n' | tee tutorials/good/Allclean > tutorials/bad/Allclean
    printf '#!/bin/sh\necho "ok 1 - Good: runs"; echo "1..1"\n' | tee tests/grains/run > tests/tutorials/run
    chmod +x tutorials/*/All* tests/*/run
}
# ends STATUS COMMAND ...: with its output in $work/said
ends()
{
    local status=$1
    shift
    "$@" > "$work/said" 2>&1
    [ $? = "$status" ] || { sed 's/^/#   /' "$work/said"; return 1; }
}
claim "two cases, one that fails" eval '(make_cases)'
fake=$work/tree/tutorials
claim "tutorials/Allrun -test of a case that completes ends with 0" ends 0 "$fake/Allrun" -test good
claim "its log is in the case, which got the option" grep -q -- '-test$' "$fake/good/log.Allrun"
claim "tutorials/Allrun of all ends with 1" ends 1 "$fake/Allrun"
claim "it reports by case" \
    eval 'grep -q "^good .* completed$" "$work/said" && grep -q "^bad .* FAILED" "$work/said"'
claim "tutorials/Allrun refuses an unknown case and names those there are" \
    eval 'ends 1 "$fake/Allrun" other && grep -q "bad good" "$work/said"'
claim "tutorials/Allclean removes the files of both" \
    eval 'ends 0 "$fake/Allclean" && [ ! -e "$fake/good/result.csv" ] && [ ! -e "$fake/good/log.Allrun" ]'
claim "tutorials/Alltest ends with 1 where a case has no claim, and names it" \
    eval 'ends 1 "$fake/Alltest" && grep -q "^bad .*NOT RUN" "$work/said"'
echo 'echo "not ok 1 - bad: runs"; exit 1' >> "$work/tree/tests/grains/run"
claim "tutorials/Alltest ends with 1 where a claim fails, and names its case" \
    eval 'ends 1 "$fake/Alltest" && grep -q "^bad .*FAILED" "$work/said"'
rm -r "$fake/bad"
sed -i '$d' "$work/tree/tests/grains/run"
claim "tutorials/Alltest ends with 0 where all pass" ends 0 "$fake/Alltest"
uncovered()
{
    local case
    for case in "$root"/tutorials/*/Allrun
    do
        case=${case%/Allrun}
        grep -qwi "${case##*/}" "$root"/tests/{tutorials,grains}/run || echo "#   ${case##*/}"
    done
}
claim "every tutorial is in the suite tutorials or grains" eval '! uncovered | grep .'
