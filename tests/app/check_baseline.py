# SPDX-License-Identifier: Apache-2.0
"""A baseline is recorded, found again, and missed when the model, the record or the scenario's meaning changes."""
import json
import re
import shutil

import program
from program import data, expect, read_json

frames = 20


def fnv1a(text):
    number = 0xCBF29CE484222325
    for byte in text.encode():
        number = (number ^ byte) * 0x100000001B3 % 2**64
    return f"{number:016x}"


def check_citation(_):
    version = program.run("--version")[0].split()[-1]
    commit = re.search(r"commit +(\S+)", program.run("info")[0])[1]
    shipped = read_json(data / "baseline.json")
    cite, _ = program.run("info", "--cite", cwd=data.parent)
    digest = fnv1a("".join(r["digest"] for s in shipped["scenarios"] for r in s["runs"]))
    sentence = f"version {version}, commit {commit}, digest of the baseline {digest}"
    entry = rf"@software\{{aneurysm_{version.replace('.', '_')},.*version = \{{{version}\}}.*{commit}.*{digest}.*@article\{{"
    expect(sentence in cite and re.search(entry, cite, re.DOTALL), f"'{sentence}', also as BibTeX, expected: {cite}")
    program.run("info", "--cite", data / "scenarios/quick.json", code=2)
    page = (data / "../docs/verification.md").read_text()
    for s in shipped["scenarios"]:
        for r in s["runs"]:
            row = rf"\| `{s['name']}` \| [^|]*{r['recorded_as']}[^|]* \| {r['frames']} \| `{r['digest']}` \|"
            expect(re.search(row, page), f"docs/verification.md: a row {row} expected")
            expect(r["digest"] in cite, f"info --cite: digest {r['digest']} expected")


def check_record(scratch):
    copy = scratch / "data"

    def verify(*arguments, code=0):
        return program.run("verify", "--baseline", "--data", copy, *arguments, code=code)

    def compare(code, label, *arguments):
        out = scratch / label
        text, error = verify("--out", out, *arguments, code=code)
        if (out / "baseline.json").exists():
            runs = read_json(out / "baseline.json")["runs"]
            expect(all((r["verdict"] == "identical") == (r["remark"] == "") for r in runs), f"{label}: one verdict expected")
            expect((out / "baseline.txt").read_text() == text, f"{label}: the same text expected")
        return text + error

    def change_scenario(**groups):
        scenario = read_json(data / "scenarios/quick.json")
        for group, values in groups.items():
            scenario.setdefault(group, {}).update(values)
            scenario["assumed"].update({f"{group}.{key}": "a test" for key in values})
        (copy / "scenarios/quick.json").write_text(json.dumps(scenario))

    shutil.copytree(data / "scenarios", copy / "scenarios")
    (copy / "hashes").mkdir()
    runs = [{"recorded_as": name, "frames": frames} for name in ("reference", "double", "float")]
    record = {"version": "", "commit": "",
              "scenarios": [{"name": "quick", "file": "scenarios/quick.json", "runs": runs}]}
    (copy / "baseline.json").write_text(json.dumps(record))
    expect("never recorded" in compare(2, "nothing recorded"), "nothing recorded: said")
    text, _ = verify("--record")
    expect(text.count(": new\n") == 3, f"three new runs expected: {text}")
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

    scenario = copy / "scenarios/quick.json"
    scenario.write_text(json.dumps({**read_json(scenario), "description": "in other words"}))
    text = compare(0, "other words")
    expect(text.count("text has changed") == 3, f"another text, the same bits expected: {text}")
    change_scenario(fluid={"viscosity_pa_s": 0.0041})
    text = compare(3, "other viscosity")
    expect(text.count("DIFFERS") == 3 and text.count("from frame 1 on (") == 3, f"three differences expected: {text}")
    expect(text.count("kinetic energy [J] by") == 3, f"by how much expected: {text}")
    change_scenario(pressure={"blow_up_density_ratio": 1.001})
    text = compare(3, "blow-up")
    expect(text.count("DIFFERS") == 3 and text.count(": stopped: frame ") == 3, f"three ends expected: {text}")
    _, error = verify("--record", code=1)
    expect("as it was" in error, f"no record of a failed run expected: {error}")
    expect((copy / "baseline.json").read_text() == recorded, "the baseline as it was expected")
    change_scenario(fluid={"viscosity_pa_s": 0.0041})
    text, _ = verify("--record")
    expect(text.count("from frame 1 on (") == 3, f"what changes expected: {text}")
    compare(0, "recorded again")
    change_scenario()
    verify("--record")
    expect(read_json(copy / "baseline.json") == json.loads(recorded), "the first record again expected")

    hashes = copy / "hashes/quick.double.csv"
    hashes.write_text(hashes.read_text().replace("\n3,", "\n3,0", 1))
    expect(str(hashes) in compare(2, "forged"), "the file with other hashes named")


program.check_all(check_citation, check_record)
