#!/usr/bin/env bash
# Build what is out of date, with the packages that are missing for it, then run:
#   ./qs test [ctest options]   build and run all tests
#   ./qs COMMAND ...            any command of the program quicksand; ./qs --help lists them
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
build="$root/build/release"

say() { printf '%s\n' "$*" >&2; }

# Of this package only VTK's headers are taken (see packages.txt): installed, it excludes Debian's ParaView.
headers_package=libvtk9-dev
headers="$root/build/vtk"

packages_to_install() { sed -e 's/[[:space:]]*#.*//' -e '/^$/d' -e "/^$headers_package\$/d" "$root/packages.txt"; }

installed() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'; }

missing_packages() {
  local package
  for package in $(packages_to_install); do
    installed "$package" || printf '%s ' "$package"
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# Run a command with its output in a log that is shown only when the command fails.
run_logged() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 80 "$log" >&2
    say "qs: failed: $*"
    say "qs: the whole log is in $log"
    return 1
  fi
}

install_packages() {
  local missing log="$root/build/install.log"
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  say "Installing Debian packages: $missing"
  # Names are separate words on purpose.
  # shellcheck disable=SC2086
  if ! as_root env DEBIAN_FRONTEND=noninteractive bash -c \
    'apt-get update && apt-get install --yes --no-remove --no-install-recommends "$@"' install $missing >"$log" 2>&1; then
    tail -n 3 "$log" >&2
    say "qs: packages are missing and could not be installed; $log says why. Install them as root:"
    say "    apt-get install --no-install-recommends $missing"
    return 1
  fi
}

# Into the folder $1. Where the package is installed they are copied, for ParaView may still remove it.
get_headers() (
  cd "$1" || return
  if installed "$headers_package"; then
    mkdir -p usr/include && cp -r /usr/include/vtk-9.1 usr/include
  else
    apt-get download "$headers_package" || { as_root apt-get update && apt-get download "$headers_package"; } || return
    dpkg-deb --extract "$headers_package"_*.deb .
  fi
)

fetch_headers() {
  [ ! -d "$headers" ] || return 0
  local folder="$headers.part" log="$root/build/headers.log"
  rm -rf "$folder"
  mkdir "$folder"
  say "Fetching VTK's headers from $headers_package"
  if ! get_headers "$folder" >"$log" 2>&1; then
    tail -n 3 "$log" >&2
    say "qs: VTK's headers are missing and could not be fetched; $log says why. With Debian's mirror"
    say "    in reach and its lists renewed (as root: apt-get update) call ./qs again. Without it, bring the file of"
    say "    $headers_package here, and call ./qs after"
    say "    dpkg-deb --extract $headers_package*.deb $folder && mv $folder/usr/include/vtk-9.1 $headers"
    return 1
  fi
  mv "$folder/usr/include/vtk-9.1" "$headers"
  rm -rf "$folder" "$build/build.ninja"
}

prepare_packages() {
  if command -v dpkg-query >/dev/null; then
    install_packages
    fetch_headers
  elif [ ! -d "$build" ]; then
    say "qs: this is no Debian system; what packages.txt names must be installed by hand."
  fi
}

# A dry run wants to renew build.ninja first, always where there are globs, and stops there. So that is done beforehand, and
# the dry run reads the file by another name.
up_to_date() {
  [ "$build/build.ninja" -nt "$root/packages.txt" ] && ninja -C "$build" build.ninja >/dev/null 2>&1 &&
    ninja -C "$build" -f "$build/build.ninja" -n "$@" 2>/dev/null | grep -q 'no work to do'
}

build_targets() {
  if [ ! "$build/build.ninja" -nt "$root/packages.txt" ]; then
    run_logged "$root/build/configure.log" cmake -S "$root" --preset release
  fi
  say "Building $* ..."
  run_logged "$root/build/build.log" cmake --build "$build" --parallel "$(nproc)" --target "$@"
}

# One at a time: the lock is held while installing and building only. What is up to date needs no packages.
prepare() {
  mkdir -p "$root/build"
  (
    flock 9
    cd "$root"
    up_to_date "$@" && exit
    prepare_packages
    build_targets "$@"
  ) 9>"$root/build/.lock"
}

if [ "${1:-}" = test ]; then
  shift
  prepare all
  cd "$root"
  exec ctest --preset release "$@"
fi
prepare quicksand
if [ $# -eq 0 ]; then set -- --help; fi
exec "$build/bin/quicksand" "$@"
