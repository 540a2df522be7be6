# SPDX-License-Identifier: Apache-2.0
"""The project installed under a prefix that is moved afterwards, used by find_package, and packed for Debian.

usage: check_install.py PROGRAM DATA BUILD CMAKE [--deb]
With --deb: also makes the packages, which takes dpkg-shlibdeps, and runs the program out of one.
"""
import csv
import os
import pathlib
import shutil
import subprocess
import sys

import program
from program import data, expect

build, cmake = pathlib.Path(sys.argv[3]), sys.argv[4]
ONE_CHECK = ["verify", "--only", "slip", "--backend", "reference"]


def call(*words, code=0, **settings):
    """Output and errors of a command, which has to end with this exit code."""
    process = subprocess.run([str(word) for word in words], capture_output=True, text=True, **settings)
    expect(process.returncode == code, f"{words}: exit code {process.returncode}: {process.stdout}{process.stderr}")
    return process.stdout, process.stderr


def with_variable(folder):
    return {**os.environ, "ANEURYSM_DATA": str(folder)}


def installed(scratch):
    call(cmake, "--install", build, "--prefix", scratch / "prefix")
    moved = scratch / "moved away"
    (scratch / "prefix").rename(moved)
    return moved


def check_programs(scratch):
    """Data beside the program, named by --data or the variable; what is missing is said before anything is computed."""
    prefix = installed(scratch)
    aneurysm, share = prefix / "bin/aneurysm", prefix / "share/aneurysm/data"
    expect(call(aneurysm, "info", "--data")[0].strip() == str(share), "data isn't that beside the program")
    expect((share / "scenario.schema.json").read_text() == call(aneurysm, "info", "--schema")[0], "the schema differs")
    expect(not list(prefix.rglob("pictures")), "pictures of the README were installed")
    out = call(aneurysm, *ONE_CHECK, "--out", scratch / "beside", cwd=scratch)[0]
    expect("PASS" in out, f"verify beside its data: {out}")
    other = scratch / "other"
    shutil.move(share, other)
    call(aneurysm, *ONE_CHECK, "--data", other, "--out", scratch / "option", cwd=scratch)
    call(aneurysm, *ONE_CHECK, "--out", scratch / "variable", cwd=scratch, env=with_variable(other))
    figure = prefix / "share/aneurysm/verification/reproduction/plot.py"
    expect(figure.read_bytes() == (data.parent / "verification/reproduction/plot.py").read_bytes(), "plot.py isn't there")

    def refused(words, named, **settings):
        out, err = call(aneurysm, *words, "--out", scratch / "none", code=2, cwd=scratch, **settings)
        expect(out == "" and err.count("\n") == 1 and named in err, f"'{named}' expected: {out}{err}")
        expect(not (scratch / "none").exists(), f"{words}: something was written")

    for words in (["verify"], ["verify", "--sensitivity"], ["reproduce", "table1"]):
        if "--sensitivity" in words and not (prefix / "bin/aneurysm-sensitivity").exists():
            continue
        refused([*words, "--data", scratch / "nowhere"], "nowhere: not the folder")
        refused(words, "nowhere: not the folder", env=with_variable(scratch / "nowhere"))
    refused(["verify", "--baseline", "--data", scratch / "nowhere"], "nowhere/baseline.json")
    for name in ("scenarios/verify_pipe.json", "hashes/quick.float.csv"):
        (other / name).rename(scratch / "kept")
        refused(["verify", "--data", other], name)
        (scratch / "kept").rename(other / name)
    (other / "scenarios/verify_pipe.json").write_text("{")
    refused(["verify", "--data", other], "scenarios/verify_pipe.json")


def check_libraries(scratch):
    """A project of its own finds the package, and its runs have the program's bits."""
    prefix, frames = installed(scratch), 2
    call(cmake, "-S", data.parent / "tests/install", "-B", scratch / "uses", f"-DCMAKE_PREFIX_PATH={prefix}",
         "-DCMAKE_BUILD_TYPE=Release")
    call(cmake, "--build", scratch / "uses")
    out = call(scratch / "uses/first_frames", data / "scenarios/quick.json", frames)[0]
    rows = [[float(word) for word in line.split()] for line in out.splitlines()]
    expect(len(rows) == frames + 1, f"first_frames: {out}")
    expect(abs(rows[-1][0] / rows[-1][1] - 1) < 1e-14, f"W(0) of reference and oracle: {rows[-1]}")
    for k, words in enumerate((["reference"], ["cpu", "--precision", "float"])):
        run = scratch / words[0]
        call(prefix / "bin/aneurysm", "run", data / "scenarios/quick.json", "--frames", frames, "--backend", *words, "--out", run)
        with open(run / "frames.csv", newline="") as lines:
            forces = [float(row["impact_force_n"]) for row in csv.DictReader(lines)]
        expect(forces == [row[k] for row in rows[:-1]], f"{words}: F_b {forces}, first_frames: {rows}")


def check_packages(scratch):
    """The .deb, unpacked: what it depends on is named, and the program runs there."""
    call(cmake.removesuffix("cmake") + "cpack", "-G", "DEB", "-B", scratch, "--config", build / "CPackConfig.cmake")
    for name, depends in [("aneurysm", "libgsl"), ("aneurysm-dev", "libeigen3-dev")]:
        packages = list(scratch.glob(f"{name}_*.deb"))
        expect(len(packages) == 1, f"{name}: {packages}")
        fields = call("dpkg-deb", "--field", packages[0], "Package", "Depends", "Description")[0]
        expect(f"Package: {name}\n" in fields and depends in fields, f"{name}: {fields}")
        call("dpkg-deb", "-x", packages[0], scratch / name)
    usr = scratch / "aneurysm/usr"
    expect((usr / "share/doc/aneurysm/copyright").exists(), "no copyright file")
    expect(call(usr / "bin/aneurysm", "info", "--data")[0].strip() == str(usr / "share/aneurysm/data"), "data of the package")
    call(usr / "bin/aneurysm", *ONE_CHECK, "--out", scratch / "out")


program.check_all(check_programs, check_libraries, *([check_packages] if "--deb" in sys.argv else []))
