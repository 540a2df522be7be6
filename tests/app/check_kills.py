# SPDX-License-Identifier: Apache-2.0
"""SIGKILL at random moments: of a run, of a run that goes on after a first kill, and of a reproduction, also while they
write rows, particles and checkpoints. Each goes on by the command that its user has, and must end at the bits of one that
nobody disturbed: all files but manifest.json, and the reproduction's page, byte by byte.

usage: check_kills.py PROGRAM DATA [KILLS [SEED [RECORD]]]
  KILLS   how many in all, 9 by default; two fifths of runs, two fifths of resumed runs, the others of reproductions
  RECORD  a file for what happened, as Markdown
"""
import collections
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import program
from breaks import manifest, rows, same_files, write_scenario
from program import data, expect

often = {"particles_every_frames": 5, "checkpoint_every_frames": 5}
fast = ("--backend", "cpu", "--precision", "float", "--quiet")
one_thread = {"env": {**os.environ, "OMP_NUM_THREADS": "1"}}


class Run:
    """`aneurysm run`, which `--resume` goes on with, or the same command where nothing was begun."""
    but = ("manifest.json",)

    def __init__(self, scratch, backend, frames):
        self.scenario = write_scenario(scratch / "short.json", output=often)
        self.settings = (*backend, "--frames", frames)
        self.frames = frames

    def command(self, directory):
        if (directory / "manifest.json").exists():
            return ("run", "--resume", "--out", directory, *self.settings)
        shutil.rmtree(directory, ignore_errors=True)  # killed before it began
        return ("run", self.scenario, "--out", directory, *self.settings)

    def directories(self, directory):
        return [directory]


class Reproduction:
    """`aneurysm reproduce fig9` of two short runs; the same command goes on."""
    but = ("manifest.json", "reproduction.html")
    frames = 200

    def __init__(self, scratch):
        self.data = scratch / "data"
        shutil.copytree(data, self.data)
        short = program.changed("quick.json", time={"frames": self.frames}, inlet={"cycle_s": 0.1}, output=often)
        (self.data / "scenarios/calibrated.json").write_text(json.dumps({**short, "name": "calibrated"}))

    def command(self, directory):
        return ("reproduce", "fig9", "--seeds", 2, "--jobs", 1, "--quiet", "--data", self.data, "--out", directory)

    def directories(self, directory):
        return list((directory / "runs").glob("*"))


def unfinished(work, directory):
    """Temporary files: what is being written."""
    places = [directory, *work.directories(directory)]
    places += [place / kind for place in places for kind in ("particles", "wall")]
    return [path for place in places if place.is_dir() for path in place.glob("*.tmp")]


def done(work, directory):
    """Frames that are done, of all runs."""
    return sum(rows(place) for place in work.directories(directory))


def wait(work, directory, moment, seconds, process):
    """Until the moment has come, or the process has ended."""
    kind, part = moment
    begun = time.monotonic()
    if kind == "time":
        while time.monotonic() < begun + part * seconds and process.poll() is None:
            time.sleep(0.001)
        return
    before = done(work, directory)
    wanted = before + int(part * (work.frames - min(before, work.frames)))
    while done(work, directory) < wanted and process.poll() is None:
        time.sleep(0.002)
    while kind == "write" and not unfinished(work, directory) and process.poll() is None:
        pass


def kill(work, directory, moment, seconds):
    """Starts it, kills it, and says what it was doing; nothing when it had ended before."""
    process = program.start(*work.command(directory), **one_thread)
    wait(work, directory, moment, seconds, process)
    process.send_signal(signal.SIGKILL)
    out, err = process.communicate()
    if process.returncode != -signal.SIGKILL:
        expect(process.returncode == 0, f"ended by itself: {process.returncode}: {out}{err}")
        return None
    left = sorted(path.name.removesuffix(".tmp") for path in unfinished(work, directory))
    if left:
        name = left[0]
        return f"writing {name if not name.startswith('frame_') else 'particles or the wall'}"
    return "between two files" if done(work, directory) else "before the first frame"


def go_on(work, directory, whole, label):
    out, err = program.run(*work.command(directory), **one_thread)
    same_files(directory, whole, label, work.but)
    for place in work.directories(directory):
        expect(manifest(place)["status"] == "finished", f"{label}: finished expected: {out}{err}")


def trial(work, scratch, whole, seconds, draw, first):
    """One kill, behind a first one if it is asked for, and what goes on after it. What it was doing."""
    while True:
        directory = scratch / "killed"
        shutil.rmtree(directory, ignore_errors=True)
        moment = (draw.choice(("time", "row", "write")), draw.random())
        if first and not kill(work, directory, ("row", draw.uniform(0.1, 0.6)), seconds):
            continue
        if what := kill(work, directory, moment, seconds):
            go_on(work, directory, whole, f"{type(work).__name__}, {moment}, {what}")
            return what


def undisturbed(work, scratch):
    begun = time.monotonic()
    program.run(*work.command(scratch / "whole"), **one_thread)
    return scratch / "whole", time.monotonic() - begun


def main():
    count, seed = (int(text) for text in (sys.argv[3:5] + ["9", "1"][len(sys.argv[3:5]):]))
    record = sys.argv[5] if len(sys.argv) > 5 else None
    draw = random.Random(seed)
    found = collections.Counter()
    kinds = [("run", lambda scratch: Run(scratch, fast, 40), False, count * 3 // 10),
             ("run of the reference", lambda scratch: Run(scratch, ("--quiet",), 20), False, count // 10),
             ("resumed run", lambda scratch: Run(scratch, fast, 40), True, count * 3 // 10),
             ("resumed run of the reference", lambda scratch: Run(scratch, ("--quiet",), 20), True, count // 10)]
    kinds.append(("reproduction", Reproduction, False, count - sum(kind[3] for kind in kinds)))
    for name, make, first, trials in kinds:
        if not trials:
            continue
        with tempfile.TemporaryDirectory() as place:
            scratch = pathlib.Path(place)
            work = make(scratch)
            whole, seconds = undisturbed(work, scratch)
            for number in range(trials):
                what = trial(work, scratch, whole, seconds, draw, first)
                found[name, what] += 1
                print(f"{name} {number + 1} of {trials}: {what}", flush=True)
    report = table(found, seed)
    print(report + ("\n".join(program.failures) or "all went on to the same bits"))
    if record:
        pathlib.Path(record).write_text(report + verdict(count))
    sys.exit(bool(program.failures))


def table(found, seed):
    version = subprocess.run([program.program, "--version"], capture_output=True, text=True).stdout.strip()
    lines = ["# Kills", "", f"`python3 tests/app/check_kills.py build/release/bin/aneurysm data {sum(found.values())} {seed}`"
             f" with {version}: each was killed (SIGKILL) once at a random moment, and went on by `--resume`, or by the"
             " same command. A resumed run had been killed once before.", "",
             "| killed | doing | times |", "| --- | --- | --- |"]
    lines += [f"| {name} | {what} | {times} |" for (name, what), times in sorted(found.items())]
    return "\n".join(lines) + "\n\n"


def verdict(count):
    bad = len(program.failures)
    return (f"{count} kills; differences from the undisturbed ones: {bad}. Compared: all files but `manifest.json` and"
            " `reproduction.html`, byte by byte.\n")


if __name__ == "__main__":
    main()
