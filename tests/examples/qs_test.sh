#!/usr/bin/env bash
# Does ./qs install only what a build lacks, and does it build beside Debian's ParaView?
#
#     qs_test.sh FOLDER_OF_QS
#
# The script runs on a project of one file with CMake and ninja themselves and with fakes of Debian's tools, without
# network and without root.
set -euo pipefail
shopt -s inherit_errexit

source=$(cd "$1" && pwd)
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# Debian's tools. They know the installed packages from the file `installed`, and write their calls to `calls`.
make_fakes() {
  mkdir -p "$place/fakes"
  cat >"$place/fakes/dpkg-query" <<'END'
#!/bin/sh
for package; do :; done
grep -q -x "$package" "$PLACE/installed" && echo 'install ok installed'
END
  cat >"$place/fakes/apt-get" <<'END'
#!/bin/sh
echo "apt-get $*" >>"$PLACE/calls"
[ ! -e "$PLACE/offline" ] || exit 100
case $1 in
  update) touch "$PLACE/lists" ;;
  download) [ -e "$PLACE/lists" ] && touch "$2_9.1_amd64.deb" ;;
  install) shift; for package; do echo "$package" >>"$PLACE/installed"; done ;;
esac
END
  cat >"$place/fakes/dpkg-deb" <<'END'
#!/bin/sh
[ -e "$2" ] && mkdir -p "$3/usr/include/vtk-9.1" && touch "$3/usr/include/vtk-9.1/vtkVersion.h"
END
  cat >"$place/fakes/cp" <<'END'
#!/bin/sh
[ "$2" = /usr/include/vtk-9.1 ] && mkdir "$3/vtk-9.1" && touch "$3/vtk-9.1/vtkVersion.h"
END
  printf '#!/bin/sh\necho 0\n' >"$place/fakes/id"
  chmod +x "$place"/fakes/*
}

# A project whose program is copied; the glob is there because CMake's tests have one too.
make_project() {
  rm -rf "$place/project" "$place/calls" "$place/offline" "$place/installed" "$place/lists"
  mkdir "$place/project"
  command cp "$source/qs" "$source/CMakePresets.json" "$place/project"
  printf '%s\n' g++ libvtk9.1 'libvtk9-dev  # headers' gnuplot-nox >"$place/project/packages.txt"
  printf '#!/bin/sh\necho "ran $*"\n' >"$place/project/program.sh"
  chmod +x "$place/project/program.sh"
  cat >"$place/project/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(one_file LANGUAGES NONE)
file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/*.sh)
if(NOT EXISTS ${CMAKE_SOURCE_DIR}/build/vtk/vtkVersion.h)
  message(FATAL_ERROR "no headers of VTK")
endif()
add_custom_command(OUTPUT bin/copied DEPENDS ${sources}
  COMMAND cmake -E copy ${sources} bin/quicksand COMMAND cmake -E touch bin/copied)
add_custom_target(quicksand DEPENDS bin/copied)
END
  touch "$place/calls" "$place/lists"
  installed_are "$@"
}

installed_are() { printf '%s\n' "$@" >"$place/installed"; }

# What ./qs says on both channels; $? is its exit code.
call_qs() { PLACE=$place PATH="$place/fakes:$PATH" "$place/project/qs" "$@" 2>&1; }

fail() {
  printf 'FAILED: %s: %s\n' "${FUNCNAME[2]}" "$*"
  exit 1
}

expect_runs() {
  local said
  said=$(call_qs version) || fail "ends with $?: $said"
  [ "$(tail -n 1 <<<"$said")" = 'ran version' ] || fail "says: $said"
}

expect_calls() {
  local calls
  calls=$(cat "$place/calls")
  [ "$calls" = "$1" ] || fail "calls: '$calls' instead of '$1'"
  : >"$place/calls"
}

paraview_first() {
  make_project g++ paraview python3-paraview
  expect_runs
  expect_calls 'apt-get update
apt-get install --yes --no-remove --no-install-recommends libvtk9.1 gnuplot-nox
apt-get download libvtk9-dev'
}

paraview_later() {
  make_project g++ libvtk9.1 libvtk9-dev gnuplot-nox
  expect_runs
  installed_are g++ libvtk9.1 gnuplot-nox paraview python3-paraview
  expect_runs
  echo '# changed' >>"$place/project/program.sh"
  expect_runs
  grep -q changed "$place/project/build/release/bin/quicksand" || fail 'the change is not built'
  expect_calls ''
}

up_to_date_installs_nothing() {
  make_project g++ libvtk9.1 gnuplot-nox
  expect_runs
  : >"$place/calls"
  installed_are nothing
  touch "$place/offline"
  expect_runs
  [ "$(call_qs version)" = 'ran version' ] || fail "builds what is up to date: $(call_qs version)"
  expect_calls ''
}

new_package_is_installed() {
  make_project g++ libvtk9.1 gnuplot-nox
  expect_runs
  echo ninja-build >>"$place/project/packages.txt"
  : >"$place/calls"
  expect_runs
  expect_runs
  expect_calls 'apt-get update
apt-get install --yes --no-remove --no-install-recommends ninja-build'
}

old_package_lists_are_renewed() {
  make_project g++ libvtk9.1 gnuplot-nox
  rm "$place/lists"
  expect_runs
  expect_calls 'apt-get download libvtk9-dev
apt-get update
apt-get download libvtk9-dev'
}

headers_out_of_reach() {
  make_project g++ libvtk9.1 gnuplot-nox python3-paraview
  touch "$place/offline"
  local said
  said=$(call_qs version) && fail "goes on: $said"
  for words in "VTK's headers are missing" "apt-get update" "dpkg-deb --extract libvtk9-dev"; do
    grep -q -e "$words" <<<"$said" || fail "does not say '$words': $said"
  done
  # what it says to do
  local part="$place/project/build/vtk.part"
  mkdir -p "$part/usr/include/vtk-9.1"
  touch "$part/usr/include/vtk-9.1/vtkVersion.h"
  mv "$part/usr/include/vtk-9.1" "$place/project/build/vtk"
  expect_runs
}

packages_out_of_reach() {
  make_project g++ libvtk9-dev
  touch "$place/offline"
  local said
  said=$(call_qs version) && fail "goes on: $said"
  grep -q -e 'apt-get install --no-install-recommends libvtk9.1 gnuplot-nox' <<<"$said" || fail "says: $said"
}

make_fakes
for question in paraview_first paraview_later up_to_date_installs_nothing new_package_is_installed \
  old_package_lists_are_renewed headers_out_of_reach packages_out_of_reach; do
  "$question"
  echo "good: $question"
done
