#!/usr/bin/env bash
# What server/run, tests/run and the Dockerfile share: packages, configuring, building.
# Sourced by the first two; the Dockerfile calls `docker/toolchain.sh install SECTION...`.
set -euo pipefail

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
export CCACHE_DIR="${CCACHE_DIR:-${XDG_CACHE_HOME:-${HOME:-$root/build}/.cache}/ccache}"
export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$root}" CCACHE_NOHASHDIR="${CCACHE_NOHASHDIR:-1}"

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "error: $*"
  exit 1
}

# Lines "package [command]" of the named sections of the list.
packages_of() {
  local section
  for section in "$@"; do
    grep -qx "\[$section\]" "$root/docker/packages.txt" || fail "no section [$section] in the list"
    awk -v wanted="[$section]" '
      /^[[:space:]]*(#|$)/ { next }
      /^\[/ { inside = ($0 == wanted); next }
      inside' "$root/docker/packages.txt"
  done | sort -u
}

missing_packages() {
  local package command
  packages_of "$@" | while read -r package command; do
    [ -n "$command" ] && command -v "$command" >/dev/null 2>&1 && continue
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed ||
      printf '%s\n' "$package"
  done
}

# Installs what the named sections lack. Needs neither root nor network where nothing is missing.
install_packages() {
  command -v dpkg-query >/dev/null 2>&1 ||
    fail "this is not Debian: install what docker/packages.txt names, then build with cmake"
  local missing
  missing="$(missing_packages "$@" | tr '\n' ' ')"
  [ -n "$missing" ] || return 0
  local -a as_root=(env)
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null 2>&1 ||
      fail "these packages are missing and neither root nor sudo is at hand: apt-get install $missing"
    as_root=(sudo env)
  fi
  say "installing: $missing"
  local -a apt=("${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -q -y
    -o Acquire::Retries=3 -o Dpkg::Use-Pty=0)
  local log
  log="$(mktemp)"
  # shellcheck disable=SC2086  # a list of names
  if ! { "${apt[@]}" update && "${apt[@]}" install --no-install-recommends $missing; } \
    >"$log" 2>&1 </dev/null; then
    tail -n 30 "$log" >&2
    rm -f "$log"
    fail "apt-get could not install: $missing"
  fi
  rm -f "$log"
}

# Configures build/PRESET if that was not done, was done for another folder, or with older presets.
configure() {
  local preset="$1" build="$root/build/$1" log
  if [ -f "$build/CMakeCache.txt" ] &&
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    rm -rf "$build"
  fi
  if [ -f "$build/build.ninja" ] && [ "$build/build.ninja" -nt "$root/CMakePresets.json" ]; then
    return 0
  fi
  say "configuring: build/$preset"
  mkdir -p "$build"
  log="$build/configure.log"
  if ! (cd "$root" && cmake --preset "$preset") >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    fail "cmake could not configure the preset $preset"
  fi
}

# build PRESET [TARGET...]: progress on a terminal. Elsewhere a word before the first build, then only
# what goes wrong: `server/run post` has its report on stderr. All on stderr.
build() {
  local preset="$1" log
  shift
  configure "$preset"
  if [ -t 2 ] || [ ! -e "$root/build/$preset/.ninja_log" ]; then
    say "building: build/$preset${*:+ ($*)}"
  fi
  if [ -t 2 ]; then
    ninja -C "$root/build/$preset" "$@" >&2 </dev/null || fail "the build in build/$preset failed"
    return
  fi
  log="$root/build/$preset/build.log"
  if ! ninja -C "$root/build/$preset" --quiet "$@" >"$log" 2>&1 </dev/null; then
    cat "$log" >&2
    fail "the build in build/$preset failed"
  fi
}

if [ "${BASH_SOURCE[0]}" = "$0" ]; then
  if [ "${1:-}" != install ] || [ "$#" -lt 2 ]; then
    fail "usage: docker/toolchain.sh install SECTION..."
  fi
  shift
  install_packages "$@"
fi
