# SPDX-License-Identifier: Apache-2.0
"""Runs that are cut short: by Ctrl-C, a kill, a full disk, a blow-up. Nothing is lost, and what goes on afterwards
gives the same bytes as a run without a break."""
import json
import resource
import signal
import time

import program
from program import expect, read_json

frames = 90


def write_scenario(file, **changes):
    scenario = program.changed(program.quick, **changes)
    file.write_text(json.dumps({"name": "short", "output": {"particles_every_frames": 20, "checkpoint_every_frames": 25},
                                **scenario}))
    return file


def heed_interrupts(limit=None):
    """What a run has to be told before it starts: `limit` is that of the size of its files."""
    def prepare():
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        if limit:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return {"preexec_fn": prepare}


def rows(directory):
    file = directory / "frames.csv"
    return max(0, file.read_text().count("\n") - 1) if file.exists() else 0


def stop_after(scenario, directory, row, how):
    """Starts a run and sends it a signal when it has written a row."""
    process = program.start("run", scenario, "--out", directory, "--frames", frames, **heed_interrupts())
    while rows(directory) < row and process.poll() is None:
        time.sleep(0.005)
    process.send_signal(how)
    _, err = process.communicate()
    return process.returncode, err


def manifest(directory):
    return read_json(directory / "manifest.json")


def same_bytes(one, other, names, label):
    for name in names:
        expect((one / name).read_bytes() == (other / name).read_bytes(), f"{label}: the same bytes expected in {name}")


def go_on(directory, whole, label):
    """Resumes and compares all that must not depend on the break."""
    program.run("run", "--resume", "--out", directory, "--frames", frames)
    expect(manifest(directory)["status"] == "finished", f"{label}: finished expected")
    expect(len(manifest(directory)["resumed_at_frames"]) == 1, f"{label}: one resumption expected")
    expect(manifest(directory)["state_hash"] == manifest(whole)["state_hash"], f"{label}: the same state expected")
    names = sorted(path.relative_to(whole) for path in whole.rglob("*") if path.is_file())
    found = sorted(path.relative_to(directory) for path in directory.rglob("*") if path.is_file())
    expect(found == names, f"{label}: the same files expected: {found}")
    same_bytes(directory, whole, [name for name in names if name.name != "manifest.json"], label)


def check_breaks(scratch):
    scenario, whole = write_scenario(scratch / "short.json"), scratch / "whole"
    out, err = program.run("run", scenario, "--out", whole, "--frames", frames)
    expect(err == "", f"quiet in a pipe expected: {err}")
    expect(str(whole) in out and "density error" in out, f"a summary expected: {out}")
    expect(manifest(whole)["status"] == "finished" and rows(whole) == frames, "a finished run expected")
    for how in (signal.SIGINT, signal.SIGTERM):
        directory = scratch / f"interrupted_{how.name}"
        code, err = stop_after(scenario, directory, 30, how)
        expect(code == 130 and "interrupted after frame" in err, f"{how.name}: {code}: {err}")
        expect(manifest(directory)["status"] == "interrupted", f"{how.name}: interrupted expected")
        expect(rows(directory) == manifest(directory)["frames"] < frames, f"{how.name}: as many rows as frames")
        go_on(directory, whole, how.name)
    directory = scratch / "killed"
    code, _ = stop_after(scenario, directory, 40, signal.SIGKILL)
    expect(code == -signal.SIGKILL, f"killed expected: {code}")
    expect(manifest(directory)["status"] == "running", "a killed run cannot say so")
    go_on(directory, whole, "killed")


def check_full_disk(scratch):
    """A limit on file sizes fails like a full disk, and needs no root."""
    directory, unlimited = scratch / "full", scratch / "unlimited"
    scenario = write_scenario(scratch / "short.json", output={"particles_every_frames": 0, "checkpoint_every_frames": 50})
    program.run("run", scenario, "--out", unlimited, "--frames", 360)
    limit = (unlimited / "frames.csv").stat().st_size - 4000  # the last rows don't fit, the checkpoints do
    expect((unlimited / "checkpoint.h5").stat().st_size < limit, "a limit above the checkpoints expected")
    _, err = program.run("run", scenario, "--out", directory, "--frames", 360, code=1, **heed_interrupts(limit))
    expect(err.count("\n") == 1 and str(directory) in err and "File too large" in err, f"one line expected: {err}")
    expect(manifest(directory)["status"] == "failed", "failed expected")
    text = (directory / "frames.csv").read_text()
    expect(text.endswith("\n") and len({line.count(",") for line in text.splitlines()}) == 1, "whole rows expected")
    expect(not list(directory.glob("*.tmp")), "no temporary files expected")
    expect(300 <= rows(directory) < 360, f"an end after the last checkpoint expected: {rows(directory)}")
    program.run("run", "--resume", "--out", directory, "--frames", 360)
    same_bytes(directory, unlimited, ("frames.csv", "hashes.csv", "checkpoint.h5"), "after the full disk")


def check_blow_up(scratch):
    directory = scratch / "blow_up"
    eos = {"model": "eos", "stiffness_m2_s2": 1, "blow_up_density_ratio": 2.5}
    _, err = program.run("run", write_scenario(scratch / "short.json", pressure=eos), "--out", directory, code=1)
    expect(err.count("\n") == 1 and "frame " in err and "particle " in err, f"frame and particle expected: {err}")
    record = manifest(directory)
    expect(record["status"] == "failed" and record["message"] in err, f"the reason expected: {record['message']}")
    expect(rows(directory) == record["frames"] > 0, "the frames before it expected")
    _, err = program.run("run", "--resume", "--out", directory, code=1)
    expect(record["message"] in err, f"the same end again expected: {err}")


def check_suite(scratch):
    directory = scratch / "suite"
    process = program.start("verify", "--backend", "reference", "--jobs", 1, "--out", directory, **heed_interrupts())
    time.sleep(2)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate()
    expect(process.returncode == 130 and err == "", f"the suite: {process.returncode}: {err}")
    expect(out.count("INCOMPLETE") == 1, f"an incomplete suite expected: {out}")
    expect(len(list(directory.iterdir())) == 4, "four reports expected")
    report = read_json(directory / "report.json")
    results = report["results"]
    expect(not report["complete"] and not report["passed"], "an incomplete report expected")
    expect(any(r["verdict"] == "holds" for r in results), "what was done expected")
    left_out = [r for r in results if r["verdict"] == "not run" and r["message"] == "interrupted"]
    expect(left_out, "the rest not run expected")
    expect("this report is incomplete" in (directory / "report.html").read_text(), "a page that says so expected")


program.check_all(check_breaks, check_full_disk, check_blow_up, check_suite)
