#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and runs all tests: release, then under the sanitizers the unit tests that work on
# memory of their own, then the style. With --tidy also clang-tidy over all sources (minutes).
set -eu
cd "$(dirname "$0")"

tidy=no
case "${1-}" in
'') ;;
--tidy) tidy=yes ;;
*)
    echo "usage: ./test.sh [--tidy]" >&2
    exit 2
    ;;
esac

quiet=--quiet
if [ -t 1 ]; then quiet=; fi # ninja shows how far it is

cmake/install_dependencies.sh cmake/dependencies cmake/dependencies-test
for preset in release sanitize; do
    echo "== $preset"
    cmake --preset $preset --log-level=WARNING >/dev/null
    case $preset in
    release)
        cmake --build --preset $preset -- $quiet
        ctest --preset $preset
        ;;
    sanitize)
        cmake --build --preset $preset --target aneurysm_unit_tests -- $quiet
        ctest --preset $preset --label-exclude long
        ;;
    esac
done

echo "== style"
git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 --dry-run -Werror
if [ $tidy = yes ]; then
    git ls-files '*.cpp' | xargs -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p build/release
fi
echo "All tests passed."
