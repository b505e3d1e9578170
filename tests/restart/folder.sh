# folder.sh -- part of run: what a run does with its folder and its output.
#
# An edited scene continues with the same bits on any number of ranks. A folder belongs to one run at
# a time; the lock of a run that was killed is taken over. No name of the scene overwrites a file of
# the run. A write that fails is told and ends in status 1; a log whose reader ends does not end the
# run.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# ---- an edited scene -----------------------------------------------------------------------------

cat > "$work/layer.dem" << 'END'
materials { glass { density 2500; youngsModulus 1e7; } steel { density 7800; youngsModulus 1e7; } }
effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.4; } mindlin { friction 0.3; } }
walls { box { type box; material steel; min (0 0 0); max (0.01 0.01 0.04); } }
insert { a { type random; material glass; count 300; diameter 1e-3; min (0 0 0); max (0.01 0.01 0.008); } }
time { end 0.02; } write { interval 0.01; vtk no; folder "out"; }
END
press='{ type plane; material steel; point (0 0 0.03); normal (0 0 -1); motion { type translation; velocity (0 0 -0.4); } }'
top='{ type random; material steel; count 200; diameter 1e-3; min (0 0 0.01); max (0.01 0.01 0.018); }'
edit=(-set insert/top "$top" -set walls/press "$press" -set time/end 0.03 "$work/layer.dem")
first=$(simulate layer 1 "$work/layer.dem")
edited=$(simulate layer.edited 1 -restart "$work/layer/out/snapshot.dem" "${edit[@]}")
claim "layers: 200 particles are inserted on those in the snapshot" \
    grep -q "^Suna: 500 particles" "$work/layer.edited/log.out"
claim "layers: each difference is a line of the log" [ -n "$first" -a "$(grep -c ' restart: ' "$work/layer.edited/log.out")" -eq 2 ]
claim "layers: on 3 ranks, the same bits" \
    ends_as "$edited" layer.3 3 -restart "$work/layer/out/snapshot.dem" "${edit[@]}"
claim "layers: an unchanged scene has no such line" eval \
    'simulate layer.same 1 -restart "$work/layer/out/snapshot.dem" -set time/end 0.021 "$work/layer.dem" > /dev/null
     lacks "$work/layer.same/log.out" "restart:"'

# ---- one run in a folder -------------------------------------------------------------------------

short=(-set time/end 1e-3 "$work/layer.dem")
start locked 1 -set time/end 100 -set write/interval 100 "$work/layer.dem"
begun locked
claim "a second run in a folder is refused, with process and host of the first" fails locked.second 1 \
    "another run writes into the folder ../locked/out: process $runner on host $(hostname)" \
    -set write/folder '"../locked/out"' "${short[@]}"
claim "... on 2 ranks, too" fails locked.second 2 "another run writes into the folder" \
    -set write/folder '"../locked/out"' "${short[@]}"
claim "... and the lock stays" [ -s "$work/locked/out/lock" ]
kill -9 "$runner"
over 2> /dev/null
killed=$runner
claim "the lock of a run that was killed is taken over, which is told" eval \
    'simulate locked 1 "${short[@]}" > /dev/null
     grep -q "^the lock of an earlier run in out, process $killed on host .*, which has ended, is taken over" "$work/locked/log.out"'
claim "at its end a run removes its lock" [ ! -e "$work/locked/out/lock" ]

# ---- names ---------------------------------------------------------------------------------------

for name in energy walls flows lost bonds effects budget particles_000001
do
    claim "averages named $name would overwrite a file of the run" fails names 1 \
        "averages named $name would overwrite" -set "averages/$name" \
        '{ min (0 0 0); max (1 1 1); interval 1e-3; }' "${short[@]}"
done
mkdir -p "$work/own"
cp "$work/layer.dem" "$work/own/snapshot.dem"
claim "a snapshot does not overwrite the scene" fails own 1 "would overwrite its scene snapshot.dem" \
    -set write/folder '"."' snapshot.dem

# ---- failing writes ------------------------------------------------------------------------------

# full WORDS ...: the command on a full device fails with one sentence
full()
{
    (cd "$work/layer" && timeout 60 "$dem" "$@" > /dev/full 2> full.err)
    [ $? -eq 1 ] && [ "$(wc -l < "$work/layer/full.err")" -eq 1 ] && grep -q "standard output" "$work/layer/full.err"
}
for words in "hash out/snapshot.dem" effects "effects hertz" -version -help "run -help" "plan $work/layer.dem" \
    "run -set write/folder full -set time/end 1e-4 $work/layer.dem" "cost -help" "import -help"
do
    claim "dem ${words%%/*} > /dev/full fails" full $words
done
claim "... and the run has written its snapshot" [ -s "$work/layer/full/snapshot.dem" ]
(cd "$work/layer" && "$dem" run -set write/folder piped -set write/interval 1e-3 -set time/end 0.005 \
    "$work/layer.dem" 2> piped.err; echo $? > piped.status) | head -n 1 > "$work/layer/piped.log"
claim "dem run | head -n 1: the run goes to its end" same "$("$dem" hash "$work/layer/piped/snapshot.dem")" \
    "$(simulate piped.whole 1 -set write/interval 1e-3 -set time/end 0.005 "$work/layer.dem")"
claim "... and says that its log is not whole" eval \
    '[ "$(cat "$work/layer/piped.status")" = 1 ] && grep -q "standard output" "$work/layer/piped.err"'
c_test restart/test_full_disk
