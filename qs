#!/usr/bin/env bash
# Install what is missing, build what is out of date, then run:
#   ./qs test [ctest options]   build and run all tests
#   ./qs COMMAND ...            any command of the program quicksand; ./qs --help lists them
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
build="$root/build/release"

say() { printf '%s\n' "$*" >&2; }

listed_packages() { sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$root/packages.txt"; }

missing_packages() {
  local package
  for package in $(listed_packages); do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || printf '%s ' "$package"
  done
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
  if ! command -v dpkg-query >/dev/null; then
    [ -d "$build" ] || say "qs: this is no Debian system; what packages.txt names must be installed by hand."
    return
  fi
  local missing
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "qs: these packages are missing and sudo is not there to install them. As root:"
      say "    apt-get install --no-install-recommends $missing"
      return 1
    fi
    as_root=(sudo)
  fi
  say "Installing Debian packages: $missing"
  # Names are separate words on purpose.
  # shellcheck disable=SC2086
  run_logged "$root/build/install.log" "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive bash -c \
    'apt-get update && apt-get install --yes --no-install-recommends "$@"' install $missing
}

build_targets() {
  if [ ! -f "$build/build.ninja" ]; then
    run_logged "$root/build/configure.log" cmake -S "$root" --preset release
  fi
  if ninja -C "$build" -n "$@" 2>/dev/null | grep -q 'no work to do'; then return; fi
  say "Building $* ..."
  run_logged "$root/build/build.log" cmake --build "$build" --parallel "$(nproc)" --target "$@"
}

# One at a time: the lock is held while installing and building only.
prepare() {
  mkdir -p "$root/build"
  (
    flock 9
    install_packages
    cd "$root"
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
