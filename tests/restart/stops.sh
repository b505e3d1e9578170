# stops.sh -- part of run: runs stopped by signals.
#
# A signal ends a run with a snapshot from which it continues with the same bits and tables, after
# any number of stops and changes of ranks. A run that is killed while it writes leaves its last
# complete snapshot.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# begun FOLDER: wait until the run there has printed its first step; from then on all its ranks
# handle signals
begun()
{
    local k
    for ((k = 0; k < 20*run_limit; k++))
    do
        grep -qs "^step " "$work/$1/log.out" && return 0
        sleep 0.05
    done
    echo "#   $1 does not begin"
    false
}

# start FOLDER RANKS ARGUMENT ...: in the background; $runner is the process to wait for and to
# signal: dem on one rank, else mpirun
start()
{
    local folder=$work/$1 n=$2
    shift 2
    mkdir -p "$folder"
    rm -f "$folder/log.out"
    if [ "$n" -eq 1 ]
    then
        (cd "$folder" && exec "$dem" run "$@" > log.out 2> log.err) &
    else
        (cd "$folder" && exec mpirun -np "$n" "$dem" run "$@" > log.out 2> log.err) &
    fi
    runner=$!
    local watched=$runner                                 # ends a run that hangs
    (sleep "$run_limit"; kill -9 $watched 2> /dev/null) > /dev/null 2>&1 &
    watchdog=$!
}

over()
{
    local status
    wait "$runner"
    status=$?
    kill $watchdog 2> /dev/null
    return $status
}

# stop FOLDER RANKS SIGNAL DELAY ARGUMENT ...: a run stopped so many seconds after its start ends
# properly and reports it
stop()
{
    local folder=$1 n=$2 signal=$3 delay=$4
    shift 4
    start "$folder" "$n" "$@"
    begun "$folder" && sleep "$delay"
    kill -"$signal" "$runner"
    over && grep -q "^stopped by SIG$signal at t .* -restart $file continues" "$work/$folder/log.out" \
        && same "$("$dem" hash "$work/$folder/$file")" "$(printed_hash "$work/$folder/log.out")" \
        || { sed 's/^/#   /' "$work/$folder/log.out" "$work/$folder/log.err"; false; }
}

c_test restart/test_snapshot
c_test restart/test_stopping

# ---- signals -------------------------------------------------------------------------------------

# grains that cross periodic faces, bonded ones that break and leave, and their tables, which a
# series of stops must not change; one window, as long as the run
cat > "$work/wander.dem" << 'END'
materials { glass { density 2500; youngsModulus 1e7; } }
effects
{
    gravity { acceleration (2 0 -9.81); } hertz { impactSpeed 2; } dry { restitution 0.7; } mindlin { friction 0.5; }
    bondLinear { normalStiffness 4e9; shearStiffness 1.6e9; radius 0.8; makeDistance 1.02; normalStrength 2e4; shearStrength 2e4; }
}
walls { floor { type plane; point (0 0 0); normal (0 0 1); motion { type oscillation; amplitude (0 0 2e-4); frequency 50; } } }
domain { min (0 0 -0.001); max (0.02 0.02 0.03); periodic (x y); leaving remove; }
insert
{
    block { type lattice; diameter 1e-3; count 700; spacing 1.001; jitter 0; min (0 0 0); max (0.02 0.02 0.02); velocity (1 0.5 0); }
    rain { type lattice; diameter 1e-3; count 300; min (0 0 0.006); max (0.02 0.02 0.02); velocity (-1 -0.7 1); }
}
averages { box { min (0 0 0); max (0.02 0.02 0.02); cells (2 2 4); interval 1e-4; } }
time { end 0.04; }
write { interval 0.04; vtk no; folder "out"; snapshot last; }
END
file=out/snapshot.dem
whole=$(simulate wander.whole 2 "$work/wander.dem")
claim "stops: a run without any, bonds break and grains leave" [ -n "$whole" -a -s "$work/wander.whole/out/bonds.csv" \
    -a -s "$work/wander.whole/out/lost.csv" ]
# positions in tables must not depend on when particles are wrapped into the periodic box
tables_with_skin()
{
    simulate "wander.$1" 1 -set neighbours/outerSkin "$1" "$work/wander.dem" > /dev/null
    agrees "$work/wander.$1/out/bonds.csv" "$work/wander.whole/out/bonds.csv" && agrees "$work/wander.$1/out/lost.csv" "$work/wander.whole/out/lost.csv"
}
for skin in 0.06 1.5
do
    later "lists rebuilt at other times, outer skin $skin: bonds.csv and lost.csv are the same to the last digit" tables_with_skin $skin
