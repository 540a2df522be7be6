# SPDX-License-Identifier: Apache-2.0
"""run.sh: what it says and takes, in a copy of the project whose build does nothing or fails, with the program that is
built already.

usage: check_run_sh.py PROGRAM DATA
"""
import os
import shutil
import signal
import subprocess
import time

import program
from program import data, expect, read_json

project = data.parent
fast = ["--backend", "cpu", "--precision", "float", "--threads", "1"]


def copy_of(scratch, cmake="exit 0"):
    """The project in a folder of a difficult name; `cmake`: what stands for it."""
    copy = scratch / "a copy's"
    (copy / "build/release/bin").mkdir(parents=True)
    (copy / "build/release/bin/aneurysm").symlink_to(program.program)
    (copy / "data").symlink_to(data)
    (copy / "output").symlink_to(project / "output")
    shutil.copy(project / "run.sh", copy)
    (copy / "cmake").mkdir()
    for name, text in (("cmake/install_dependencies.sh", "exit 0"), ("cmake/configure.sh", "exec cmake"), ("cmake/cmake", cmake)):
        (copy / name).write_text("#!/bin/sh\n" + text + "\n")
        (copy / name).chmod(0o755)
    return copy


def start(copy, *arguments, **settings):
    environment = dict(os.environ, PATH=f"{copy}/cmake:{os.environ['PATH']}")
    return subprocess.Popen(["sh", copy / "run.sh", *map(str, arguments)], cwd=copy.parent, env=environment, text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **settings)


def run(copy, *arguments, code=0):
    process = start(copy, *arguments)
    out, err = process.communicate()
    expect(process.returncode == code, f"run.sh {arguments}: exit code {process.returncode} instead of {code}: {out}{err}")
    return out, err


def check_arguments(scratch):
    copy = copy_of(scratch)
    for number, out in enumerate((["--out", "mine"], ["--out=slash/"], ["--out", scratch / "in/a new place"], [])):
        text, _ = run(copy, *fast, "--frames", number + 1, *out)
        directory = scratch / ("mine", "slash", "in/a new place", copy / "results/paper_tc1")[number]
        expect(read_json(directory / "manifest.json")["frames"] == number + 1, f"{out}: frames expected: {text}")
        expect((directory / "run.png").stat().st_size > 1000 and f"{directory.name}/run.png" in text, f"a picture: {text}")
        commands = text.split("Next:\n")[1].splitlines()
        expect(len(commands) == 3 and all("build/release/bin/aneurysm" in c for c in commands), f"three commands: {text}")
    text, _ = run(copy, *fast, "--frames", 1)
    expect("results/paper_tc1-2" in text, f"another directory expected: {text}")


def check_refusals(scratch):
    copy = copy_of(scratch, "echo built >built")
    (scratch / "there").mkdir()
    for arguments, said in (("--out there", "exists"), ("--out=", "empty"), ("--fames 3", "--fames"), ("--frames", "no value"),
                            ("--frames 0", "at least 1"), ("--frames -3", "-3"), ("--frames 3.5", "whole number"),
                            ("--frames 99999999999", "nine digits"), ("--frames 3 --frames 4", "twice"), ("my.json", "my.json"),
                            ("--precision float", "--backend cpu"), ("--backend gpu", "reference, cpu, cuda"),
                            ("--threads 2", "--backend cpu"), ("--resume", "--resume")):
        text, error = run(copy, *arguments.split(), code=2)
        expect(said in error and error.count("\n") == 1 and not text, f"{arguments}: '{said}' expected: {text}{error}")
    expect("--frames N" in run(copy, "--help")[0], "--help expected")
    expect(not (copy / "built").exists(), "no build for bad arguments expected")


def check_building(scratch):
    """A line every 20 s while nothing else is to be seen, and what a failed build said."""
    copy = copy_of(scratch, 'case $1 in --build) echo "[7/9] Building"; sleep 22; echo broken; exit 1;; esac')
    text, error = run(copy, code=1)
    expect("[7/9]" in text and "broken" in error, f"progress, and what failed expected: {text}{error}")
    expect("running" not in text, f"no run after a failed build expected: {text}")


def check_interruption(scratch):
    """What ends run.sh ends the run, which writes a checkpoint, also where the signal reaches both of them."""
    copy = copy_of(scratch)
    for name, send in (("mine", os.kill), ("ours", os.killpg)):
        process = start(copy, *fast, "--out", name, start_new_session=True)
        frames = scratch / name / "frames.csv"
        while process.poll() is None and not (frames.exists() and frames.read_text().count("\n") > 3):
            time.sleep(0.02)
        send(process.pid, signal.SIGTERM)
        _, error = process.communicate()
        expect(process.returncode == 130 and "--resume" in error, f"{name}, interrupted: {process.returncode}: {error}")
        expect((scratch / name / "checkpoint.h5").exists(), f"{name}: a checkpoint expected")


program.check_all(check_arguments, check_refusals, check_building, check_interruption)
