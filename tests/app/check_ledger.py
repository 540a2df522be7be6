# SPDX-License-Identifier: Apache-2.0
"""The tolerance ledger of a verification report: every bound says how it follows, every check says what it compares
with, every equation has a check.

usage: check_ledger.py DIRECTORY [--planted]
With --planted: plants faults in copies of the report and fails when one isn't found.
"""
import copy
import json
import pathlib
import re
import sys

SHORTEST = 20  # characters of a derivation
EXCUSES = re.compile(r"\b(tbd|todo|fixme|xxx|placeholder|guess\w*|picked|empirical\w*|by experience|seems|safety factor|"
                     r"just works|large enough|generous\w*)\b", re.IGNORECASE)
EVIDENCE = ("L0", "L1", "L2", "L3")
SOURCES = ("exact", "rounding", "truncation", "quadrature", "solver", "statistics", "nature")


def check_quantity(q, where):
    findings = []
    derivation = q.get("derivation", "")
    if len(derivation.strip()) < SHORTEST or len(derivation.split()) < 3:
        findings.append(f"{where}: no derivation of the bound: {derivation!r}")
    if EXCUSES.search(derivation):
        findings.append(f"{where}: that is no derivation: {derivation!r}")
    if q["source"] not in SOURCES:
        findings.append(f"{where}: the bound comes from {q['source']!r}")
    worst = q["worst"]
    if q["passed"] and not (q["compared"] > 0 and q["failed"] == 0 and worst["measured"] <= worst["allowed"]):
        findings.append(f"{where}: it can't have passed")
    return findings


def check(report):
    findings = []
    ids = [e["id"] for e in report["equations"]]
    if sorted(ids) != sorted([str(n) for n in range(1, 29)] + ["EOS"]):
        findings.append("not exactly (1) to (28) and EOS in the table")
    for e in report["equations"]:
        if not any(e["evidence"]):
            findings.append(f"Eq. ({e['id']}), {e['title']}: no check compares the program with an independent answer")
        if e["verdict"] == "holds" and not any(
                e["id"] in r["equations"] and r["verdict"] == "holds" and r["level"] in EVIDENCE for r in report["results"]):
            findings.append(f"Eq. ({e['id']}), {e['title']}: holds without a check that does")
    for r in report["results"]:
        where = f"{r['id']} ({r['subject']})"
        if not r["oracles"] or not all(o.strip() for o in r["oracles"]) or len(set(r["oracles"])) < len(r["oracles"]):
            findings.append(f"{where}: no oracles, or one twice: {r['oracles']}")
        if not r["title"].strip():
            findings.append(f"{where}: no title")
        findings += [f"{where}: there is no equation {e}" for e in r["equations"] if e not in ids]
        if r["verdict"] == "holds" and not (r["quantities"] and all(q["passed"] for q in r["quantities"])):
            findings.append(f"{where}: it can't hold")
        if r["verdict"] != "holds" and not r["message"]:
            findings.append(f"{where}: no reason")
        names = [q["name"] for q in r["quantities"]]
        findings += [f"{where}: two quantities {name}" for name in set(names) if names.count(name) > 1]
        for q in r["quantities"]:
            findings += check_quantity(q, f"{where}, {q['name']}")
    return findings


def first(report, verdict="holds"):
    return next(r for r in report["results"] if r["verdict"] == verdict)




FAULTS = [
    ("no derivation", lambda r: first(r)["quantities"][0].update(derivation="")),
    ("no derivation", lambda r: first(r)["quantities"][0].update(derivation="gamma_4 |Sigma|")),
    ("no derivation", lambda r: first(r)["quantities"][0].update(derivation="a" * 30)),
    ("no derivation", lambda r: first(r)["quantities"][0].pop("derivation")),
    ("is no derivation", lambda r: first(r)["quantities"][0].update(derivation="TBD: somebody will do it later")),
    ("is no derivation", lambda r: first(r)["quantities"][0].update(derivation="1e-6, large enough for all that we saw")),
    ("comes from", lambda r: first(r)["quantities"][0].update(source="experience")),
    ("can't have passed", lambda r: first(r)["quantities"][0].update(compared=0)),
    ("can't have passed", lambda r: first(r)["quantities"][0]["worst"].update(measured=1, allowed=0.5)),
    ("no oracles", lambda r: first(r).update(oracles=[])),
    ("no oracles", lambda r: first(r).update(oracles=["closed form", "closed form"])),
    ("no title", lambda r: first(r).update(title=" ")),
    ("there is no equation 29", lambda r: first(r)["equations"].append("29")),
    ("can't hold", lambda r: first(r).update(quantities=[])),
    ("no reason", lambda r: first(r).update(verdict="not run", message="")),
    ("two quantities", lambda r: first(r)["quantities"].append(first(r)["quantities"][0])),
    ("Eq. (8), Laplace's law: no check", lambda r: r["equations"][8].update(evidence=[False])),
    ("Eq. (EOS)", lambda r: r["equations"][7].update(evidence=[])),
    ("not exactly", lambda r: r["equations"].pop()),
    ("without a check that does", lambda r: r.update(results=[])),
]


def planted(report):
    missed = []
    for number, (expected, change) in enumerate(FAULTS):
        faulty = copy.deepcopy(report)
        before = set(check(faulty))
        change(faulty)
        if not any(expected in finding for finding in set(check(faulty)) - before):
            missed.append(f"fault {number} ({expected}) was not found")
    return missed


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--planted"]):
        sys.exit(__doc__)
    report = json.loads((pathlib.Path(sys.argv[1]) / "report.json").read_text(encoding="utf-8"))
    findings = planted(report) if sys.argv[2:] else check(report)
    print("\n".join(findings) or f"{len(report['results'])} results: nothing found")
    sys.exit(bool(findings))


main()
