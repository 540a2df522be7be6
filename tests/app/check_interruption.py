# SPDX-License-Identifier: Apache-2.0
"""Runs that are cut short: by Ctrl-C, a kill, a full disk, a blow-up. Nothing is lost, and what goes on afterwards
gives the same bytes as a run without a break."""
import csv
import fcntl
import json
import os
import pty
import resource
import shlex
import signal
import struct
import subprocess
import termios
import time

import program
from breaks import manifest, rows, same_bytes, same_files, write_scenario
from program import expect, read_json

frames = 90


def heed_interrupts(limit=None):
    """What a run has to be told before it starts: `limit` is that of the size of its files."""
    def prepare():
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        if limit:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return {"preexec_fn": prepare}


def stop_after(scenario, directory, row, how, *more, **settings):
    """Starts a run and sends it a signal when it has written a row."""
    process = program.start("run", scenario, "--out", directory, *more, "--frames", frames,
                            **(settings or heed_interrupts()))
    while rows(directory) < row and process.poll() is None:
        time.sleep(0.005)
    process.send_signal(how)
    _, err = process.communicate()
    return process.returncode, err


def go_on(directory, whole, label):
    """Resumes and compares all that must not depend on the break."""
    program.run("run", "--resume", "--out", directory, "--frames", frames)
    expect(manifest(directory)["status"] == "finished", f"{label}: finished expected")
    expect(len(manifest(directory)["resumed_at_frames"]) == 1, f"{label}: one resumption expected")
    expect(manifest(directory)["state_hash"] == manifest(whole)["state_hash"], f"{label}: the same state expected")
    same_files(directory, whole, label)


