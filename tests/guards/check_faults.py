# SPDX-License-Identifier: Apache-2.0
"""Every place for planted faults is in the backends that common/fault.hpp says, and no hook is anywhere else.

  - a place for `both` is hooked, `fault(eqNN_name, ...)`, under reference/ and cuda/, one for `optimized` under cuda/;
  - nothing else includes common/fault.hpp, but what plants the faults and their tests.
"""
import re

import guard

PLACE = re.compile(r"PLACE\((\w+), \w+, (both|optimized),")
HOOK = re.compile(r"\bfault\((\w+),")
ALLOWED = re.compile(
    r"(reference|cuda)/|common/(planted_)?fault\.hpp|verification/sensitivity/|tests/verification/test_(planted_)?fault\.cpp")


def check(root):
    rows = PLACE.findall((root / "common/fault.hpp").read_text(encoding="utf-8"))
    findings = []
    for room in ("reference", "cuda"):
        text = "\n".join(file.read_text(encoding="utf-8") for file in guard.sources(root, room))
        hooked = set(HOOK.findall(text))
        for place, backends in rows:
            if (place in hooked) != (room == "cuda" or backends == "both"):
                findings.append(f"{place}: {'hooked' if place in hooked else 'not hooked'} in {room}/")
        unknown = sorted(hooked - {place for place, _ in rows})
        findings += [f"{place}: hooked in {room}/, not in common/fault.hpp" for place in unknown]
    for room in guard.ROOMS:
        for file in guard.sources(root, room):
            name = file.relative_to(root).as_posix()
            if "common/fault.hpp" in file.read_text(encoding="utf-8") and not ALLOWED.match(name):
                findings.append(f"{name}: includes common/fault.hpp")
    return findings


FAULTS = [
    ("reference/growth.hpp", "fault(eq22_radius, R)", "R", "not hooked in reference/"),
    ("cuda/growth.hpp", "fault(eq22_radius, R)", "R", "not hooked in cuda/"),
    ("reference/growth.hpp", "eq22_radius", "eq22_radios", "eq22_radios"),
    ("common/fault.hpp", "eq22_radius, factor, both", "eq22_radius, factor, optimized", "hooked in reference/"),
    ("common/vessel/geometry.hpp", "#pragma once", '#pragma once\n#include "common/fault.hpp"', "common/vessel/geometry.hpp"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
