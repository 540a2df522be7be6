# SPDX-License-Identifier: Apache-2.0
"""`aneurysm reproduce` from the outside: the items that need no long runs, what they write, bad input, Ctrl-C.

usage: check_reproduce.py PROGRAM DATA
"""
import csv
import html.parser
import json
import math
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

program, data = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
scratch_directory = tempfile.TemporaryDirectory()
scratch = pathlib.Path(scratch_directory.name)
failures = []


def expect(good, what):
    if not good:
        failures.append(what)


def reproduce(*arguments, code=0):
    result = subprocess.run([program, "reproduce", *map(str, arguments)], capture_output=True, text=True,
                            cwd=data.parent)
    expect(result.returncode == code, f"{arguments}: exit code {result.returncode} instead of {code}: {result.stderr}")
    return result


class Page(html.parser.HTMLParser):
    """Titles and the number of embedded PNG pictures."""

    def __init__(self):
        super().__init__()
        self.ids = []
        self.pictures = 0

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "h2":
            self.ids.append(attributes.get("id"))
        if tag == "img":
            self.pictures += attributes["src"].startswith("data:image/png;base64,iVBOR")


def check_items():
    out = scratch / "paper"
    result = reproduce("table1", "table2", "fig10", "--out", out)
    expect("reproduction.html" in result.stdout, "the page isn't named")
    page = Page()
    page.feed((out / "reproduction.html").read_text())
    expect(page.ids == ["table1", "table2", "fig10"], f"sections {page.ids}")
    expect(page.pictures == 1, f"{page.pictures} pictures")
    expect((out / "fig10/fig10.png").read_bytes().startswith(b"\x89PNG"), "fig10.png is no PNG")
    with open(out / "table1/table1.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    expect(len(rows) == 13 and all(row["same"] == "yes" for row in rows), f"table1.csv: {rows}")
    calibrated = json.loads((data / "scenarios/calibrated.json").read_text())
    base_scenario = json.loads((data / "scenarios/base.json").read_text())
    growth = base_scenario["aneurysm"]["base_width_radii"] / 2 / calibrated["aneurysm"]["initial_radius_radii"]
    with open(out / "fig10/fig10.csv", newline="") as file:
        for row in csv.DictReader(file):
            # the closed form worked out here
            ratio = float(row["(R/R_0)^-sigma"])
            base = 2 ** (math.log2(ratio) / -float(row["sigma"]))
            expect(abs(base / growth - 1) < 1e-4, f"fig10.csv: R/R_0 {base}, not {growth}")
            expect(abs(float(row["h / h_0 by (22)"]) / ratio - 1) < 1e-3, f"fig10.csv: {row}")
    for item in ("table1", "table2", "fig10"):
        section = json.loads((out / item / f"{item}.json").read_text())
        expect(section["claims"] and all(claim["holds"] for claim in section["claims"]), f"{item}: {section['claims']}")


def check_calibrated_values():
    """What follows from other values is what its reason in the scenario says."""
    scenario = json.loads((data / "scenarios/calibrated.json").read_text())
    r_0, inlet = scenario["vessel"]["radius_m"], scenario["inlet"]
    v_0, cycle = inlet["peak_velocity_m_s"], 0.8

    def near(found, formula, digits, what):
        expect(abs(found - formula) <= 0.5 * 10**-digits * 1.001, f"calibrated.json: {what}: {found}, not {formula}")

    near(scenario["fluid"]["viscosity_pa_s"], 1000 * v_0 * 2 * r_0 / 100, 3, "viscosity at Re = 100")
    length = 11 * r_0
    near(scenario["outlet"]["pressure_pa"], 1000 * length * 2 * math.pi * v_0 / cycle + 1000 * v_0**2 / 2, -3, "outlet")
    times = inlet["table_time_s"]
    expect(times == [round(0.02 * k, 2) for k in range(40)], f"calibrated.json: times {times}")
    for t, v in zip(times, inlet["table_velocity_m_s"], strict=True):
        from_peak = (t - 0.72 + cycle / 2) % cycle - cycle / 2
        systole = math.cos(math.pi * from_peak / 0.3) ** 2 if abs(from_peak) < 0.15 else 0
        near(v, v_0 * (1 + systole) / 2, 4, f"velocity at {t} s")


def check_bad_input():
    expect("ITEM: table5 not in {all,table1" in reproduce("table5", "--out", scratch / "x", code=2).stderr, "table5")
    expect("--backend" in reproduce("fig9", "--backend", "gpu", "--out", scratch / "y", code=2).stderr, "--backend gpu")
    reproduce("table1", "--seeds", 0, "--out", scratch / "z", code=2)


def check_interruption():
    out = scratch / "interrupted"
    process = subprocess.Popen([program, "reproduce", "fig9", "--seeds", "1", "--out", str(out)], cwd=data.parent,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    frames = out / "runs/calibrated_unbreakable_seed1/frames.csv"
    for _ in range(1200):
        if frames.exists() and frames.read_text().count("\n") > 20:
            break
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    errors = process.communicate()[1]
    expect(process.returncode == 130, f"interrupted: exit code {process.returncode}: {errors}")
    manifest = json.loads((frames.parent / "manifest.json").read_text())
    expect(manifest["status"] == "interrupted" and manifest["frames"] > 20, f"manifest: {manifest['status']}")
    expect((frames.parent / "checkpoint.h5").exists(), "no checkpoint to go on from")


check_items()
check_calibrated_values()
check_bad_input()
check_interruption()
if failures:
    print("\n".join(failures))
    sys.exit(1)
print("the reproduction's command does what it says")
