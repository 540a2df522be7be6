#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and runs all tests: release, then under the sanitizers the unit tests that work on
# memory of their own, half a minute of fuzzing, then the style. With --tidy also clang-tidy over all sources (minutes). Where the
# sanitizers, clang with libFuzzer or this project's version of clang-format aren't, their part is skipped with a word.
# ANEURYSM_WERROR=ON in the environment makes warnings errors.
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
skipped=
skip() {
    echo "== skipped: $*"
    skipped="$skipped
   $*"
}

cmake/install_dependencies.sh cmake/dependencies cmake/dependencies-test
echo "== release"
cmake/configure.sh release ${ANEURYSM_WERROR:+"-DANEURYSM_WERROR=$ANEURYSM_WERROR"}
cmake --build --preset release -- $quiet
ctest --preset release

if echo 'int main() {}' | "${CXX:-c++}" -x c++ -fsanitize=address,undefined -o /dev/null - 2>/dev/null; then
    echo "== sanitize"
    cmake/configure.sh sanitize ${ANEURYSM_WERROR:+"-DANEURYSM_WERROR=$ANEURYSM_WERROR"}
    cmake --build --preset sanitize --target aneurysm_unit_tests -- $quiet
    ctest --preset sanitize --label-exclude long
else
    skip "the sanitizers: ${CXX:-c++} can't link them here"
fi

if echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    clang++ -x c++ -fsanitize=fuzzer,address,undefined -o /dev/null - 2>/dev/null; then
    echo "== fuzz"
    cmake/configure.sh fuzz ${ANEURYSM_WERROR:+"-DANEURYSM_WERROR=$ANEURYSM_WERROR"}
    cmake --build --preset fuzz -- $quiet
    ctest --preset fuzz
else
    skip "fuzzing: it takes clang with libFuzzer"
fi

# tool NAME: version 14 of a clang tool, whose judgement the sources are written to; another version's differs.
tool() {
    for name in "$1-14" "$1"; do
        if "$name" --version 2>/dev/null | grep -q 'version 14\.'; then
            echo "$name"
            return
        fi
    done
}
echo "== style"
sources=$(git ls-files '*.cpp' '*.hpp' 2>/dev/null) || sources=
format=$(tool clang-format)
if [ -n "$format" ] && [ -n "$sources" ]; then
    echo "$sources" | xargs "$format" --dry-run -Werror
else
    skip "the style: it takes clang-format 14, and a git checkout"
fi
if [ $tidy = yes ]; then
    format=$(tool clang-tidy)
    if [ -n "$format" ] && [ -n "$sources" ]; then
        echo "$sources" | grep '\.cpp$' | xargs -n 1 -P "$(nproc)" "$format" --quiet -p build/release
    else
        skip "clang-tidy: it takes version 14, and a git checkout"
    fi
fi
if [ -z "$skipped" ]; then
    echo "All tests passed."
else
    echo "All tests that were run passed. Skipped:$skipped"
fi
