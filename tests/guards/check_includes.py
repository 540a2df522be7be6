# SPDX-License-Identifier: Apache-2.0
"""The arrows between the rooms: common <- {reference, cuda, analytic, output} <- verification <- app, and tests and benchmarks.

reference, cuda and analytic never include one another, so that an error has to be made three times to stay hidden;
only analytic, and what compares, may use GSL.
"""
import re

import guard

MIDDLE = {"reference", "cuda", "analytic", "output"}
MAY_INCLUDE = {
    "common": {"common"},
    **{room: {"common", room} for room in MIDDLE},
    "verification": {"common", "verification"} | MIDDLE,
    "app": {"common", "verification", "app"} | MIDDLE,
    "benchmarks": {"common", "verification", "benchmarks"} | MIDDLE,
    "tests": {"common", "verification", "app", "tests"} | MIDDLE,
}
WITHOUT_GSL = {"common", "reference", "cuda", "output"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def check(root):
    findings = []
    for room, allowed in MAY_INCLUDE.items():
        for file in guard.sources(root, room):
            name = file.relative_to(root)
            for quote, target in INCLUDE.findall(file.read_text(encoding="utf-8")):
                head = target.split("/")[0]
                if quote == '"' and head not in guard.ROOMS:
                    findings.append(f"{name}: include {target!r} must start with a room of the repository root")
                elif head in guard.ROOMS and head not in allowed:
                    findings.append(f"{name}: {room} must not include {target!r}")
                elif head == "gsl" and room in WITHOUT_GSL:
                    findings.append(f"{name}: {room} must not use GSL ({target!r})")
    return findings


FIRST = "#pragma once"
FAULTS = [
    ("common/vec3.hpp", FIRST, '#include "reference/growth.hpp"', "common must not include"),
    ("reference/growth.hpp", FIRST, '#include "analytic/growth.hpp"', "reference must not include"),
    ("reference/growth.hpp", FIRST, "#include <analytic/growth.hpp>", "reference must not include"),
    ("reference/growth.hpp", FIRST, "# include <gsl/gsl_math.h>", "reference must not use GSL"),
    ("reference/growth.hpp", FIRST, '#include "output/anything.hpp"', "reference must not include"),
    ("analytic/growth.hpp", FIRST, '#include "reference/growth.hpp"', "analytic must not include"),
    ("analytic/growth.hpp", FIRST, '#include "tests/support.hpp"', "analytic must not include"),
    ("analytic/growth.hpp", FIRST, '#include "../reference/growth.hpp"', "must start with a room"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
