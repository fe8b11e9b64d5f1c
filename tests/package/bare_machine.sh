#!/usr/bin/env bash
# Does Quicksand install and work on a Debian 12 that has nothing else?
#
#     bare_machine.sh PACKAGE.deb                      the package, its programs, documents, manual and completion
#     bare_machine.sh --beside-paraview PACKAGE.deb    the same where ParaView is, with its macro
#     bare_machine.sh --sources                        ./qs demo and ./qs test of these sources
#
# Needs root, debootstrap and Debian's mirror (DEBIAN_MIRROR, else http://deb.debian.org/debian). The machine is a folder
# in /var/tmp that chroot enters. It goes at the end, and stays where something is wrong.
set -euo pipefail

sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
most_packages=200 # that come with the package; a compiler or a desktop would be more

say() { printf '%s\n' "$*"; }

fail() {
  say "bare_machine.sh: $*" >&2
  [ -z "${machine:-}" ] || say "the machine is in $machine; look around with: chroot $machine" >&2
  exit 1
}

show_usage() {
  sed -n '4,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  say "hint: cmake --build build/release --target package makes build/release/quicksand_*.deb" >&2
  exit 2
}

# Run a command; what it says is shown when it fails.
logged() {
  "$@" >"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    fail "this ends with an error: $*"
  }
}

inside() {
  logged env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} chroot "$machine" "$@"
}

# A line of bash, run by a user in his own folder.
as_user() { inside su --login user --command "$1"; }

# The same, whose output has to hold a pattern.
as_user_says() {
  as_user "$1"
  grep -q -E -e "$2" "$log" || {
    tail -n 40 "$log" >&2
    fail "'$1' does not say '$2'"
  }
}

make_machine() {
  say "A bare Debian 12 from $mirror"
  machine=$(mktemp -d /var/tmp/quicksand-bare-XXXXXX)
  log=$machine.log
  trap 'remove_machine $?' EXIT
  chmod 755 "$machine"
  logged debootstrap --variant=minbase bookworm "$machine" "$mirror"
  mount -t proc proc "$machine/proc"
  inside useradd --create-home --shell /bin/bash user
  inside apt-get update
}

remove_machine() {
  umount "$machine/proc" 2>/dev/null || true
  [ "$1" -ne 0 ] || rm -rf "$machine" "$log"
}

# shellcheck disable=SC2016 # dpkg-query itself fills in ${Package}
installed_packages() { chroot "$machine" dpkg-query -W -f='${Package}\n' | sort; }

install_package() {
  cp "$1" "$machine/quicksand.deb"
  installed_packages >"$machine/before"
  inside apt-get install --yes --no-remove --no-install-recommends /quicksand.deb
  installed_packages | comm -13 "$machine/before" - >"$machine/new"
  local count superfluous
  count=$(wc -l <"$machine/new")
  say "Installed: $count packages with it"
  [ "$count" -le $most_packages ] || fail "these are more than $most_packages"
  superfluous=$(grep -E -e '-dev$|^(g\+\+|gcc|cmake|python3-vtk9)(-[0-9]+)?$' "$machine/new" || true)
  [ -z "$superfluous" ] || fail "it needs no $superfluous"
}

# shellcheck disable=SC2016 # the user's shell fills in the variables
check_package() {
  say "Commands of the README"
  as_user_says 'quicksand version' '^Quicksand [0-9]'
  as_user_says 'quicksand demo' 'Look at the pictures'
  as_user_says 'quicksand check /usr/share/quicksand/examples/dike' 'Cost'
  as_user_says 'quicksand run /usr/share/quicksand/examples/column' 'Verdict: good'
  as_user 'quicksand picture results/column && ls results/column/pictures/*.png'
  as_user 'quicksand report results/column && ls results/column/report.html'
  as_user 'quicksand new dike my_dike && quicksand check my_dike'
  say "Manual, completion, documents, examples"
  as_user_says 'zcat /usr/share/man/man1/quicksand.1.gz' '^\.SH NAME'
  as_user_says 'zcat /usr/share/man/man5/quicksand-scene.5.gz /usr/share/man/man5/quicksand-element.5.gz' 'cell_size'
  as_user_says 'source /usr/share/bash-completion/completions/quicksand
    COMP_LINE="quicksand ru" COMP_POINT=12; _quicksand quicksand ru quicksand 2>/dev/null; echo "${COMPREPLY[*]}"' '^run$'
  as_user 'cd /usr/share/doc/quicksand && ls README.md CITATION.cff copyright changelog.gz examples/column/scene.toml io/SCENE.md'
  local folder
  for folder in "$sources"/examples/*/; do
    as_user "ls /usr/share/quicksand/examples/$(basename "$folder")/README.md"
  done
}

check_macro() {
  say "Its macro in ParaView"
  as_user_says "xvfb-run -a -s '-noreset -screen 0 1280x1024x24' pvpython \
    /usr/share/quicksand/examples/paraview/four_views.py results/column" 'four_views.png: t = '
}

check_removal() {
  inside apt-get purge --yes quicksand
  local left
  left=$(chroot "$machine" find /usr /etc -xdev -name '*quicksand*')
  [ -z "$left" ] || fail "the package leaves behind: $left"
}

check_sources() {
  mkdir "$machine/home/user/quicksand"
  git -C "$sources" archive HEAD | tar -x -C "$machine/home/user/quicksand"
  local command
  for command in demo test; do
    say "./qs $command"
    inside sh -c "cd /home/user/quicksand && ./qs $command"
  done
  tail -n 4 "$log"
}

[ $# -ge 1 ] || show_usage
case $1 in
  --sources)
    make_machine
    check_sources
    ;;
  *)
    package=${!#}
    [ -f "$package" ] || show_usage
    make_machine
    if [ "$1" = --beside-paraview ]; then
      say "ParaView first"
      inside apt-get install --yes --no-install-recommends paraview python3-paraview xvfb xauth
    fi
    install_package "$package"
    check_package
    [ "$1" != --beside-paraview ] || check_macro
    check_removal
    ;;
esac
say "Good"
