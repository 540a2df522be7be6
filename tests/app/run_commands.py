# SPDX-License-Identifier: Apache-2.0
"""The commands of the pages, run as they stand, in a folder that looks like the project's: with the program that is built,
and with a copy of its data in which runs are short. tests/guards/check_commands.py knows those that another test runs.

usage: run_commands.py PROGRAM DATA
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import program
from program import data, expect, read_json

project = data.parent
sys.path.insert(0, str(project / "tests/guards"))
import check_commands as guarded  # noqa: E402 (the guard of the same subject)

build = program.program.parent.parent
frames = 4
# What a page says of a run of thousands of frames, for one of four. Nothing else of a command is changed.
SHORTER = ((r"(plot_run\.py results/paper_tc1) 2800", r"\1 4"), (r"--frames 400,1000,1200,2200,2600,2800", "--frames 2,4"),
           (r"--frames 2000", "--frames 4"), (r"(bench_frames data.*)", r"\1 --benchmark_list_tests"))


def shorten(file):
    """Its runs have four frames, and write often."""
    scenario = read_json(file)
    if "time" in scenario or "base" not in scenario:
        scenario.setdefault("time", {})["frames"] = frames
        scenario.setdefault("assumed", {})["time.frames"] = "a test"
        scenario["output"] = {"particles_every_frames": 2, "checkpoint_every_frames": 2}
        file.write_text(json.dumps(scenario))


def make_project(scratch):
    """The folder: what commands read is there under its own name."""
    (scratch / "build").mkdir()
    (scratch / "build/release").symlink_to(build)
    for room in ("analytic", "common", "cuda", "output", "reference", "verification"):
        (scratch / room).symlink_to(project / room)
    shutil.copytree(data, scratch / "data")
    (scratch / "results").mkdir()
    (scratch / "bin").mkdir()
    (scratch / "bin/python3").symlink_to(sys.executable)  # the one that has matplotlib
    mine = re.search(r"Put this into `(\S+)`:\n\n```json\n(.*?)```", (project / "README.md").read_text(), re.DOTALL)
    (scratch / mine[1]).write_text(mine[2])
    for file in (scratch / "data/scenarios").glob("*.json"):
        shorten(file)


def sh(scratch, command):
    environment = {**os.environ, "PATH": f"{scratch}/bin:{scratch}/build/release/bin:{os.environ['PATH']}", "A": "build/release/bin/aneurysm",
                   "ANEURYSM_DATA": str(scratch / "data")}
    return subprocess.run(["bash", "-c", command], cwd=scratch, env=environment, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL)


def run(scratch, scenario, out, count):
    done = sh(scratch, f"aneurysm run data/scenarios/{scenario}.json --backend cpu --precision float --out {out} --frames {count}")
    expect(done.returncode == 0, f"{out}: {done.stderr}")


def is_built(name):
    """Whether the build has a target of this name."""
    file = build / "build.ninja"
    return not file.exists() or re.search(rf"^build {re.escape(name)}: phony", file.read_text(), re.MULTILINE) is not None


def lacks(command):
    """What this build or machine hasn't that a command needs; empty where it has all."""
    if re.search(r"aneurysm render|plot_run", command):
        words = [name for name in ("aneurysm-pictures",) if "render" in command and not (build / "bin" / name).exists()]
        if "--animation" in command and not shutil.which("ffmpeg"):
            words.append("ffmpeg")
        if "plot_run" in command and subprocess.run([sys.executable, "-c", "import matplotlib, h5py"], capture_output=True).returncode:
            words.append("matplotlib and h5py")
        return ", ".join(words)
    return "" if "bench_frames data" not in command or (build / "bin/bench_frames").exists() else "bench_frames"


def check_command(scratch, command):
    target = re.fullmatch(r"cmake --build --preset release --target (\S+)", command)
    if target:  # building within a build's own tests would change it under them
        expect(is_built(target[1]), f"{command}: the build has no such target")
        return
    words = guarded.filled_in(command) + (" --help" if guarded.is_mention(command) else "")
    for long, short in SHORTER:
        words = re.sub(long, short, words)
    out = re.search(r"--out (\S+)", words)
    if out and "render" not in words:
        shutil.rmtree(scratch / out[1], ignore_errors=True)
    if "aneurysm verify" in words and not out:
        shutil.rmtree(scratch / "results/verify", ignore_errors=True)
    if "--resume" in words:
        run(scratch, "quick", out[1], frames // 2)
    done = sh(scratch, words)
    expect(done.returncode == 0, f"{command}: exit code {done.returncode}: {done.stdout}{done.stderr}")
    if out and done.returncode == 0:
        made = scratch / out[1]
        expect(made.exists() and (made.is_file() or any(made.iterdir())), f"{command}: nothing in {out[1]}")


def check_commands(scratch):
    make_project(scratch)
    for name in ("paper_tc1", "a", "b"):  # what render and plot_run are shown with
        run(scratch, "quick", f"results/{name}", frames)
    seen = set()
    for page in guarded.pages(project):
        for command in guarded.commands(page.read_text()):
            if command in guarded.ELSEWHERE or command in seen:
                continue
            seen.add(command)
            if missing := lacks(command):
                print(f"not run: {command}: {missing} isn't here")
                continue
            check_command(scratch, command)
            print(f"run: {command}", flush=True)
    expect(len(seen) > 30, f"commands expected: {seen}")
    schema = (scratch / "data/scenario.schema.json").read_text()
    expect(schema == (data / "scenario.schema.json").read_text(), "the schema as it is shipped expected")


program.check_all(check_commands)
