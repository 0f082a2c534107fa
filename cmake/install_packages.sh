#!/usr/bin/env bash
# Installs those of the given Debian packages that are missing: install_packages.sh PACKAGE…
set -euo pipefail

say() { printf 'dev: %s\n' "$*" >&2; }

if ! command -v dpkg >/dev/null || ! command -v apt-get >/dev/null; then
  say "this is not Debian: please install by hand what ${*} are there (not checked)"
  exit 0
fi
missing=()
for package in "$@"; do
  dpkg -s "$package" 2>/dev/null | grep -q '^Status: install ok installed' || missing+=("$package")
done
((${#missing[@]} == 0)) && exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    say "these packages are missing and neither root nor sudo is at hand; as root run: apt-get install ${missing[*]}"
    exit 1
  fi
  as_root=(sudo)
fi
say "installing with apt-get, once, what the build needs: ${missing[*]}"
log="$(mktemp)"
if ! { "${as_root[@]}" apt-get update && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  tail -n 15 "$log" >&2
  say "apt-get failed (no network? not Debian 12?); the whole log is in $log"
  exit 1
fi
rm -f "$log"
