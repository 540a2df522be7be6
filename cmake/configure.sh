#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# usage: cmake/configure.sh PRESET [OPTION...]     sets a build up, and says what is left out of it, or what there is to do
set -u
preset=$1
shift
command -v cmake >/dev/null || {
    echo "cmake is not here; needed: CMake 3.25 or later, Ninja, a C++20 compiler and the packages named above" >&2
    exit 1
}
words=$(mktemp)
trap 'rm -f "$words"' EXIT
cmake --preset "$preset" --log-level=STATUS "$@" >"$words" || {
    echo "The build can't be set up: CMake says above what it didn't find. A library in a folder of its own is named by" >&2
    echo "CMAKE_PREFIX_PATH=FOLDER in the environment; docs/install.md names other ways to the packages." >&2
    exit 1
}
sed -n 's/^-- \(Left out: .*\)/\1/p' "$words"
