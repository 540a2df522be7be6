#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Everything that only a GPU can show, in one call:
#
#     verification/gpu_check.sh OUT [BUILD [PART...]]
#
# OUT: directory for the record, gpu_check.txt; BUILD: a build directory (default: build/release); PART: some of
# suite bits lockstep resume free tools timing (default: all). Runs all checks, also after one has failed; the last lines of
# the record say which did, and so does the exit code: 0 none, 1 some.
set -u
[ $# -ge 1 ] || {
    echo "usage: verification/gpu_check.sh OUT [BUILD [PART...]]" >&2
    exit 2
}
root=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1" && out=$(cd "$1" && pwd) || exit 2
build=$(cd "${2:-$root/build/release}" && pwd) || exit 2
cd "$root" || exit 2
if [ $# -gt 2 ]; then
    shift 2
    parts=" $* "
else
    parts=" suite bits lockstep resume free tools timing "
fi

aneurysm=$build/bin/aneurysm
bench=$build/bin/bench_frames
quick=data/scenarios/quick.json
tc1=data/scenarios/paper_tc1.json
record=$out/gpu_check.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
: >"$record"
checks=0
failed=

say() {
    echo "$*" | tee -a "$record"
}
# Only for the record.
note() {
    say "-- $*"
    "$@" >>"$record" 2>&1 || say "   (failed, or not there: $1)"
}
wanted() {
    case "$parts" in *" $1 "*) return 0 ;; esac
    return 1
}
# check NAME COMMAND...: fails when the command does.
check() {
    name=$1
    shift
    checks=$((checks + 1))
    say "== $name: $*"
    start=$(date +%s)
    if "$@" >"$work/output" 2>&1; then verdict=passed; else
        verdict="FAILED with exit code $?"
        failed="$failed
   $name"
    fi
    cat "$work/output" >>"$record"
    [ "$verdict" = passed ] || tail -n 15 "$work/output"
    say "   $name: $verdict, $(($(date +%s) - start)) s"
}
# compare SCENARIO PRECISION MODE FRAMES BLOCK
compare() {
    check "$3 $(basename "$1" .json) $2, blocks of $5" \
        "$aneurysm" compare "$1" --candidate cuda --precision "$2" --mode "$3" --frames "$4" --block-size "$5"
}
# A run that stops and goes on has the hashes of an uninterrupted one on the CPU.
same_hashes() {
    "$aneurysm" run $quick --backend cuda --precision "$1" --frames 60 --out "$work/gpu_$1" &&
        "$aneurysm" run --resume --backend cuda --precision "$1" --out "$work/gpu_$1" --frames 120 &&
        "$aneurysm" run $quick --backend cpu --precision "$1" --frames 120 --out "$work/cpu_$1" &&
        cmp "$work/gpu_$1/hashes.csv" "$work/cpu_$1/hashes.csv"
}
# Alone on the machine, or it says nothing. The benchmark itself doesn't fail where there is no GPU.
frames_per_second() {
    "$bench" data --benchmark_filter='frames/.*/cuda' --table "$out/bench_frames.md" &&
        grep -q cuda "$out/bench_frames.md" && ! grep 'not run' "$out/bench_frames.md"
}

say "GPU check, $(date -u +%Y-%m-%dT%H:%M:%SZ), parts:$parts"
note nvidia-smi --query-gpu=name,driver_version,memory.total,compute_cap,clocks.max.sm,power.limit --format=csv
note nvidia-smi
note lscpu
note git describe --always --dirty --abbrev=40 --exclude='*'
note "$aneurysm" info
note cuobjdump --dump-resource-usage "$aneurysm"

if wanted suite; then
    rm -rf "$out/suite"
    check "suite" "$aneurysm" verify --full --backend cuda --out "$out/suite"
    check "baseline" "$aneurysm" verify --baseline --backend cuda --out "$work/baseline"
fi
for precision in float double; do
    if wanted bits; then
        for block in 0 32 64 96 128 256; do
            compare $quick $precision bits 400 $block
        done
        for again in 2 3; do
            say "Again, time $again:"
            compare $quick $precision bits 400 0
        done
        compare $tc1 $precision bits 500 0
    fi
    if wanted lockstep; then
        compare $quick $precision lockstep 400 0
        compare $tc1 $precision lockstep 100 0
    fi
    if wanted resume; then
        check "resumed run $precision" same_hashes $precision
    fi
done
if wanted free; then
    compare $quick float free 400 0
fi
if wanted tools; then
    # Slow, so few frames; where the tool isn't installed the check fails and says so.
    for tool in memcheck racecheck synccheck; do
        check "$tool" compute-sanitizer --tool $tool --error-exitcode 9 "$aneurysm" run $quick --backend cuda \
            --precision float --frames 3 --out "$work/$tool"
    done
fi
if wanted timing; then
    check "frames per second" frames_per_second
fi

say "$checks checks, $(printf '%s' "$failed" | grep -c .) failed:${failed:- none}"
[ -z "$failed" ]
