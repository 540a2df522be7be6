# SPDX-License-Identifier: Apache-2.0
"""A baseline is recorded, found again, and missed when the model, the record or the scenario's meaning changes.

usage: check_baseline.py PROGRAM DATA
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

program, data = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
failures = []
frames = 20


def expect(good, what):
    if not good:
        failures.append(what)


def verify(*arguments):
    done = subprocess.run([program, "verify", "--baseline", "--data", copy, *map(str, arguments)], capture_output=True,
                          text=True)
    return done.returncode, done.stdout, done.stderr


def compare(expected_code, label, *arguments):
    out = scratch / label
    code, text, error = verify("--out", out, *arguments)
    expect(code == expected_code, f"{label}: exit code {code} instead of {expected_code}: {text}{error}")
    if (out / "baseline.json").exists():
        runs = json.loads((out / "baseline.json").read_text())["runs"]
        expect(all((r["verdict"] == "identical") == (r["remark"] == "") for r in runs), f"{label}: one verdict expected")
        expect((out / "baseline.txt").read_text() == text, f"{label}: the same text expected")
    return text + error


def change_scenario(**groups):
    file = copy / "scenarios/quick.json"
    scenario = json.loads((data / "scenarios/quick.json").read_text())
    for group, value in groups.items():
        if isinstance(value, dict):
            scenario.setdefault(group, {}).update(value)
            scenario["assumed"].update({f"{group}.{key}": "a test" for key in value})
        else:
            scenario[group] = value
    file.write_text(json.dumps(scenario))


version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[-1]
cited = (data / "../CITATION.cff").read_text()
expect(f"\nversion: {version}\n" in cited, f"CITATION.cff: version {version} expected")
shipped_baseline = json.loads((data / "baseline.json").read_text())
expect(shipped_baseline["version"] == version, f"a baseline of {version} expected: {shipped_baseline['version']}")
page = (data / "../docs/verification.md").read_text()
for s in shipped_baseline["scenarios"]:
    for r in s["runs"]:
        row = rf"\| `{s['name']}` \| [^|]*{r['recorded_as']}[^|]* \| {r['frames']} \| `{r['digest']}` \|"
        expect(re.search(row, page), f"docs/verification.md: a row {row} expected")

with tempfile.TemporaryDirectory() as folder:
    scratch, copy = pathlib.Path(folder), pathlib.Path(folder) / "data"
    shutil.copytree(data / "scenarios", copy / "scenarios")
    (copy / "hashes").mkdir()
    runs = [{"recorded_as": name, "frames": frames} for name in ("reference", "double", "float")]
    record = {"version": "", "commit": "",
              "scenarios": [{"name": "quick", "file": "scenarios/quick.json", "runs": runs}]}
    (copy / "baseline.json").write_text(json.dumps(record))
    expect("never recorded" in compare(2, "nothing recorded"), "nothing recorded: said")
    code, text, _ = verify("--record")
    expect(code == 0 and text.count(": new\n") == 3, f"three new runs expected: {text}")
    recorded = (copy / "baseline.json").read_text()
    shipped = (data / "hashes/quick.float.csv").read_text().splitlines()
    made = (copy / "hashes/quick.float.csv").read_text().splitlines()
    expect(made[4:] == shipped[4 : 5 + frames], "the shipped hashes expected")

    text = compare(0, "again")
    expect(text.count("identical to the baseline of") == 3 and text.endswith("PASS\n"), f"three identical: {text}")
    expect("cuda" in text, f"cuda expected, run or not: {text}")
    text = compare(0, "one", "--only", "quick", "--backend", "cpu", "--precision", "float")
    expect(text.count("\n") == 2 and text.startswith("quick, cpu float: identical"), f"one run expected: {text}")
    expect("quick" in compare(2, "no such scenario", "--only", "x"), "no such scenario: the others named")

    change_scenario(description="in other words")
    text = compare(0, "other words")
    expect(text.count("text has changed") == 3, f"another text, the same bits expected: {text}")
    change_scenario(fluid={"viscosity_pa_s": 0.0041})
    text = compare(3, "other viscosity")
    expect(text.count("DIFFERS") == 3 and text.count("from frame 1 on (") == 3, f"three differences expected: {text}")
    expect(text.count("kinetic energy [J] by") == 3, f"by how much expected: {text}")
    change_scenario(pressure={"blow_up_density_ratio": 1.001})
    text = compare(3, "blow-up")
    expect(text.count("DIFFERS") == 3 and text.count(": stopped: frame ") == 3, f"three ends expected: {text}")
    code, _, error = verify("--record")
    expect(code == 1 and "as it was" in error, f"no record of a failed run expected: {error}")
    expect((copy / "baseline.json").read_text() == recorded, "the baseline as it was expected")
    change_scenario(fluid={"viscosity_pa_s": 0.0041})
    code, text, _ = verify("--record")
    expect(code == 0 and text.count("from frame 1 on (") == 3, f"what changes expected: {text}")
    compare(0, "recorded again")
    change_scenario()
    verify("--record")
    expect(json.loads((copy / "baseline.json").read_text()) == json.loads(recorded), "the first record again expected")

    hashes = copy / "hashes/quick.double.csv"
    hashes.write_text(hashes.read_text().replace("\n3,", "\n3,0", 1))
    expect(str(hashes) in compare(2, "forged"), "the file with other hashes named")

print("\n".join(failures) or "all checks passed")
sys.exit(bool(failures))
