# SPDX-License-Identifier: Apache-2.0
"""Every equation of the table has its one reference function, its device function, an oracle and a check.

Reads common/equations.hpp and looks for
  - `Eq. (N)` at the start of the doc comment of the row's function, once under reference/, and that function's body;
  - the same once under cuda/, whatever its arguments;
  - `Eq. (N)` in a doc comment under analytic/;
  - a check `eqNN_...` of the suite under verification/checks/, of a formula, a sum or a flow of a backend: an
    oracle_check, which compares oracles with one another, doesn't count, and neither does a test.
  - calls of it outside its own definition: of one whose use is `used` in reference/ and in cuda/, of a `part` in cuda/
    alone, of one that is `nominal` in neither.
docs/model.md names those that are `part` or `nominal`.
The comment at the start of a file of checks says which equations it holds: those of its checks' names, (17)-(21) or EOS.
"""
import re

import guard

ROW = re.compile(r'\{"(\w+)",\s*"([\d.]+)",\s*"([^"]*)",\s*"(\w+)",\s*Status::\w+,\s*'
                 r'(?:"[^"]*"\s*)+(?:,\s*Use::(\w+))?\}')
CALLED_IN = {"used": ["reference", "cuda"], "part": ["cuda"], "nominal": []}
USES = {"part": "**Parts of (21)**", "nominal": "**Nominal**"}  # how docs/model.md begins its list of them
DOCUMENTED = re.compile(r"((?:^[ \t]*///.*\n)+)([^;{]*)", re.MULTILINE)
HEAD = re.compile(r"\s*///\s*Eq\. \((\w+)\)")
MENTION = re.compile(r"^\s*///.*", re.MULTILINE)
CHECK = re.compile(r'\b(?:formula|sum|flow)_check\(\s*"eq([^\W_]+)_')
NAMED = re.compile(r'\b\w+_check\(\s*"eq([^\W_]+)_')
SAID = re.compile(r"\((\d+)\)(?:-\((\d+)\))?")


def text_of(root, room):
    return "\n".join(file.read_text(encoding="utf-8") for file in guard.sources(root, room))


def documented_functions(text):
    """Pairs of equation and function, of each doc comment that starts with an equation."""
    for comment, declaration in DOCUMENTED.findall(text):
        head = HEAD.match(comment)
        name = re.search(r"(\w+)\s*\(", declaration)
        if head and name:
            yield head.group(1), name.group(1)


def calls(function, text):
    """Whether code, without its comments, calls a function: what is before the name is no return type."""
    before = r"(?:\breturn|->|::|[-+*/=(,{!|?;])\s*"
    return re.search(rf"{before}{function}\s*(?:<[^<>;()]*>)?\s*\(", re.sub(r"//.*", "", text)) is not None


def said_uses(page, use):
    """The equations that a page's list names, as in **Nominal**: (4), (8)-(12)."""
    said = re.search(re.escape(USES[use]) + r":((?:,?\s*\(\d+\)(?:-\(\d+\))?)*)", page)
    return [n for first, last in SAID.findall(said.group(1) if said else "")
            for n in range(int(first), int(last or first) + 1)]


def unsaid_equations(text):
    """Equations that checks of a file are named by and that the comment at its start leaves out."""
    head = re.match(r"(?://.*\n)*", text).group().replace("equation of state", "EOS")
    said = {n for first, last in SAID.findall(head) for n in range(int(first), int(last or first) + 1)}
    return [name for name in NAMED.findall(text) if not (name in head if name == "EOS" else int(name) in said)]


