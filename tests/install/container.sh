# container.sh -- claims about the Dockerfile; part of `run`. Tests have no Docker: they read its
# lines, and in a long run execute them in a fresh Debian made by debootstrap (root, 20 minutes, 3 GB).
# SPDX-License-Identifier: GPL-3.0-or-later

recipe=$root/Dockerfile

# line WORD: the rest of the lines that begin with this word, continued lines joined
line()
{
    sed -e ':a;/\\$/{N;s/\\\n *//;ba}' "$recipe" | sed -n "s/^$1 //p"
}
# the image is Debian's; no line names a package or a host: both come with coupling/setup
by_set_up()
{
    [[ $(line FROM) == debian:* ]] && line RUN | grep -q "coupling/setup/environment'" &&
        ! line '\(RUN\|ADD\|ENV\|COPY\)' | grep -E 'apt(-get)? |pip |curl|wget|https?:'
}
claim "the container is a Debian with the packages of coupling/setup, and no others" by_set_up
copied()
{
    local from to
    while read -r from to; do [ -e "$root/$from" ] || return 1; done < <(line COPY)
}
claim "the files that the container copies exist" copied
if command -v demPimpleFoam > /dev/null && [ -n "${WM_PROJECT_DIR-}" ]
then
    claim "the entry point of the container runs demPimpleFoam" "$python" -c '
import json, subprocess, sys
words = [word.replace("/opt/suna", sys.argv[2]) for word in json.loads(sys.argv[1])]
printed = subprocess.run([*words, "demPimpleFoam", "-help"], stdout=subprocess.PIPE, check=True).stdout
sys.exit(b"-settle" not in printed)' "$(line ENTRYPOINT)" "$root"
else
    skip "the entry point of the container" "no OpenFOAM environment"
fi

# a fresh Debian with the sources of apt here
debian_in()
{
    local mirror
    mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)' 'Created-By: Packages' |
        sed -n 's/ bookworm$//p' | head -n 1)
    [ -n "$mirror" ] && debootstrap --variant=minbase bookworm "$1" "$mirror" || return 1
    rm -rf "$1/etc/apt"
    cp -r /etc/apt "$1/etc/apt" && cp /etc/resolv.conf "$1/etc/"
    [ ! -d /usr/share/keyrings ] || cp -r /usr/share/keyrings "$1/usr/share/"
    mount -t proc proc "$1/proc" 2> /dev/null
    return 0
}

# the ENV, COPY, RUN and WORKDIR lines, in their order
run_recipe()
{
    local word rest tree=$1
    local -a environment=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin container=yes)
    while read -r word rest
    do
        case $word in
        ENV) environment+=("$rest") ;;
        COPY)
            mkdir -p "$tree${rest#* }"
            (cd "$root/${rest% *}" && tar --exclude-vcs --exclude-from="$here/unwanted" -cf - .) |
                tar -C "$tree${rest#* }" -xf - || return 1 ;;
        RUN) chroot "$tree" env -i "${environment[@]}" sh -c "$rest" < /dev/null || return 1 ;;
        WORKDIR) mkdir -p "$tree$rest" ;;
        esac
    done < <(sed -e ':a;/\\$/{N;s/\\\n *//;ba}' "$recipe" | grep -E '^[A-Z]+ ')
    enter=(chroot "$tree" env -i "${environment[@]}" bash -c "$("$python" -c '
import json, sys; print(json.loads(sys.argv[1])[2])' "$(line ENTRYPOINT)")" suna)
    "${enter[@]}" demPimpleFoam -help
}
# the bed of ./Allrun, a short form: its table of profiles is new
runs_bed()
{
    "${enter[@]}" /opt/suna/Allrun -test < /dev/null && tail -n 5 "$work/log" | grep -q "/opt/suna/tutorials/muellerBed/.*csv"
}

if ! thorough
then
    skip "the lines of the Dockerfile run in a fresh Debian" "./Alltest -long install"
elif [ "$(id -u)" != 0 ] || ! command -v debootstrap > /dev/null
then
    skip "the lines of the Dockerfile run in a fresh Debian" "needs root and debootstrap"
else
    claim "a fresh Debian" quiet debian_in "$work/debian"
    claim "the lines of the Dockerfile run in it, and its demPimpleFoam" quiet run_recipe "$work/debian"
    claim "Allrun in it" quiet runs_bed
    umount "$work/debian/proc" 2> /dev/null
fi
