#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the packages of the given lists that are missing, where this user may; else says which they are and what for.
# Ends with 0 in either case: a library may be there without Debian's package, as a module or in an environment, and
# CMake finds out.
set -u

lists=$(grep -hv '^#' "$@")
say() { echo "install_dependencies.sh: $*" >&2; }
names() { cut -d: -f1 | tr '\n' ' '; }
# The lines of the lists whose package isn't installed, and whose program isn't here by another way.
missing_lines() {
    echo "$lists" | while read -r line; do
        package=${line%%:*}
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
            command -v "${package%-build}" >/dev/null || echo "$line"
    done
}
# apt-get, as root; 1 where this user can't be.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    else
        # Without a terminal nobody types a password.
        command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; } && sudo "$@"
    fi
}

missing=$(missing_lines)
[ -n "$missing" ] || exit 0
if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "no apt here, so nothing is installed, and what is there isn't known. By Debian's names,"
    say "needed: $(echo "$missing" | grep -v : | names)"
    say "of use: $(echo "$missing" | grep : | names)"
    exit 0
fi
if as_root apt-get update -qq; then
    # A package that this system's archive doesn't have would stop the others.
    # shellcheck disable=SC2046 # one word a package
    there=$(apt-cache policy $(echo "$missing" | names) |
        awk '/^[^ ]/ { name = $1 } /Candidate:/ && $2 != "(none)" { sub(/:$/, "", name); print name }' | names)
    if [ -n "$there" ]; then
        echo "Installing: $there"
        # shellcheck disable=SC2086
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $there >/dev/null ||
            say "apt-get could not install them; its words are above"
        missing=$(missing_lines)
    fi
else
    say "not root, or apt-get has no archive here: nothing is installed"
fi
needed=$(echo "$missing" | sed '/^$/d; /:/d' | names)
[ -z "$needed" ] || say "missing, and needed unless it is here by another way: $needed"
echo "$missing" | grep : | while read -r line; do say "missing, so left out: $line"; done
exit 0
