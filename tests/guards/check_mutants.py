# SPDX-License-Identifier: Apache-2.0
"""Every place of verification/sensitivity/mutants.txt fits the sources, and no hook is anywhere but there.

  - the text of each site is in its file once, and hooks of a place are in the backends that its row says, as plant.py demands;
  - reference/ and cuda/ say nothing of mutants, and only what plants them and its tests sees the hook;
  - what is built once for both programs, the suite and its checks, includes no formula of a backend by any way.
"""
import re
import sys
from pathlib import Path

import guard

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "verification/sensitivity"))
import plant  # noqa: E402

FORMULAS = ("reference", "cuda")
WORDS = re.compile(r"mutant|sensitivity|\bin_(reference|device)\(")
BUILT_ONCE = ("verification/suite", "verification/checks")
INCLUDE = re.compile(r'^#include "(.+)"', re.MULTILINE)
MAY_SEE = re.compile(r"verification/sensitivity/|tests/verification/test_(hook|sensitivity)\.cpp")


def included(root, file):
    """All that a file includes, by any way, in the order of a search."""
    found = [file]
    for name in found:
        if (root / name).is_file():
            found += [n for n in INCLUDE.findall((root / name).read_text(encoding="utf-8")) if n not in found]
    return found[1:]


def check(root):
    try:
        _, rows = plant.planted(root)
    except plant.Unfit as error:
        return [str(error)]
    hooked = {file for row in rows for file, _ in row.sites}
    findings = []
    for room in guard.ROOMS:
        for file in guard.sources(root, room):
            name, text = file.relative_to(root).as_posix(), file.read_text(encoding="utf-8")
            if room in FORMULAS and WORDS.search(text):
                findings.append(f"{name}: speaks of mutants")
            if "verification/sensitivity/hook.hpp" in text and not MAY_SEE.match(name):
                findings.append(f"{name}: includes the hook")
    for folder in BUILT_ONCE:
        for file in guard.sources(root, folder):
            name = file.relative_to(root).as_posix()
            findings += [f"{name}: reaches {n}" for n in included(root, name) if n in hooked]
    return findings


THINNING = "return h - h / R * sigma * dR;"
SITE = "cuda/growth.hpp: return h - h / `R` * sigma * dR;"
FAULTS = [
    ("reference/growth.hpp", THINNING, "return h - h / R * dR * sigma;", "0 times"),
    ("cuda/growth.hpp", THINNING, THINNING + THINNING, "2 times"),
    ("reference/growth.hpp", THINNING, THINNING + " // mutants.txt", "speaks of mutants"),
    ("common/vessel/geometry.hpp", "#pragma once", '#include "verification/sensitivity/hook.hpp"', "includes the hook"),
    ("verification/checks/checks.hpp", "#pragma once", '#include "verification/bounds/step.hpp"', "reaches reference/"),
    (plant.TABLE, SITE, SITE.replace("`", ""), "between backticks"),
    (plant.TABLE, SITE, SITE.replace("`R`", "`R"), "between backticks"),
    (plant.TABLE, SITE, SITE.replace("`R`", "R * `sigma`").replace("R * sigma *", "R *"), "0 times"),
    (plant.TABLE, SITE, SITE.replace("h / `R`", "`h / R`").replace("- `h", "`- h"), "overlap"),
    (plant.TABLE, SITE, SITE.replace("growth.hpp", "grown.hpp"), "there is no reference/grown.hpp"),
    (plant.TABLE, "eq22_radius factor both", "eq22_radius factor cuda", "for cuda, hooked in cuda, reference"),
    (plant.TABLE, "eq03_ghosts vector cuda", "eq03_ghosts vector both", "for both, hooked in cuda"),
    (plant.TABLE, "eq22_radius factor both:", "eq22_radius factor both", "neither a row nor a site"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
