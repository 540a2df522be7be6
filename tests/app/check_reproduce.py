# SPDX-License-Identifier: Apache-2.0
"""`aneurysm reproduce` from the outside: the items that need no long runs, what they write, bad input, Ctrl-C."""
import csv
import html.parser
import json
import math
import shutil
import signal
import time

import program
from program import data, expect, read_json


def reproduce(*arguments, code=0):
    return program.run("reproduce", *arguments, code=code, cwd=data.parent)


def read_rows(file):
    with open(file, newline="") as lines:
        return list(csv.DictReader(lines))


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


def check_items(scratch):
    out = scratch / "paper"
    items = ("table1", "table2", "fig10")
    text, _ = reproduce(*items, "--out", out)
    expect("reproduction.html" in text, "the page isn't named")
    page = Page()
    page.feed((out / "reproduction.html").read_text())
    expect(page.ids == list(items), f"sections {page.ids}")
    expect(page.pictures == 1, f"{page.pictures} pictures")
    expect((out / "fig10/fig10.png").read_bytes().startswith(b"\x89PNG"), "fig10.png is no PNG")
    rows = read_rows(out / "table1/table1.csv")
    expect(len(rows) == 13 and all(row["same"] == "yes" for row in rows), f"table1.csv: {rows}")
    start = read_json(data / "scenarios/calibrated.json")["aneurysm"]["initial_radius_radii"]
    growth = read_json(data / "scenarios/base.json")["aneurysm"]["base_width_radii"] / 2 / start
    for row in read_rows(out / "fig10/fig10.csv"):
        # the closed form worked out here
        ratio = float(row["(R/R_0)^-sigma"])
        base = 2 ** (math.log2(ratio) / -float(row["sigma"]))
        expect(abs(base / growth - 1) < 1e-4, f"fig10.csv: R/R_0 {base}, not {growth}")
        expect(abs(float(row["h / h_0 by (22)"]) / ratio - 1) < 1e-3, f"fig10.csv: {row}")
    for item in items:
        claims = read_json(out / item / f"{item}.json")["claims"]
        expect(claims and all(claim["holds"] for claim in claims), f"{item}: {claims}")


def check_text(scratch):
    """Claims that the equations decide, and the arithmetic of the errata, worked out here once more."""
    out = scratch / "paper"
    reproduce("text", "errata", "--out", out)
    scenario = read_json(data / "scenarios/calibrated.json")
    base = read_json(data / "scenarios/base.json")
    R_0 = scenario["aneurysm"]["initial_radius_radii"] * scenario["vessel"]["radius_m"]
    R = base["aneurysm"]["base_width_radii"] / 2 * scenario["vessel"]["radius_m"]
    claims = read_json(out / "text/text.json")["claims"]
    verdicts = [(claim["verdict"], claim["decided"]) for claim in claims]
    holds, excluded = ("holds", "by the equations"), ("cannot hold", "by the equations")
    expect(verdicts == [holds, holds, holds, excluded, holds, excluded, ("does not hold", "by measurement")],
           f"claims of the text: {verdicts}")
    expect(f"takes {1.6 * math.log(R / R_0):.4f}" in claims[5]["found"], f"(10): {claims[5]}")
    expect(f"to {1.1 * R / 0.4:.2f} of what" in claims[6]["found"], f"(23): {claims[6]}")
    first, *others = [float(row["P_c / Y"]) for row in read_rows(out / "text/text.csv")[:5]]
    for sigma, P_c in zip((0.3, 0.4, 0.5, 0.6), others, strict=True):
        # (13) and the integral of (22)
        law = (2 - sigma) / (1 + sigma) / (1.8 / 1.2) * (R / R_0) ** (0.2 - sigma)
        expect(abs(P_c / first / law - 1) < 1e-3, f"text.csv: sigma {sigma}: {P_c / first}, not {law}")
    # (21) with 400 N and dt = 0.001 s: rho_F a c / dt is 1.5e7 N/m, K_E A_E + K_C A_C is 16035.2 N
    dR = 400 / (scenario["growth"]["wall_mass_kg"] * 1e6 + 1.5e7 + 16035.2 / R)
    expected = [0, 0.125, 0.5, 0.003 / 1.6,
                4 * 5e-5 * 1e6 * 1.6 / (3 * 1.6e-3 * 0.003 * 1.4), 992.1, 1008,
                scenario["rupture"]["yield_limit_pa"], -5 / 3, 0.6 / 2.6, 0, 16035.2 / R, 1e6, 1000 * dR, 4e-4]
    for row, value in zip(read_rows(out / "errata/errata_3.csv"), expected, strict=True):
        expect(abs(float(row["value"]) - value) <= 1e-3 * abs(value), f"errata_3.csv: {row}, not {value}")