def check(root):
    rows = ROW.findall((root / "common/equations.hpp").read_text(encoding="utf-8"))
    findings = []
    if sorted(row[0] for row in rows) != sorted([str(n) for n in range(1, 29)] + ["EOS"]):
        findings.append("common/equations.hpp: not exactly one row for each of (1)-(28) and EOS")
    reference = text_of(root, "reference")
    functions = list(documented_functions(reference))
    device = text_of(root, "cuda")
    device_functions = list(documented_functions(device))
    oracles = "\n".join(MENTION.findall(text_of(root, "analytic")))
    checks = set(CHECK.findall(text_of(root, "verification/checks")))
    for use in USES:
        of_the_table = sorted(int(row[0]) for row in rows if row[4] == use)
        said = said_uses((root / "docs/model.md").read_text(encoding="utf-8"), use)
        if said != of_the_table:
            findings.append(f"docs/model.md: {use}: {said}, in the table of equations {of_the_table}")
    for number, _, title, function, use in rows:
        where = f"Eq. ({number}), {title}"
        documented = [name for equation, name in functions if equation == number]
        if documented != [function]:
            findings.append(f"{where}: documented at {documented} in reference/, not once at {function!r}")
        if not re.search(rf"\b{function}\s*\([^;{{]*\{{", reference):
            findings.append(f"{where}: {function!r} has no body in reference/")
        called_in = [room for room, text in (("reference", reference), ("cuda", device)) if calls(function, text)]
        if called_in != CALLED_IN[use or "used"]:
            findings.append(f"{where}: {use or 'used'}, but {function!r} is called in {called_in}")
        on_device = [name for equation, name in device_functions if equation == number]
        if on_device != [function]:
            findings.append(f"{where}: documented at {on_device} in cuda/, not once at {function!r}")
        if not re.search(rf"\b{function}\s*\([^;{{]*\{{", device):
            findings.append(f"{where}: {function!r} has no body in cuda/")
        if f"Eq. ({number})" not in oracles:
            findings.append(f"{where}: no oracle in analytic/ says Eq. ({number})")
        if (number if number == "EOS" else f"{int(number):02}") not in checks:
            findings.append(f"{where}: no check eq{number:>02}_... of a backend in verification/checks/")
    for file in guard.sources(root, "verification/checks"):
        for name in unsaid_equations(file.read_text(encoding="utf-8")):
            findings.append(f"{file.relative_to(root)}: holds eq{name}_..., which its first comment doesn't say")
    return findings


FAULTS = [
    ("reference/growth.hpp", "/// Eq. (21)", "/// Equation 21", "Eq. (21)"),
    ("reference/growth.hpp", "radius_increment", "radius_growth", "Eq. (21)"),
    ("reference/growth.hpp", "/// Eq. (18)", "/// Eq. (17)", "Eq. (17)"),
    ("cuda/growth.hpp", "/// Eq. (21)", "/// Equation 21", "in cuda/"),
    ("cuda/blood_flow.hpp", "viscosity_force", "viscous_force", "in cuda/"),
    ("analytic", "Eq. (26)", "the outlet's pressure", "Eq. (26)"),
    ("verification/checks", '"eq24_', '"murray_', "Eq. (24)"),
    ("verification/checks", 'sum_check("eq02_', 'oracle_check("eq02_', "Eq. (2)"),
    ("verification/checks", '"eq23_', '"thinning_', "Eq. (23)"),
    ("verification/checks", '"eqEOS_', '"state_', "Eq. (EOS)"),
    ("verification/checks", "how the wall thins while the sac grows (22)", "how the wall thins", "holds eq22_"),
    ("verification/checks", "(17)-(21)", "(17)-(20)", "holds eq21_"),
    ("common/equations.hpp", '{"EOS", ', '{"29", ', "EOS"),
    ("common/equations.hpp", '"", Use::nominal}', '""}', "used, but 'wall_stress' is called in []"),
    ("reference/deform.cpp", "= critical_pressure(", "= wall_stress(", "Eq. (8), Laplace's law: nominal, but"),
    ("cuda/growth.hpp", "tissue_force(w, 1 / dt)", "w.rho_F * w.a * w.c / dt", "Eq. (18)"),
    ("docs/model.md", "**Nominal**: (4), ", "**Nominal**: ", "docs/model.md: nominal"),
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
