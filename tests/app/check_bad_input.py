# SPDX-License-Identifier: Apache-2.0
"""Bad input to the program: one line on stderr that names the place, exit code 2, nothing written.

Where the JSON Schema can say what is wrong, it has to refuse the file as well, and only there.
"""
import json
import os
import pathlib
import re
import stat
import subprocess
import threading

try:
    import jsonschema
except ImportError:  # the program is tested without it, the schema isn't
    jsonschema = None

import program
from program import data, expect, quick

base = data / "scenarios/base.json"
validator = jsonschema and jsonschema.Draft202012Validator(program.read_json(data / "scenario.schema.json"))


def files_below(directory):
    return sorted(str(path) for path in directory.rglob("*"))


def refused(directory, arguments, names):
    """Runs the program, which has to refuse the arguments and name each of `names`."""
    before = files_below(directory)
    out, err = program.run(*arguments, code=2, cwd=directory)
    label = " ".join(map(str, arguments)) + f": {err.strip()}"
    expect(err.count("\n") == 1 and err.endswith("\n"), f"one line expected: {label}")
    expect(out == "", f"nothing on stdout expected: {label}")
    for name in names:
        expect(str(name) in err, f"'{name}' expected: {label}")
    expect(files_below(directory) == before, f"nothing written expected: {label}")


def changed(**groups):
    return program.changed(base, **groups)


# Text of the file, JSON path in the message, whether the schema refuses it too (None: it is no JSON).
malformed = [
    ("", "(top)", None),
    ("{", "(top)", None),
    ('{"time": {"frame_s": 0.001,}}', "time", None),
    ('{"time": {"frame_s": NaN}}', "time.frame_s", None),
    ('{"time": {"frame_s": Infinity}}', "time.frame_s", None),
    ('{"time": {"frame_s": 1e999}}', "time.frame_s", None),
    ('{"time": {"frames": 1, "frames": 1}}', "time.frames", None),
    ("[]", "(top)", True),
    ("{}", "name", True),
    (json.dumps({"base": "missing.json"}), "base", False),
    (json.dumps({"base": "bad.json"}), "base", False),
    (json.dumps({"base": 1}), "base", True),
]
scenarios = [
    (changed(tiem={"frames": 1}), "tiem", True),
    (changed(time={"frame": 1}), "time.frame", True),
    (changed(time=1), "time", True),
    (changed(time={"frames": "many"}), "time.frames", True),
    (changed(time={"frames": 10.5}), "time.frames", True),
    (changed(time={"frames": None}), "time.frames", True),
    (changed(time={"frame_s": True}), "time.frame_s", True),
    (changed(time={"frame_s": 0}), "time.frame_s", True),
    (changed(time={"frame_s": -0.001}), "time.frame_s", True),
    (changed(particles={"count": 0}), "particles.count", True),
    (changed(particles={"count": -5}), "particles.count", True),
    (changed(rupture={"porosity": 0}), "rupture.porosity", True),
    (changed(rupture={"porosity": 1}), "rupture.porosity", True),
    (changed(rupture={"poisson_ratio": 2}), "rupture.poisson_ratio", True),
    (changed(vessel={"angle_deg": 14.9}), "vessel.angle_deg", True),
    (changed(vessel={"angle_deg": 86}), "vessel.angle_deg", True),
    (changed(fluid={"gravity_m_s2": [0, 1]}), "fluid.gravity_m_s2", True),
    (changed(inlet={"waveform": "sin"}), "inlet.waveform", True),
    (changed(aneurysm={"shape": "cubic"}), "aneurysm.shape", True),
    (changed(pressure={"relaxation": 1}), "pressure.relaxation", True),
    (changed(inlet={"profile": "parabola"}), "inlet.profile", True),
    (changed(inlet={"ramp_s": -0.05}), "inlet.ramp_s", True),
    (changed(outlet={"level_margin": -1}), "outlet.level_margin", True),
    (changed(controller={"refill_distance_spacings": 0}), "controller.refill_distance_spacings", True),
    (changed(controller={"probe_depth_spacings": 2}), "controller.probe_depth_spacings: key of an earlier version", True),
    (changed(settling={"steps": 40}), "allowed: settling.pushing_rounds", True),
    ({"base": str(base), "assumed": {"vessel.color": "red"}}, "assumed", True),
    ({"base": str(base), "assumed": {"vessel.radius_m": ""}}, "assumed.vessel.radius_m", True),
    # What contradicts other values is beyond a schema.
    ({"base": str(base), "fluid": {"density_kg_m3": 1060}}, "assumed.fluid.density_kg_m3", False),
    ({"base": str(base), "particles": {"count": 9000}, "vessel": {"angle_deg": 50}},  # all at once, to paste
     '"assumed": {"particles.count": "...", "vessel.angle_deg": "..."}', False),
    (changed(particles={"count": 12}), "particles.count", False),
    (changed(particles={"count": 100}), "particles.count", False),
    (changed(vessel={"angle_deg": 15, "daughter_length_radii": 3.5}), "vessel.angle_deg", False),
    (changed(aneurysm={"neck_width_radii": 3.5, "base_width_radii": 3.5}), "aneurysm.base_width_radii", False),
    (changed(aneurysm={"neck_width_radii": 2}), "aneurysm.neck_width_radii", False),
    (changed(aneurysm={"shape": "none"}), "aneurysm.neck_width_radii", False),
    (changed(aneurysm={"initial_radius_radii": 0.9}), "aneurysm.initial_radius_radii", False),
    (changed(time={"frame_s": 0.02}), "time.frame_s", False),
    (changed(elastic_wall={"stiffness_n_m": 1e9}), "elastic_wall.stiffness_n_m", False),
    (changed(inlet={"waveform": "table"}), "inlet.table_time_s", False),
    (changed(outlet={"pressure_pa": 0}), "outlet.level_margin", False),
    (changed(inlet={"table_time_s": [0, 1], "table_velocity_m_s": [1, 1]}), "inlet.table_time_s", False),
]


