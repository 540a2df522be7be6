#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and runs the paper's first test case. Arguments go to `aneurysm run`.
set -eu
cd "$(dirname "$0")"

quiet=--quiet
if [ -t 1 ]; then quiet=; fi # ninja shows how far it is

cmake/install_dependencies.sh cmake/dependencies
echo "== building: ten minutes at first, on two cores"
cmake/configure.sh release
cmake --build --preset release --target aneurysm_programs -- $quiet

out=results/paper_tc1
n=2
while [ -e "$out" ]; do
    out=results/paper_tc1-$n
    n=$((n + 1))
done
exec build/release/bin/aneurysm run data/scenarios/paper_tc1.json --out "$out" "$@"