def check_calibrated_values(_):
    """What follows from other values is what its reason in the scenario says."""
    scenario = read_json(data / "scenarios/calibrated.json")
    r_0, inlet = scenario["vessel"]["radius_m"], scenario["inlet"]
    v_0, cycle = inlet["peak_velocity_m_s"], 0.8

    def near(found, formula, digits, what):
        expect(abs(found - formula) <= 0.5 * 10**-digits * 1.001, f"calibrated.json: {what}: {found}, not {formula}")

    near(scenario["fluid"]["viscosity_pa_s"], 1000 * v_0 * 2 * r_0 / 100, 3, "viscosity at Re = 100")
    times = inlet["table_time_s"]
    expect(times == [round(0.02 * k, 2) for k in range(40)], f"calibrated.json: times {times}")
    velocities = inlet["table_velocity_m_s"]
    # The parent of 6 r_0, and two daughters of 5 r_0 and half the inlet's flow each, whose r^3 is r_0^3 / 2.
    inertia = (6 + 5 * 2 ** (2 / 3) / 2) * r_0
    pull = max(1050 * (inertia * (v - after) / 0.02 + v**2) for v, after in zip(velocities, velocities[1:]))
    near(scenario["outlet"]["pressure_pa"] / pull, 1.29, 2, "outlet over the largest pull")
    for t, v in zip(times, velocities, strict=True):
        from_peak = (t - 0.72 + cycle / 2) % cycle - cycle / 2
        systole = math.cos(math.pi * from_peak / 0.3) ** 2 if abs(from_peak) < 0.15 else 0
        near(v, v_0 * (1 + systole) / 2, 4, f"velocity at {t} s")


def check_bad_input(scratch):
    out = ["--out", scratch / "out"]
    for arguments, named in [(["table5"], "ITEM: table5 not in {all,table1"), (["fig9", "--backend", "gpu"], "--backend"),
                             (["table1", "--seeds", 0], "--seeds")]:
        _, err = reproduce(*arguments, *out, code=2)
        expect(named in err, f"'{named}' expected: {err}")


def check_interruption(scratch):
    process = program.start("reproduce", "fig9", "--seeds", "1", "--out", scratch / "out", cwd=data.parent)
    run = scratch / "out/runs/calibrated_unbreakable_seed1"
    frames = run / "frames.csv"
    for _ in range(1200):
        if frames.exists() and frames.read_text().count("\n") > 20:
            break
        time.sleep(0.1)
    before = frames.stat().st_ino
    _, errors = reproduce("fig9", "--seeds", "1", "--out", scratch / "out", code=2)
    expect("another run writes here" in errors, f"a second one at once: {errors}")
    expect(frames.stat().st_ino == before, "the second reproduction touched the first one's run")
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate()
    expect(process.returncode == 130, f"interrupted: exit code {process.returncode}: {errors}")
    manifest = read_json(run / "manifest.json")
    expect(manifest["status"] == "interrupted" and manifest["frames"] > 20, f"manifest: {manifest['status']}")
    expect((run / "checkpoint.h5").exists(), "no checkpoint to go on from")


def check_short_runs(scratch):
    """A data folder of one's own, with runs that are too short for what Fig. 9 looks for."""
    folder = scratch / "data"
    shutil.copytree(data, folder)
    short = program.changed("quick.json", time={"frames": 80})
    (folder / "scenarios/calibrated.json").write_text(json.dumps({**short, "name": "calibrated"}))
    _, errors = reproduce("fig9", "--seeds", 1, "--data", folder, "--out", scratch / "out", code=2)
    expect("calibrated: time.frames: too few (80)" in errors, f"too few frames: {errors}")


program.check_all(check_items, check_text, check_calibrated_values, check_bad_input, check_interruption, check_short_runs)