def check_files(directory):
    bad = directory / "bad.json"
    rows = malformed + [(json.dumps(content), path, schema) for content, path, schema in scenarios]
    for text, path, schema in rows:
        bad.write_text(text)
        refused(directory, ["run", bad, "--out", "out"], [bad, path])
        if validator and schema is not None:
            says = not validator.is_valid(json.loads(text))
            expect(says == schema, f"the schema {'refuses' if says else 'accepts'} {text}")
    bad.write_bytes(b'{"name": "\xff"}')
    refused(directory, ["info", bad], [bad, "name"])
    bad.unlink()
    refused(directory, ["info", bad], [bad, "No such file"])
    refused(directory, ["info", directory], [directory, "directory"])


def check_arguments(directory):
    taken, file = directory / "taken", directory / "file"
    taken.mkdir()
    file.write_text("")
    refused(directory, ["run", quick, "--out", taken], [taken, "exists"])
    refused(directory, ["run", quick, "--out", file], [file, "exists"])
    refused(directory, ["run", quick, "--out", file / "out"], [file, "cannot be made"])
    refused(directory, ["run", quick, "--out", "/proc/out"], ["/proc/out", "cannot be made"])
    if not pathlib.Path("/dev/nvidiactl").exists():
        refused(directory, ["run", quick, "--out", "out", "--backend", "cuda"], ["--backend", "cuda"])
    refused(directory, ["run", quick, "--out", "out", "--backend", "x"], ["--backend", "x"])
    refused(directory, ["run", quick, "--out", "out", "--precision", "float"], ["--precision", "float"])
    refused(directory, ["run", quick, "--out", "out", "--frames", "0"], ["--frames", "0"])
    refused(directory, ["run", quick, "--out", "out", "--frames", "1.5"], ["--frames", "1.5"])
    refused(directory, ["run", quick, "--out", "out", "--fast"], ["--fast"])
    refused(directory, ["run"], ["SCENARIO"])
    refused(directory, ["run", "--resume"], ["--out"])
    refused(directory, ["run", "--resume", "--out", taken], [taken, "checkpoint.h5"])
    refused(directory, ["dance"], ["dance"])
    refused(directory, [], ["subcommand"])