def check_breaks(scratch):
    scenario, whole = write_scenario(scratch / "short.json"), scratch / "whole"
    out, err = program.run("run", scenario, "--out", whole, "--frames", frames)
    expect(err == "", f"quiet in a pipe expected: {err}")
    expect(str(whole) in out and "density error" in out, f"a summary expected: {out}")
    expect(manifest(whole)["status"] == "finished" and rows(whole) == frames, "a finished run expected")
    for how in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1):
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
    directory = scratch / "killed_early"
    code, _ = stop_after(scenario, directory, 3, signal.SIGKILL)
    expect(code == -signal.SIGKILL and not (directory / "checkpoint.h5").exists(), "a kill before the first checkpoint")
    go_on(directory, whole, "killed before the first checkpoint")
    directory = scratch / "nohup"
    code, err = stop_after(scenario, directory, 30, signal.SIGHUP,
                           preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    expect(code == 0 and rows(directory) == frames, f"a run under nohup goes on: {code}: {err}")


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


def check_hint(scratch):
    """What is printed after an interruption goes on as it stands, to the frame that was asked for."""
    scenario = write_scenario(scratch / "short.json")
    backend = ("--backend", "cpu", "--precision", "float")
    whole = scratch / "whole"
    program.run("run", scenario, "--out", whole, "--frames", frames, *backend)
    for name in ("my run", "it's", "$(x)`y`", "a;b&c|d", "-x"):
        directory = scratch / name
        code, err = stop_after(scenario, directory, 20, signal.SIGTERM, *backend)
        words = shlex.split(err[err.index("go on with: ") + len("go on with: "):])
        expect(code == 130 and words[0] == "aneurysm", f"a command expected: {code}: {err}")
        program.run(*words[1:])
        same_bytes(directory, whole, ("frames.csv", "hashes.csv", "checkpoint.h5"), name)


def check_lost_particles(scratch):
    """A frame whose particles didn't get onto the disk is done again, also when its checkpoint would have fitted."""
    scenario, whole, directory = (scratch / name for name in ("short.json", "whole", "full"))
    write_scenario(scenario, output={"particles_every_frames": 10, "checkpoint_every_frames": 10})
    program.run("run", scenario, "--out", whole, "--frames", frames)
    process = program.start("run", scenario, "--out", directory, "--frames", frames)
    while rows(directory) < 3 and process.poll() is None:
        time.sleep(0.002)
    obstacle = directory / "particles/frame_000040.hdf.tmp"
    obstacle.mkdir()
    _, err = process.communicate()
    expect(process.returncode == 1 and "frame_000040" in err, f"a failure expected: {process.returncode}: {err}")
    expect(manifest(directory)["status"] == "failed", "failed expected")
    obstacle.rmdir()
    go_on(directory, whole, "after the lost file")


def check_provenance(scratch):
    """Which program made which frames, also when they were several."""
    scenario, directory = write_scenario(scratch / "short.json"), scratch / "run"
    program.run("run", scenario, "--out", directory, "--frames", 30)
    record = manifest(directory)
    first = record["made_by"][0]
    expect(len(record["made_by"]) == 1 and first["after_frame"] == 0, f"one maker expected: {record['made_by']}")
    for key in ("version", "commit", "compiler", "flags", "device", "host", "job", "command", "machine", "driver"):
        expect(key in first, f"{key} of the maker expected")
    expect(f"--out {directory} --frames 30" in first["command"], f"the command expected: {first['command']}")
    expect(any(name.startswith("libhdf5") for name in first["libraries"]), f"libraries: {first['libraries']}")
    other = "1" * 40
    text = json.dumps(record).replace(f'"commit": "{first["commit"]}"', f'"commit": "{other}"')
    (directory / "manifest.json").write_text(text)
    environment = {**os.environ, "SLURM_JOB_ID": "77"}
    _, err = program.run("run", "--resume", "--out", directory, "--frames", 40, env=environment)
    expect(err.count("\n") == 1 and other in err and "note" in err, f"a note expected: {err}")
    makers = manifest(directory)["made_by"]
    expect([(m["after_frame"], m["commit"]) for m in makers] == [(0, other), (30, first["commit"])], f"makers: {makers}")
    expect(makers[1]["job"] == "SLURM_JOB_ID=77", f"the job expected: {makers[1]}")
    old = json.loads(text)  # of a version that kept no list
    del old["made_by"]
    (directory / "manifest.json").write_text(json.dumps(old))
    program.run("run", "--resume", "--out", directory, "--frames", 50)
    expect(manifest(directory)["made_by"][0]["commit"] == other, "the first maker by the old manifest expected")


def check_descriptors(scratch):
    """Closed standard descriptors: what belongs there doesn't get into the files."""
    scenario, whole = write_scenario(scratch / "short.json"), scratch / "whole"
    program.run("run", scenario, "--out", whole, "--frames", 30)
    for number, closed in enumerate((">&-", "<&- >&-", "<&- >&- 2>&-", "2>&-")):
        directory = scratch / f"closed{number}"
        command = f'exec "$0" run "$1" --out "$2" --frames 30 {closed}'
        done = subprocess.run(["sh", "-c", command, program.program, scenario, directory], capture_output=True, text=True)
        said = "standard output" in done.stderr or "2>&-" in closed
        expect(done.returncode == (1 if ">&-" in closed.replace("2>&-", "") else 0) and (said or done.returncode == 0),
               f"{closed}: {done.returncode}: {done.stderr}")
        same_bytes(directory, whole, ("frames.csv", "hashes.csv", "checkpoint.h5"), closed)


def check_locks(scratch):
    """A run belongs to one process at a time, also where the file system knows no flock."""
    scenario = write_scenario(scratch / "short.json", time={"frames": 2000})
    library = scratch / "no_flock.so"
    source = b"#include <errno.h>\nint flock(int f, int o) { (void)f; (void)o; errno = ENOSYS; return -1; }\n"
    subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", library], input=source, check=True)
    for name, environment in (("with", {}), ("without", {"LD_PRELOAD": str(library)})):
        directory = scratch / name
        settings = {"env": {**os.environ, **environment}}
        process = program.start("run", scenario, "--out", directory, **settings)
        while rows(directory) < 60 and process.poll() is None:
            time.sleep(0.005)
        _, err = program.run("run", "--resume", "--out", directory, code=2, **settings)
        expect("another run writes here" in err, f"{name} flock: {err}")
        if environment:
            expect(f"process {process.pid} on {os.uname().nodename}" in err, f"host and process expected: {err}")
        process.kill()
        process.communicate()
        _, err = program.run("run", "--resume", "--out", directory, "--frames", 80, **settings)
        expect(err == "" and not list(directory.glob("*.lock")), f"{name} flock, after a kill: {err}")
    lock = scratch / "without/frames.csv.lock"
    lock.write_text(f"elsewhere {os.getpid()}\n")
    _, err = program.run("run", "--resume", "--out", lock.parent, "--frames", 90, code=2, **settings)
    expect("on elsewhere" in err and str(lock) in err, f"a foreign host's lock is kept: {err}")


def device(directory):
    return manifest(directory)["device"]


def check_threads(scratch):
    """How many threads: what the batch system, the user and the system give."""
    scenario = write_scenario(scratch / "short.json")
    run = ["run", scenario, "--backend", "cpu", "--frames", 1, "--out"]
    for name in ("SLURM_CPUS_PER_TASK", "OMP_NUM_THREADS"):
        program.run(*run, scratch / name, env={**os.environ, name: "1"})
        expect(device(scratch / name) == "1 CPU thread", f"{name}: {device(scratch / name)}")
    program.run(*run, scratch / "odd", env={**os.environ, "OMP_NUM_THREADS": "many", "SLURM_CPUS_PER_TASK": "-3"})
    _, err = program.run(*run, scratch / "many", "--threads", 100000)
    expect(err.count("\n") == 1 and "--threads: " in err, f"a word on fewer threads expected: {err}")
    same_bytes(scratch / "many", scratch / "OMP_NUM_THREADS", ("frames.csv", "hashes.csv"), "threads")
    if os.getuid() == 0:  # limits on processes don't hold for root
        def become_nobody():
            resource.setrlimit(resource.RLIMIT_NPROC, (3, 3))
            os.setgid(65534)
            os.setuid(65534)

        scratch.chmod(0o777)
        done = program.start(*run, scratch / "few", "--threads", 8, preexec_fn=become_nobody)
        _, err = done.communicate()
        expect(done.returncode == 0 and "--threads: " in err, f"few threads: {done.returncode}: {err}")
        done = program.start("verify", "--only", "eq13", "--jobs", 100000, "--out", scratch / "v", preexec_fn=become_nobody)
        _, err = done.communicate()
        expect(done.returncode == 0, f"few jobs: {done.returncode}: {err}")


def on_terminal(arguments, columns, terminal):
    """What a terminal of that width and kind gets from the program."""
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    process = subprocess.Popen([program.program, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=slave,
                               env={**os.environ, "TERM": terminal})
    os.close(slave)
    seen = b""
    try:
        while piece := os.read(master, 4096):
            seen += piece
    except OSError:  # the other end is closed
        pass
    os.close(master)
    expect(process.wait() == 0, f"{arguments}: exit code {process.returncode}")
    return seen.decode()


def check_progress(scratch):
    """Lines where stderr is no terminal, one line that fits where it is."""
    scenario = write_scenario(scratch / "short.json")
    run = ["run", scenario, "--frames", 300, "--out"]
    _, err = program.run(*run, scratch / "lines", "--progress", 0.05)
    expect(err.count("\n") > 1 and all(line.startswith("frame ") for line in err.splitlines()), f"lines expected: {err}")
    _, err = program.run(*run, scratch / "quiet", "--quiet")
    expect(err == "", f"no line expected: {err}")
    seen = on_terminal([*run, scratch / "wide"], 40, "xterm")
    lines = [line.removesuffix("\x1b[K") for line in seen.split("\r") if "frame" in line]
    expect(lines and max(map(len, lines)) < 40, f"lines below 40 characters expected: {lines}")
    seen = on_terminal([*run, scratch / "dumb"], 80, "dumb")
    expect("\x1b" not in seen, f"no escape sequence expected: {seen}")
    seen = on_terminal([*run, scratch / "dumb_lines", "--progress", 0.05], 80, "dumb")
    expect("\x1b" not in seen and seen.count("frame ") > 1, f"plain lines expected: {seen}")


def check_unsolved(scratch):
    """A solve that is given up spoils the run: the summary shouts, and --strict stops."""
    scenario = write_scenario(scratch / "short.json", pressure={"max_iterations": 1})
    fast = ("--backend", "cpu", "--precision", "float")
    out, _ = program.run("run", scenario, *fast, "--frames", 120, "--out", scratch / "loud")
    with open(scratch / "loud/frames.csv", newline="") as file:
        unsolved = [int(row["frame"]) for row in csv.DictReader(file)
                    if float(row["residual_mean_per_s"]) > 0.1 or float(row["residual_max_per_s"]) > 5]
    expect(len(unsolved) > 50, f"solves that are given up expected: {unsolved}")
    expect(f"NOT SOLVED     (3) in {len(unsolved)} of 120 frames, from frame {unsolved[0]} on" in out, f"a shout: {out}")
    _, err = program.run("run", scenario, *fast, "--frames", 120, "--out", scratch / "strict", "--strict", code=1)
    expect(err.count("\n") == 1 and f"frame {unsolved[0]}: pressure.max_iterations (1)" in err, f"an error: {err}")
    expect(manifest(scratch / "strict")["status"] == "failed", "a failed run expected")
    out, _ = program.run("run", write_scenario(scratch / "good.json"), *fast, "--frames", 120, "--out", scratch / "good",
                         "--strict")
    expect("NOT SOLVED" not in out, f"a quiet summary expected: {out}")


program.check_all(check_breaks, check_full_disk, check_blow_up, check_suite, check_hint, check_lost_particles,
                  check_provenance, check_descriptors, check_locks, check_threads, check_progress, check_unsolved)