done
collect
claim "stopped by SIGUSR1 on 1 rank" stop wander 1 USR1 0.3 "$work/wander.dem"
go_from=(-restart "$file" "$work/wander.dem")
claim "continued on 3 ranks, stopped again" stop wander 3 USR1 0.3 "${go_from[@]}"
claim "continued on 1 rank, stopped by SIGTERM" stop wander 1 TERM 0.1 "${go_from[@]}"
claim "continued on 2 ranks, stopped again" stop wander 2 USR1 0.2 "${go_from[@]}"
claim "and on 2 to its end: the same bits" ends_as "$whole" wander 2 "${go_from[@]}"
for table in bonds lost box
do
    claim "$table.csv: the same to its last digit" agrees "$work/wander/out/$table.csv" "$work/wander.whole/out/$table.csv"
done
claim "the windows were those of the run without a stop" same "$(grep -vc "^#" "$work/wander/out/box.csv")" 17

# snapshot all and no: with all the file has the number of the next output; with no it is
# snapshot.dem
file=out/snapshot_000001.dem
claim "snapshot all: the number of the next output" stop wander.all 1 TERM 0.2 -set write/snapshot all "$work/wander.dem"
file=out/snapshot.dem
claim "snapshot no: there is one all the same" stop wander.no 1 TERM 0.2 -set write/snapshot no "$work/wander.dem"
simulate kept 1 -set time/end 0.006 -set write/interval 0.001 -set write/snapshot all -set write/keep 2 "$work/wander.dem" > /dev/null
claim "keep 2: the last two of seven" same "$(cd "$work/kept/out" && echo snapshot*)" "snapshot_000005.dem snapshot_000006.dem"

# ---- kill -9 -------------------------------------------------------------------------------------

# a run that writes a snapshot every few steps; killed 8 times (in a long run 20), it continues from
# the last one each time
killing=(-set write/interval 2e-5 -set time/end 0.006 -set write/lastGood no "$work/wander.dem")
expected=$(simulate killed.not 1 "${killing[@]}")
torn=0 readable=0 kills=8
! thorough || kills=20
mkdir -p "$work/killed"
for ((k = 1; k <= kills; k++))
do
    from=()
    [ ! -e "$work/killed/out/snapshot.dem" ] || from=(-restart out/snapshot.dem)
    n=$((k%4 == 0 ? 2 : 1))
    start killed $n "${from[@]}" "${killing[@]}"
    begun killed
    sleep "0.0$((RANDOM%100))"
    if [ $n -eq 1 ]
    then
        kill -9 $runner
    else
        mapfile -t own < <(pgrep -P $runner)
        kill -9 "${own[@]}" $runner 2> /dev/null
    fi
    over 2> /dev/null
    [ ! -e "$work/killed/out/snapshot.dem.part" ] || torn=$((torn + 1))
    ! "$dem" hash "$work/killed/out/snapshot.dem" > /dev/null || readable=$((readable + 1))
done 2> /dev/null
echo "# $torn of $kills kills came in the middle of writing, at last at $("$dem" hash "$work/killed/out/snapshot.dem")"
claim "killed $kills times while it wrote: each time there is a whole snapshot" [ $readable -eq $kills ]
claim "and the run continues from the last one to the same end" ends_as "$expected" killed 1 -restart out/snapshot.dem "${killing[@]}"
claim "with the same means" agrees "$work/killed/out/box.csv" "$work/killed.not/out/box.csv"

# ---- progress ------------------------------------------------------------------------------------

# a run without output for minutes
mkdir -p "$work/progress"
(cd "$work/progress" && exec "$dem" run -set time/end 10 -set write/interval 10 "$work/wander.dem" > log.out 2>&1) &
slow=$!

# share done, time left, steps and particle-steps a second of 1000 particles, after 10 s of the clock
progress_line()
{
    local k
    for ((k = 0; k < 600; k++))
    do
        ! grep -q '^progress' "$work/progress/log.out" || break
        sleep 0.1
    done
    grep -m 1 '^progress' "$work/progress/log.out" | tr -d , | awk '
        { left = 10*(100 - $2)/$2; print "# " $0
          exit !($3 == "%" && $2 > 0 && $4 > left/2 && $4 < 2*left && $5 " " $6 == "s left" &&
                 $8 == "steps/s" && $9 > 900*$7 && $9 < 1000.5*$7 && $10 == "particle-steps/s") }'
}
claim "progress is told every 10 s, also between outputs" progress_line
kill -9 $slow
wait $slow 2> /dev/null