def check_checkpoints(directory):
    run, checkpoint = directory / "run", directory / "run/checkpoint.h5"
    _, err = program.run("run", quick, "--out", run, "--frames", "2")
    expect(err == "", f"a quiet run expected: {err}")
    expect((run / "frames.csv").read_text().count("\n") == 3, "two frames expected")
    again = ["run", "--resume", "--out", run]
    refused(directory, [*again, "--frames", "2"], ["--frames", "2"])
    refused(directory, [*again, data / "scenarios/paper_tc1.json"], ["paper_tc1.json", "another scenario"])
    good = checkpoint.read_bytes()
    foreign = next((run / "particles").iterdir()).read_bytes()
    for bad, why in [(good[:-1], "truncated"), (good[: len(good) // 2], "truncated"), (good[:100], "truncated"),
                     (b"", "no checkpoint"), (b"text", "no checkpoint"), (foreign, "no checkpoint"),
                     (good[:-99] + b"x" + good[-98:], "damaged"),
                     (good.replace(b"checkpoint 2", b"checkpoint 7", 1), "another version (7)"),
                     (good.replace(b"checkpoint 2", b"checkpoint 1", 1), "lacks the potential")]:
        checkpoint.write_bytes(bad)
        refused(directory, again, [checkpoint, why])
    checkpoint.write_bytes(good)
    manifest = run / "manifest.json"
    text = manifest.read_text()
    manifest.write_text(text.replace('"backend": "reference"', '"backend": "cpu"'))
    refused(directory, [*again, "--backend", "reference"], [manifest, "backend"])
    manifest.write_text(text.replace('"backend": "reference"', '"backend": "abacus"'))
    refused(directory, again, [manifest, "backend"])
    manifest.write_text(text[:50])
    refused(directory, again, [manifest])
    manifest.write_text(text)
    (run / "frames.csv").write_text("frame\n")
    refused(directory, again, [run / "frames.csv", "fewer lines"])


def check_comparisons(directory):
    refused(directory, ["compare"], ["SCENARIO"])
    refused(directory, ["compare", quick, "--candidate", "x"], ["--candidate", "x"])
    refused(directory, ["compare", quick, "--candidate", "cpu", "--precision", "half"], ["--precision", "half"])
    compare = ["compare", quick, "--candidate", "reference"]
    refused(directory, compare[:2], ["--candidate"])
    refused(directory, [*compare, "--precision", "float"], ["--precision", "float"])
    refused(directory, [*compare, "--mode", "x"], ["--mode", "x", "lockstep"])
    refused(directory, [*compare, "--frames", "0"], ["--frames", "0"])
    refused(directory, [*compare, "--from", "-1"], ["--from", "-1"])
    refused(directory, [*compare, "--from", "100000"], ["--from", "100000"])
    refused(directory, [*compare, "--ensemble", "2"], ["--ensemble", "2"])
    refused(directory, [*compare, "--record", "x.csv"], ["--record", "lockstep"])
    refused(directory, [*compare, "--record", "x.csv", "--mode", "bits", "--from", "1"], ["--record", "--from"])
    refused(directory, [*compare, "--report", directory / "no/x.json"], ["--report", "no"])
    (directory / "scenarios").mkdir()
    scenario = directory / "scenarios/copy.json"
    scenario.write_text(json.dumps({"base": str(quick), "name": "copy", "description": "a test"}))
    bits = ["compare", scenario, "--candidate", "cpu", "--precision", "float", "--threads", "1", "--mode", "bits"]
    refused(directory, bits, ["--mode bits", "hashes/copy.float.csv"])
    (directory / "hashes").mkdir()
    hashes = directory / "hashes/copy.float.csv"
    bits += ["--frames", "2"]
    program.run(*bits, "--record", hashes)
    text = hashes.read_text()
    flipped = text[:-2] + ("0" if text[-2] != "0" else "1") + "\n"
    for content, code in [(text, 0), (flipped, 3)]:
        hashes.write_text(content)
        report = directory / "report.json"
        program.run(*bits, "--report", report, code=code)
        expect(program.read_json(report)["passed"] == (code == 0), "the verdict expected in the report")
    hashes.write_text(text.replace("scenario copy", "scenario other"))
    refused(directory, bits, [hashes, "line 1", "another scenario (other)"])
    known = re.search("scenario_hash ([0-9a-f]{16})", text)[1]
    hashes.write_text(text.replace(known, known[::-1]))
    out, _ = program.run(*bits)
    expect("text has changed" in out, f"the same bits expected: {out}")


def check_suite(directory):
    full, file = directory / "full", directory / "file"
    full.mkdir()
    (full / "x").write_text("")
    file.write_text("")
    out = ["--out", "out"]
    refused(directory, ["verify", "--out", full], [full, "isn't empty"])
    refused(directory, ["verify", "--out", file], [file, "isn't empty"])
    refused(directory, ["verify", "--out", "/proc/out"], ["/proc/out", "cannot be made"])
    refused(directory, ["verify", *out, "--only", "x13"], ["--only", "x13", "L0", "EOS"])
    refused(directory, ["verify", *out, "--only", ""], ["--only", "()"])
    refused(directory, ["verify", *out, "--only", ","], ["--only", "(,)"])
    refused(directory, ["verify", "--only", "eq13,", *out], ["--only", "(eq13,)"])
    refused(directory, ["verify", *out, "--backend", "gpu"], ["--backend", "gpu"])
    refused(directory, ["verify", *out, "--precision", "half"], ["--precision", "half"])
    refused(directory, ["verify", *out, "--backend", "reference", "--precision", "float"], ["--precision", "float"])
    refused(directory, ["verify", *out, "--jobs", "-1"], ["--jobs", "-1"])
    refused(directory, ["verify", *out, "--quick", "--full"], ["--quick", "--full"])
    if not pathlib.Path("/dev/nvidiactl").exists():
        refused(directory, ["verify", *out, "--backend", "cuda"], ["--backend", "cuda"])
    baseline = ["verify", "--baseline", "--data", data]
    refused(directory, ["verify", "--record"], ["--record", "--baseline"])
    refused(directory, [*baseline, *out, "--record"], ["--record", "--out"])
    refused(directory, [*baseline, *out, "--full"], ["--baseline", "--full"])
    refused(directory, ["verify", *out, "--faults", "some"], ["--faults", "some"])
    refused(directory, ["verify", *out, "--faults", "ci"], ["--faults", "--sensitivity"])
    refused(directory, ["verify", *out, "--sensitivity", "--backend", "cpu"], ["--sensitivity", "--backend"])
    refused(directory, [*baseline, *out, "--only", "quack"], ["--only", "quack", "quick, paper_tc1"])
    refused(directory, ["verify", "--baseline", *out, "--data", directory], ["baseline.json", "No such file"])
    for text in ("", "{}", '{"version": 1, "commit": "", "scenarios": []}'):
        (directory / "baseline.json").write_text(text)
        refused(directory, ["verify", "--baseline", *out, "--data", directory], ["baseline.json", "not as it was written"])


fast = ["--backend", "cpu", "--precision", "float", "--threads", "1"]


def frames_of(run):
    return (run / "frames.csv").read_text().count("\n") - 1


def check_numbers(directory):
    """Every whole number is decimal, whatever it begins with; what isn't whole, or is out of range, is refused."""
    for number, word in enumerate(("010", "+10", "1e1", "10.0", "0.1e2", "100e-1")):
        run = directory / f"run{number}"
        program.run("run", quick, *fast, "--frames", word, "--out", run)
        expect(frames_of(run) == 10, f"--frames {word}: {frames_of(run)} frames instead of 10")
    wrong = ("0x10", "1e30", "99999999999999999999", "-99999999999999999999", "1,5", "1.5", "1e-1", "10 ", " 10", "ten",
             "", ".", "e1", "1e", "1e+", "+-1", "--1", "inf", "nan", "1_000", "0b11", "1e999999999999", "\u0663")
    options = [["run", quick, "--out", "out", "--frames"], ["run", quick, "--out", "out", "--backend", "cpu", "--threads"],
               ["run", quick, "--out", "out", "--backend", "cuda", "--block-size"],
               ["compare", quick, "--candidate", "cpu", "--frames"], ["compare", quick, "--candidate", "cpu", "--from"],
               ["compare", quick, "--candidate", "cpu", "--mode", "free", "--ensemble"],
               ["verify", "--out", "out", "--jobs"], ["reproduce", "table1", "--out", "out", "--seeds"],
               ["reproduce", "table1", "--out", "out", "--first-seed"], ["reproduce", "table1", "--out", "out", "--jobs"]]
    for option in options:
        for word in wrong:
            refused(directory, [*option, word], [option[-1]])
    for word in ("0", "-1", "inf", "nan", "soon", "1e7"):
        refused(directory, ["run", quick, "--out", "out", "--progress", word], ["--progress"])
    # As JSON Schema takes them, so does the program.
    scenario = directory / "numbers.json"
    for text, good in (("3e3", True), ("20.0", True), ("2000e-2", True), ("20.5", False), ("1e18", False), ("1e400", False)):
        scenario.write_text('{"base": "%s", "assumed": {"time.frames": "a test"}, "time": {"frames": %s}}' % (quick, text))
        program.run("info", scenario, code=0 if good else 2)
        expect(text == "1e400" or validator.is_valid(json.loads(scenario.read_text())) == good, f"the schema of {text}")


def check_idle_options(directory):
    """An option that would do nothing is refused, not passed over."""
    run, compare = ["run", quick, "--out", "out"], ["compare", quick, "--candidate"]
    refused(directory, [*run, "--threads", "2"], ["--threads", "reference", "cpu"])
    refused(directory, [*run, "--backend", "cpu", "--block-size", "64"], ["--block-size", "cpu", "cuda"])
    refused(directory, [*compare, "reference", "--threads", "2"], ["--threads"])
    refused(directory, [*compare, "cpu", "--ensemble", "5"], ["--ensemble", "lockstep", "free"])
    refused(directory, ["info", quick, "--schema"], ["--schema", "SCENARIO"])
    refused(directory, ["verify", "--baseline", "--jobs", "2", "--out", "out"], ["--baseline", "--jobs"])
    refused(directory, [*run, "--quiet", "--progress", "1"], ["--quiet", "--progress"])
    refused(directory, [*compare, "cpu", "--report", quick], [quick, "scenario itself"])


def check_paths(directory):
    """Every path as it is typed: slashes, steps back, blanks, quotes, brackets, names of subcommands, empty, too long."""
    for number, name in enumerate(("new/", "deep/new//", "steps/x/..", "a b", "it's", '"', "[a,b]", "run", "-x", "$(x)", "#1")):
        where = directory / f"place{number}"
        where.mkdir()
        out, _ = program.run("run", quick, *fast, "--frames", "1", f"--out={name}", cwd=where)
        expect(f"Results in {'steps' if '..' in name else name.rstrip('/')}\n" in out, f"{name}: {out}")
        place = where / ("steps" if ".." in name else name)
        expect(frames_of(place) == 1, f"--out {name}: no run")
        expect(files_below(where)[0] in (str(place), str(where / "deep")), f"--out {name}: {files_below(where)}")
    for name in ("run", "info", "verify", "[x,y]", "a b.json"):
        (directory / name).write_text(quick.read_text().replace("base.json", str(base)))
        program.run("info", name, cwd=directory)
    long, loop = "x" * 300, directory / "loop"
    loop.symlink_to(loop)
    for name in (long, "x/" * 3000, "loop/x"):
        for arguments in (["run", quick, "--out", name], ["run", "--resume", "--out", name], ["info", name],
                          ["verify", "--out", name], ["compare", quick, "--candidate", "cpu", "--report", name]):
            said = {long: "name too long", "loop/x": "symbolic links"}.get(name, "name")
            refused(directory, arguments, [said])
    empty = ""
    for arguments in (["run", quick, "--out", empty], ["run", empty], ["info", empty], ["verify", "--out", empty],
                      ["compare", quick, "--candidate", "cpu", "--report", empty], ["reproduce", "table1", "--out", empty],
                      ["compare", quick, "--candidate", "cpu", "--mode", "bits", "--record", empty],
                      ["verify", "--baseline", "--data", empty]):
        refused(directory, arguments, ["empty name"])
    for name in ("", ".", "..", "a/b", "a\0b", "a\nb"):
        (directory / "named.json").write_text(json.dumps({"base": str(quick), "name": name}))
        refused(directory, ["run", "named.json"], ["named.json: name"])
    for name in ("", "a\0b"):
        (directory / "based.json").write_text(json.dumps({"base": name}))
        refused(directory, ["info", "based.json"], ["based.json: base"])
    refused(directory, ["run", quick, "--out", "no/such/../../loop/x/y"], ["loop"])


def check_sizes(directory):
    """What is too large or too deep is refused before memory is taken for it."""
    deep = directory / "deep.json"
    for text in ('{"time": ' + "[" * 100000 + "]" * 100000 + "}", '{"a":' * 100000 + "1" + "}" * 100000, "[" * 100000):
        deep.write_text(text)
        refused(directory, ["info", deep], [deep, "deeper than 100"])
    with open(directory / "large.json", "wb") as file:
        file.truncate(65 << 20)
    refused(directory, ["info", "large.json"], ["large.json", "64 MiB"])
    refused(directory, ["info", "/dev/zero"], ["/dev/zero", "64 MiB"])
    refused(directory, ["reproduce", "table1", "--out", "out", "--seeds", "2000000000"], ["--seeds"])


def check_pipes(directory):
    """A complete scenario may come out of a pipe, and a report may go into one, a device, or through a link."""
    complete = json.dumps(program.complete(quick))
    for place in ("/dev/stdin", "/proc/self/fd/0"):
        found = subprocess.run([program.program, "info", place], input=complete, text=True, capture_output=True)
        expect(found.returncode == 0 and "hash" in found.stdout, f"{place}: {found.stderr}")
    fifo, target, link, loose = (directory / name for name in ("fifo", "target.json", "link.json", "loose.json"))
    os.mkfifo(fifo)
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target.name)
    loose.symlink_to("made.json")
    compare = ["compare", quick, "--candidate", "cpu", "--frames", "1"]
    got = []
    reader = threading.Thread(target=lambda: got.append(fifo.read_text()))
    reader.start()
    program.run(*compare, "--report", fifo)
    reader.join(20)
    expect(got and json.loads(got[0])["passed"], "the report expected at the other end of the pipe")
    expect(stat.S_ISFIFO(fifo.stat().st_mode), "the pipe has become something else")
    for place in (link, loose):
        program.run(*compare, "--report", place)
        expect(place.is_symlink() and program.read_json(place)["passed"], f"{place}: a link to the report expected")
    expect(stat.S_IMODE(target.stat().st_mode) == 0o640, "the file's rights expected as they were")
    out, _ = program.run(*compare, "--report", "/dev/stdout")
    expect(out.rstrip().endswith("}") and out.index("{") > 0, f"text and report expected: {out}")
    with open(directory / "both", "w") as both:
        subprocess.run([program.program, *map(str, compare), "--report", "/dev/stdout"], stdout=both, check=True)
    expect((directory / "both").read_text() == out, "nothing of a redirected output may be lost")
    if os.getuid() == 0:
        device = directory / "null"
        os.mknod(device, 0o666 | stat.S_IFCHR, os.makedev(1, 3))
        program.run(*compare, "--report", device)
        expect(stat.S_ISCHR(device.stat().st_mode), "the device has become something else")
    refused(directory, [*compare, "--report", directory], [directory, "a directory"])
    refused(directory, [*compare, "--report", f"{directory}/new.json/"], ["no name of a file"])


def check_manifests(directory):
    """A manifest that isn't as it was written, in whatever way."""
    run = directory / "run"
    program.run("run", quick, *fast, "--frames", "2", "--out", run)
    text = (run / "manifest.json").read_text()
    record = json.loads(text)
    for key in ("backend", "precision", "started", "resumed_at_frames", "made_by"):
        for value in (5, {"a": [1]}, [[]] if key != "made_by" else "x"):
            (run / "manifest.json").write_text(json.dumps({**record, key: value}))
            refused(directory, ["run", "--resume", "--out", run], [run / "manifest.json"])
    for bad in ("[]", "5", "null", "[" * 1000 + "]" * 1000):
        (run / "manifest.json").write_text(bad)
        refused(directory, ["run", "--resume", "--out", run], [run / "manifest.json"])


def check_notes(directory):
    """What is allowed and still not meant: particles of another size than those that the values were chosen for."""
    for name, noted in (("paper_tc1", False), ("paper_tc4", True)):
        out, _ = program.run("info", data / f"scenarios/{name}.json")
        expect(("Note: rupture.impact_mass_kg" in out) == noted, f"info of {name}: {out}")
    heavy = directory / "heavy.json"
    heavy.write_text(json.dumps(program.changed(quick, rupture={"impact_mass_kg": 100})))
    _, err = program.run("run", heavy, *fast, "--frames", "1", "--out", directory / "out")
    expect("note: rupture.impact_mass_kg (100 kg)" in err, f"run: {err}")


def check_shipped_scenarios(_):
    for scenario in sorted((data / "scenarios").glob("*.json")):
        errors = [error.message for error in validator.iter_errors(program.read_json(scenario))]
        expect(not errors, f"{scenario}: {errors}")
        _, err = program.run("info", scenario)
        expect(err == "", f"{scenario}: {err}")


program.check_all(check_shipped_scenarios, check_files, check_arguments, check_checkpoints, check_comparisons, check_suite,
                  check_numbers, check_idle_options, check_paths, check_sizes, check_pipes, check_manifests, check_notes)
