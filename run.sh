#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and runs the paper's first test case. Arguments go to `aneurysm run`.
set -eu
cd "$(dirname "$0")"

cmake/install_dependencies.sh cmake/dependencies
cmake --preset release --log-level=WARNING >/dev/null
cmake --build --preset release --target aneurysm_programs -- --quiet

out=results/paper_tc1
n=2
while [ -e "$out" ]; do
    out=results/paper_tc1-$n
    n=$((n + 1))
done
exec build/release/verification/aneurysm run data/scenarios/paper_tc1.json --out "$out" "$@"
