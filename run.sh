#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, runs the paper's first test case and draws it. --help says what may be chosen.
set -eu

usage() {
    cat <<'END'
usage: ./run.sh [--out DIR] [--frames N] [--backend reference|cpu|cuda] [--precision float|double] [--threads N]

Installs what is missing, builds, runs the paper's first test case (data/scenarios/paper_tc1.json) and draws it.
  --out DIR      where the results go; must not exist (default: results/paper_tc1, or results/paper_tc1-2, ...)
  --frames N     up to this frame (default: all 3000)
  --backend B    who computes (default: reference, the plain one; cpu is the fast one)
  --precision P  of the backends cpu and cuda (default: double)
  --threads N    of the backend cpu (default: as many as pay)
For a scenario of your own: build/release/bin/aneurysm run SCENARIO.json, after ./run.sh has built it.
END
}

refuse() {
    echo "run.sh: $*; see ./run.sh --help (nothing was installed or built)" >&2
    exit 2
}

one_of() { # VALUE WORD...: whether the value is one of the words
    value_=$1
    shift
    for word in "$@"; do
        [ "$value_" != "$word" ] || return 0
    done
    return 1
}

# What is wrong with the arguments is said now, not after ten minutes.
start=$(pwd)
cd -- "$(dirname -- "$0")"
out='' backend=reference precision=double threads='' seen=' '
left=$#
while [ "$left" -gt 0 ]; do
    option=$1
    shift
    left=$((left - 1))
    case $option in
    -h | --help)
        usage
        exit 0
        ;;
    --*=*)
        value=${option#*=}
        option=${option%%=*}
        ;;
    --*)
        [ "$left" -gt 0 ] || refuse "$option: no value, or no such option"
        value=$1
        shift
        left=$((left - 1))
        ;;
    *) refuse "$option: it runs the paper's first test case only" ;;
    esac
    case $seen in *" $option "*) refuse "$option: given twice" ;; esac
    seen="$seen$option "
    case $option in
    --out)
        [ -n "$value" ] || refuse "--out: empty name"
        case $value in /*) out=$value ;; *) out=$start/$value ;; esac
        while [ "${out%/}" != "$out" ]; do out=${out%/}; done
        continue
        ;;
    --backend) one_of "$value" reference cpu cuda || refuse "--backend: $value; allowed: reference, cpu, cuda" ;;
    --precision) one_of "$value" float double || refuse "--precision: $value; allowed: float, double" ;;
    --frames | --threads)
        case $value in
        '' | *[!0-9]* | ??????????*) refuse "$option: $value; allowed: a whole number with up to nine digits" ;;
        esac
        case $value in *[1-9]*) ;; *) refuse "$option: $value; allowed: at least 1" ;; esac
        ;;
    *) refuse "$option: no such option" ;;
    esac
    case $option in
    --backend) backend=$value ;;
    --precision) precision=$value ;;
    --threads) threads=$value ;;
    esac
    set -- "$@" "$option" "$value"
done
[ "$backend" != reference ] || [ "$precision" = double ] || refuse "--precision: the reference has double only; add --backend cpu"
[ "$backend" = cpu ] || [ -z "$threads" ] || refuse "--threads: $backend has no threads to choose; add --backend cpu"
[ "$backend" != cuda ] || command -v nvidia-smi >/dev/null || refuse "--backend: cuda needs a GPU with NVIDIA's driver (no nvidia-smi here)"

if [ -n "$out" ]; then
    [ ! -e "$out" ] || refuse "--out: $out exists; needed: a name that doesn't exist yet"
    mkdir -p -- "$(dirname -- "$out")" || refuse "--out: $out: its folder cannot be made"
else
    out=results/paper_tc1 n=2
    while [ -e "$out" ]; do
        out=results/paper_tc1-$n
        n=$((n + 1))
    done
fi

# begin WHAT: says it, and every 20 s that it goes on, where no terminal shows that; end stops the latter.
log=build/run.log
mkdir -p build
beat=
begin() {
    echo "== $1"
    : >"$log"
    [ -t 1 ] || {
        (
            trap 'kill "$pause"; exit' TERM
            while :; do
                sleep 20 >/dev/null 2>&1 &
                pause=$!
                wait "$pause"
                echo "   $(date +%H:%M:%S) $1 $(sed -n 's/^\(\[[0-9]*\/[0-9]*\]\).*/\1/p' "$log" | tail -n 1)"
            done
        ) &
        beat=$!
    }
}
end() {
    [ -z "$beat" ] || kill "$beat"
    beat=
}
trap end EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

begin "looking for packages, installing what is missing"
cmake/install_dependencies.sh cmake/dependencies
end
begin "building: ten minutes at first, on two cores"
cmake/configure.sh release
if [ -t 1 ]; then # ninja shows how far it is
    cmake --build --preset release --target aneurysm_programs
else
    cmake --build --preset release --target aneurysm_programs >"$log" 2>&1 || {
        cat "$log" >&2
        exit 1
    }
fi
end

echo "== running the paper's first test case, into $out"
# In the background, so that what ends this script ends the run, too, which then writes a checkpoint. A background process
# ignores Ctrl-C unless told otherwise.
env --default-signal=INT true 2>/dev/null && clean='env --default-signal=INT' || clean=
$clean build/release/bin/aneurysm run data/scenarios/paper_tc1.json --out "$out" "$@" <&0 &
run=$!
trap : INT
trap 'kill -USR1 "$run"' TERM HUP # which may have reached the run already: a second SIGTERM would end it at once
code=0
wait "$run" || code=$?
while kill -0 "$run" 2>/dev/null; do # a signal ended the waiting
    code=0
    wait "$run" || code=$?
done
[ "$code" = 0 ] || exit "$code"

# A python3 of one's own, first in the path, may lack the packages that Debian's has.
python=
for name in python3 /usr/bin/python3; do
    [ -n "$python" ] || ! $name -c 'import matplotlib, h5py' 2>/dev/null || python=$name
done
if [ -z "$python" ]; then
    echo "== no picture: output/plot_run.py needs python3-matplotlib and python3-h5py"
elif picture=$($python -B output/plot_run.py "$out"); then
    echo "== picture: $picture"
else
    echo "== no picture: output/plot_run.py says above why"
fi
cat <<END
Next:
  build/release/bin/aneurysm verify --out results/verify     # does it compute what the equations say? (half a minute)
  build/release/bin/aneurysm run data/scenarios/quick.json --backend cpu --precision float    # another run, by the fast backend
  build/release/bin/aneurysm info data/scenarios/paper_tc1.json                # what follows from a scenario; write your own: README
END
