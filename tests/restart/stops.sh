# stops.sh -- part of run: runs stopped by signals, and by the file stop.
#
# A signal ends a run with a snapshot from which it continues with the same bits and tables, after
# any number of stops and changes of ranks; so does the file. A run that is killed while it writes
# leaves its last complete snapshot.
#
# Signals are sent when the run has reached a time, of which a row of a table or a line of its log
# tells, so that it does not matter how fast the machine is. Each wait ends after $run_limit seconds.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# begun FOLDER: wait until the run there has printed its first step; from then on all its ranks
# handle signals
begun()
{
    local k alive=yes
    for ((k = 0; k < 20*run_limit; k++))
    do
        kill -0 "$runner" 2> /dev/null || alive=
        grep -qs "^step " "$work/$1/log.out" && return 0
        [ -n "$alive" ] || break
        sleep 0.05
    done
    echo "#   $1 does not begin"
    false
}

# reached FILE PATTERN COUNT: wait until so many lines of the file match, or the run has ended
reached()
{
    local k found
    for ((k = 0; k < 50*run_limit; k++))
    do
        found=$(grep -cs -e "$2" "$work/$1")
        [ "${found:-0}" -lt "$3" ] || return 0
        kill -0 "$runner" 2> /dev/null || return 1
        sleep 0.02
    done
    echo "#   $1 has not $3 lines $2"
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

# family PROCESS: it and all below it; mpirun of MPICH has a process between itself and the ranks
family()
{
    local child
    echo "$1"
    for child in $(pgrep -P "$1"); do family "$child"; done
}

over()
{
    local status
    wait "$runner"
    status=$?
    kill $watchdog 2> /dev/null
    return $status
}

# stopped FOLDER WHAT: the run has ended properly and reports what has stopped it
stopped()
{
    over && grep -q "^stopped by $2 at t .* -restart $file continues" "$work/$1/log.out" \
        && same "$("$dem" hash "$work/$1/$file") at the stop" "$(printed_hash "$work/$1/log.out")" \
        || { sed 's/^/#   /' "$work/$1/log.out" "$work/$1/log.err"; false; }
}

# stop FOLDER RANKS SIGNAL TIME ARGUMENT ...: a run that gets a signal when walls.csv has the row of
# this time
stop()
{
    local folder=$1 n=$2 signal=$3 time=$4
    shift 4
    start "$folder" "$n" "$@"
    begun "$folder" && reached "$folder/out/walls.csv" "^$time," 1 && kill -"$signal" "$runner"
    stopped "$folder" "SIG$signal"
}

# mpirun passes SIGUSR1 to what it has started
passes_signals()
{
    local k
    (cd "$work" && exec mpirun -np 2 bash -c \
        'trap "exit 0" USR1; touch ready.${OMPI_COMM_WORLD_RANK-$PMI_RANK}; for k in {1..100}; do sleep 0.1; done; exit 1') &
    runner=$!
    for ((k = 0; k < 200; k++))
    do
        [ ! -e "$work/ready.0" -o ! -e "$work/ready.1" ] || break
        sleep 0.05
    done
    kill -USR1 $runner
    wait $runner
}
claim "mpirun passes SIGUSR1 on; otherwise export HWLOC_COMPONENTS=-opencl (docs/output.md)" passes_signals

c_test restart/test_snapshot
c_test restart/test_stopping

# ---- signals -------------------------------------------------------------------------------------

# grains that cross periodic faces, bonded ones that break and leave, and their tables, which a
# series of stops must not change; windows as long as the time between rows of walls.csv
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
write { interval 0.04; walls 0.002; vtk no; folder "out"; snapshot last; }
END
file=out/snapshot.dem
whole=$(simulate wander.whole 1 "$work/wander.dem")
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
# hwloc with all its plugins loads pocl where that is installed, which takes handlers of signals
HWLOC_COMPONENTS= claim "stopped by SIGUSR1 on 1 rank" stop wander 1 USR1 0.004 "$work/wander.dem"
go_from=(-restart "$file" "$work/wander.dem")
claim "continued on 3 ranks, stopped again" stop wander 3 USR1 0.012 "${go_from[@]}"
claim "continued on 1 rank, stopped by SIGTERM" stop wander 1 TERM 0.018 "${go_from[@]}"
claim "continued on 2 ranks, stopped again" stop wander 2 USR1 0.026 "${go_from[@]}"
claim "and on 2 to its end: the same bits" ends_as "$whole" wander 2 "${go_from[@]}"
for table in bonds lost box
do
    claim "$table.csv: the same to its last digit" agrees "$work/wander/out/$table.csv" "$work/wander.whole/out/$table.csv"
done
claim "the same windows as the run without a stop" same "$(grep -vc "^#" "$work/wander/out/box.csv")" 17

# snapshot all and no: with all the file has the number of the next output; with no it is
# snapshot.dem
file=out/snapshot_000001.dem
claim "snapshot all: the number of the next output" stop wander.all 1 TERM 0.004 -set write/snapshot all "$work/wander.dem"
file=out/snapshot.dem
claim "snapshot no: there is one all the same" stop wander.no 1 TERM 0.004 -set write/snapshot no "$work/wander.dem"
simulate kept 1 -set time/end 0.006 -set write/interval 0.001 -set write/snapshot all -set write/keep 2 "$work/wander.dem" > /dev/null
claim "keep 2: the last two of seven" same "$(cd "$work/kept/out" && echo snapshot*)" "snapshot_000005.dem snapshot_000006.dem"

# each_step FOLDER RANKS: rows of walls in each step, so that no signal comes within an advance
each_step()
{
    start "$1" "$2" -set write/snapshot no -set write/walls 1e-6 -set time/end 10 "$work/wander.dem"
    begun "$1" && reached "$1/out/walls.csv" "^[0-9]" 20 && kill -USR1 "$runner"
    stopped "$1" SIGUSR1
}
for n in 1 2
do
    claim "rows in each step, ranks $n: stopped" each_step "each.$n" $n
done

# ---- the file stop -------------------------------------------------------------------------------

# by_file FOLDER RANKS ARGUMENT ...: a run whose folder gets the file when walls.csv has a row; it is
# looked for once a second, so the run is a long one
by_file()
{
    local folder=$1
    start "$@" -set time/end 10 "$work/wander.dem"
    begun "$folder" && reached "$folder/out/walls.csv" "^0.002," 1 && touch "$work/$folder/out/stop"
    stopped "$folder" "the file stop" && [ ! -e "$work/$folder/out/stop" ]
}
for n in 1 3
do
    claim "the file stop ends a run on $n ranks, and is removed" by_file "by.file.$n" $n
done
mkdir -p "$work/by.file.before/out"
touch "$work/by.file.before/out/stop"
simulate by.file.before 1 -set time/end 0.002 "$work/wander.dem" > /dev/null
claim "one from before the start is removed, which is told" grep -q \
    "^the file out/stop, which was there before this run, is removed" "$work/by.file.before/log.out"
claim "... and the run goes to its end" lacks "$work/by.file.before/log.out" "^stopped by"

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
    reached killed/log.out "^t " $((1 + RANDOM%30))
    kill -9 $(family $runner) 2> /dev/null
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
