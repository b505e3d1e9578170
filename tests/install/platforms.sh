# platforms.sh -- the core with other compilers, with MPICH, without MPI, with musl, and for aarch64 under emulation: it builds
# without a warning, and short scenes of tests/parallel have the golden fingerprints; part of `run` in a long run (three
# minutes each). What is not installed is skipped. Results: docs/install.md.
# SPDX-License-Identifier: GPL-3.0-or-later

scenes="bed periodic liquid rolling wet bonded clay all streams heat bridges hot parcels stages cell press
    clumps"

# has_golden RUNNER PROGRAM: each scene, with the command RUNNER before the program, ends with the fingerprint of
# tests/parallel/golden.txt
has_golden()
{
    local scene found bad=0 folder=$work/platform
    for scene in $scenes
    do
        rm -rf "$folder" && mkdir "$folder"
        found=$(cd "$folder" && timeout -k 5 900 $1 "$2" run "$root/tests/parallel/$scene.dem" 2> log | sed -n 's/^hash //p')
        [ -n "$found" ] && [ "$found" = "$(awk -v scene="$scene" '$1 == scene { print $2 }' "$root/tests/parallel/golden.txt")" ] ||
            { echo "#   $scene: found ${found:-nothing}"; head -n 3 "$folder/log"; bad=1; }
    done
    return $bad
}

# platform NAME COMPILER "RUNNERS" ARGUMENT ...: build with `make ARGUMENT ...` where COMPILER is installed; run by itself, or
# with each of the commands of RUNNERS, separated by commas
platform()
{
    local name=$1 compiler=$2 runners runner
    IFS=, read -r -a runners <<< "$3"
    [ ${#runners[@]} -gt 0 ] || runners=("")
    shift 3
    command -v "$compiler" > /dev/null || { skip "$name" "no $compiler"; return; }
    rm -rf "$work/other"
    claim "$name: core and program build without a warning" \
        quiet make -s -C "$core" -j "$(nproc)" BUILD="$work/other" "$@" "$work/other/dem" || return
    for runner in "${runners[@]}"
    do
        claim "$name: the golden fingerprints${runner:+, $runner}" has_golden "$runner" "$work/other/dem"
    done
}

for compiler in $(compgen -c | grep -xE 'gcc-1[2-9]|clang-(1[4-9]|2[0-9])' | sort -u)
do
    OMPI_CC=$compiler platform $compiler $compiler ",mpirun -np 3"
done
# waiting ranks of MPICH keep their core (tests/mpi/yield.c)
! command -v mpicc.mpich > /dev/null || gcc -shared -fPIC ../mpi/yield.c -o "$work/yield.so"
with_mpich="env LD_PRELOAD=$work/yield.so"
platform MPICH mpicc.mpich ",$with_mpich mpirun.mpich -np 3" CC=mpicc.mpich
if command -v mpicc.mpich > /dev/null
then
    for suite in unit parallel restart
    do
        take $with_mpich SUNA_LONG= SUNA_MPIRUN=mpirun.mpich CC=mpicc.mpich BUILD="$work/other" \
            DEM="$work/other/dem" "../$suite/run"
    done
fi
platform "without MPI" gcc "" MPI=no
platform musl musl-gcc "" MPI=no CC=musl-gcc DEM_CFLAGS=-DDEM_NO_CLONES
platform aarch64 aarch64-linux-gnu-gcc "qemu-aarch64 -L /usr/aarch64-linux-gnu" MPI=no CC=aarch64-linux-gnu-gcc
