# SPDX-License-Identifier: Apache-2.0
"""What the tests of the program from the outside share: scenarios with changes, runs of the program, and what is
expected of them.

usage of each: check_X.py PROGRAM DATA
"""
import json
import pathlib
import subprocess
import sys
import tempfile

program, data = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
quick = data / "scenarios/quick.json"
failures = []


def expect(good, what):
    if not good:
        failures.append(what)


def start(*arguments, **settings):
    """The program, running, with its output in pipes."""
    return subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            **settings)


def run(*arguments, code=0, **settings):
    """Output and errors of the program, which has to end with this exit code."""
    process = start(*arguments, **settings)
    out, err = process.communicate()
    expect(process.returncode == code,
           f"{' '.join(map(str, arguments))}: exit code {process.returncode} instead of {code}: {out}{err}")
    return out, err


def changed(base, **groups):
    """A scenario on top of another; every change of a value has its reason."""
    paths = [f"{g}.{k}" for g, values in groups.items() if isinstance(values, dict) for k in values]
    return {"base": str(base), **groups, "assumed": {path: "a test" for path in paths}}


def complete(file):
    """A scenario with all its values: what it builds on, with what it says otherwise."""
    scenario = read_json(file)
    below = complete(file.parent / scenario.pop("base")) if "base" in scenario else {}
    for key, value in scenario.items():
        below[key] = {**below.get(key, {}), **value} if isinstance(value, dict) else value
    below.pop("$schema", None)
    return below


def read_json(file):
    return json.loads(file.read_text())


def check_all(*checks):
    """Runs each check in a directory of its own, and ends with what failed."""
    for check in checks:
        with tempfile.TemporaryDirectory() as scratch:
            check(pathlib.Path(scratch))
    print("\n".join(failures) or "all checks passed")
    sys.exit(bool(failures))
