# SPDX-License-Identifier: Apache-2.0
"""Runs that are cut short: by Ctrl-C, a kill, a full disk, a blow-up. Nothing is lost, and what goes on afterwards
gives the same bytes as a run without a break.

usage: check_interruption.py PROGRAM DATA
"""
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time

program, data = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
scratch_directory = tempfile.TemporaryDirectory()
scratch = pathlib.Path(scratch_directory.name)
scenario = scratch / "short.json"
frames = 90
failures = []


def expect(good, what):
    if not good:
        failures.append(what)


def write_scenario(file, **changes):
    content = {"base": str(data / "scenarios/quick.json"), "name": "short",
               "output": {"particles_every_frames": 20, "checkpoint_every_frames": 25}, "assumed": {}}
    for group, values in changes.items():
        content[group] = values
        content["assumed"].update({f"{group}.{key}": "a test" for key in values})
    file.write_text(json.dumps(content))


def start(*arguments, limit=None, command="run"):
    def prepare():
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        if limit:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.Popen([program, command, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            text=True, preexec_fn=prepare)


def run(*arguments, code=0, limit=None):
    process = start(*arguments, limit=limit)
    out, err = process.communicate()
    expect(process.returncode == code, f"{arguments}: exit code {process.returncode} instead of {code}: {err}")
    return out, err


def rows(directory):
    file = directory / "frames.csv"
    return max(0, file.read_text().count("\n") - 1) if file.exists() else 0


def stop_after(directory, row, how):
    """Starts a run and sends it a signal when it has written a row."""
    process = start(scenario, "--out", directory, "--frames", frames)
    while rows(directory) < row and process.poll() is None:
        time.sleep(0.005)
    process.send_signal(how)
    out, err = process.communicate()
    return process.returncode, out, err


def manifest(directory):
    return json.loads((directory / "manifest.json").read_text())


def go_on(directory, label):
    """Resumes and compares all that must not depend on the break."""
    run("--resume", "--out", directory, "--frames", frames)
    expect(manifest(directory)["status"] == "finished", f"{label}: finished expected")
    expect(len(manifest(directory)["resumed_at_frames"]) == 1, f"{label}: one resumption expected")
    expect(manifest(directory)["state_hash"] == manifest(whole)["state_hash"], f"{label}: the same state expected")
    names = sorted(path.relative_to(whole) for path in whole.rglob("*") if path.is_file())
    found = sorted(path.relative_to(directory) for path in directory.rglob("*") if path.is_file())
    expect(found == names, f"{label}: the same files expected: {found}")
    for name in names:
        if name.name != "manifest.json":
            same = (directory / name).read_bytes() == (whole / name).read_bytes()
            expect(same, f"{label}: the same bytes expected in {name}")


def check_whole():
    out, err = run(scenario, "--out", whole, "--frames", frames)
    expect(err == "", f"quiet in a pipe expected: {err}")
    expect(str(whole) in out and "density error" in out, f"a summary expected: {out}")
    expect(manifest(whole)["status"] == "finished" and rows(whole) == frames, "a finished run expected")


def check_interrupted():
    for how in (signal.SIGINT, signal.SIGTERM):
        directory = scratch / f"interrupted_{how.name}"
        code, _, err = stop_after(directory, 30, how)
        expect(code == 130 and "interrupted after frame" in err, f"{how.name}: {code}: {err}")
        expect(manifest(directory)["status"] == "interrupted", f"{how.name}: interrupted expected")
        expect(rows(directory) == manifest(directory)["frames"] < frames, f"{how.name}: as many rows as frames")
        go_on(directory, how.name)


def check_killed():
    directory = scratch / "killed"
    code, _, _ = stop_after(directory, 40, signal.SIGKILL)
    expect(code == -signal.SIGKILL, f"killed expected: {code}")
    expect(manifest(directory)["status"] == "running", "a killed run cannot say so")
    go_on(directory, "killed")


def check_full_disk():
    """A limit on file sizes fails like a full disk, and needs no root."""
    directory, unlimited = scratch / "full", scratch / "unlimited"
    write_scenario(scenario, output={"particles_every_frames": 0, "checkpoint_every_frames": 50})
    run(scenario, "--out", unlimited, "--frames", 360)
    limit = (unlimited / "frames.csv").stat().st_size - 4000  # the last rows don't fit, the checkpoints do
    expect((unlimited / "checkpoint.h5").stat().st_size < limit, "a limit above the checkpoints expected")
    _, err = run(scenario, "--out", directory, "--frames", 360, code=1, limit=limit)
    expect(err.count("\n") == 1 and str(directory) in err and "File too large" in err, f"one line expected: {err}")
    expect(manifest(directory)["status"] == "failed", "failed expected")
    text = (directory / "frames.csv").read_text()
    expect(text.endswith("\n") and len({line.count(",") for line in text.splitlines()}) == 1, "whole rows expected")
    expect(not list(directory.glob("*.tmp")), "no temporary files expected")
    expect(300 <= rows(directory) < 360, f"an end after the last checkpoint expected: {rows(directory)}")
    run("--resume", "--out", directory, "--frames", 360)
    for name in ("frames.csv", "hashes.csv", "checkpoint.h5"):
        same = (directory / name).read_bytes() == (unlimited / name).read_bytes()
        expect(same, f"after the full disk: the same bytes expected in {name}")


def check_blow_up():
    directory = scratch / "blow_up"
    write_scenario(scenario, pressure={"model": "eos", "stiffness_m2_s2": 1, "blow_up_density_ratio": 1.5})
    _, err = run(scenario, "--out", directory, code=1)
    expect(err.count("\n") == 1 and "frame " in err and "particle " in err, f"frame and particle expected: {err}")
    record = manifest(directory)
    expect(record["status"] == "failed" and record["message"] in err, f"the reason expected: {record['message']}")
    expect(rows(directory) == record["frames"] > 0, "the frames before it expected")
    _, err = run("--resume", "--out", directory, code=1)
    expect(record["message"] in err, f"the same end again expected: {err}")


def check_suite():
    directory = scratch / "suite"
    process = start("--backend", "reference", "--jobs", 1, "--out", directory, command="verify")
    time.sleep(2)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate()
    expect(process.returncode == 130 and err == "", f"the suite: {process.returncode}: {err}")
    expect(out.count("INCOMPLETE") == 1, f"an incomplete suite expected: {out}")
    expect(len(list(directory.iterdir())) == 4, "four reports expected")
    report = json.loads((directory / "report.json").read_text())
    results = report["results"]
    expect(not report["complete"] and not report["passed"], "an incomplete report expected")
    expect(any(r["verdict"] == "holds" for r in results), "what was done expected")
    expect(results[-1]["verdict"] == "not run" and results[-1]["message"] == "interrupted", "the rest not run expected")
    expect("this report is incomplete" in (directory / "report.html").read_text(), "a page that says so expected")


whole = scratch / "whole"
write_scenario(scenario)
for check in (check_whole, check_interrupted, check_killed, check_full_disk, check_blow_up, check_suite):
    check()
scratch_directory.cleanup()
print("\n".join(failures) or "all checks passed")
sys.exit(bool(failures))
