# SPDX-License-Identifier: Apache-2.0
"""No check of the verification suite goes round its ledger.

In verification/checks/
  - a Quantity comes from Probe::quantity, which asks for source and derivation, and nothing derives from it;
  - what is allowed (third argument of `within`) is no plain number but 0, nor one with a negative power of ten in it;
  - no name for a bound (allowed, bound, tolerance ...) is set to such a number;
  - a claim (`holds`) hides no difference of numbers and no tolerance;
  - nothing is cast away or asserted, and only what is expected is caught: else it would leave no trace in the report.
"""
import re

import guard

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?f?")
SMALL = re.compile(r"\b\d+(\.\d+)?e-\d+", re.IGNORECASE)
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\])*")', re.DOTALL)
FORBIDDEN = [
    (re.compile(r"(?<![\w&*])Quantity\s+\w+\s*[({=]"), "a Quantity that is not the probe's"),
    (re.compile(r"(?<!\w)Quantity\s*[({]"), "a Quantity that is not the probe's"),
    (re.compile(r"\b(struct|class)\s+\w+[^;{}]*:[^;{}]*\bQuantity\s*\{"), "derives from Quantity"),
    (re.compile(r"(?<![.\w])(allowed|bound|tolerance|tol|eps|epsilon|margin|limit)\w*\s*[={(]\s*[-+]?\d[\d.]*e-\d+"),
     "a bound that is picked"),
    (re.compile(r"\b(const_cast|reinterpret_cast|assert)\b|\bcatch\s*\((\.\.\.|const (std::exception|Error)\b)"),
     "leaves no trace in the report"),
]


def arguments(text, start):
    """The arguments of the call whose opening parenthesis is at `start`."""
    result, depth, begin, quoted = [], 0, start + 1, False
    for k in range(start, len(text)):
        c = text[k]
        if c == '"' and text[k - 1] != "\\":
            quoted = not quoted
        if quoted:
            continue
        if c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
        if depth == 0 or (c == "," and depth == 1):
            result.append(text[begin:k].strip())
            begin = k + 1
        if depth == 0:
            return result
    return result


def check_calls(text, where):
    for call in re.finditer(r"\.(within|holds)\s*\(", text):
        given = arguments(text, call.end() - 1)
        line = f"{where}:{text.count(chr(10), 0, call.start()) + 1}"
        if call.group(1) == "holds":
            if re.search(r"\babs\s*\(|\blength\s*\(", given[0]) or SMALL.search(given[0]):
                yield f"{line}: a difference in a claim without a number: {given[0]}"
        elif len(given) >= 3:
            allowed = given[2]
            if (NUMBER.fullmatch(allowed) and float(allowed.rstrip("f")) != 0) or SMALL.search(allowed):
                yield f"{line}: what is allowed is picked: {allowed}"


def check(root):
    findings = []
    for file in guard.sources(root, "verification/checks"):
        text = COMMENT.sub(lambda match: match.group(1) or "", file.read_text(encoding="utf-8"))
        where = file.relative_to(root)
        for pattern, what in FORBIDDEN:
            findings += [f"{where}: {what}: {match.group(0)}" for match in pattern.finditer(text)]
        findings += check_calls(text, where)
    return findings


PLACE = "verification/checks/formulas/rupture.cpp"
HEAD = "namespace aneurysm::checks\n{\n"
FAULTS = [
    (PLACE, HEAD, HEAD + "void f(Probe&) { " + fault + " }\n", expected)
    for fault, expected in [
        ('Quantity q("x", Source::exact, "nothing is allowed here, really");', "not the probe's"),
        ('auto q = Quantity("x", Source::exact, "nothing is allowed here, really");', "not the probe's"),
        ("struct Mine : Quantity {};", "derives from"),
        ("q.within(a, b, 1e-9);", "is picked"),
        ("q.within(a(1, 2), b, 0.5, \"here\");", "is picked"),
        ("q.within(a, b, 1e-9 * std::abs(b));", "is picked"),
        ("const double tolerance = 1e-6;", "that is picked"),
        ("q.holds(std::abs(a - b) < small);", "without a number"),
        ("q.holds(length(a - b) < small);", "without a number"),
        ("q.holds(a / b - 1 < 1e-3, \"near\");", "without a number"),
        ("assert(a < b);", "no trace"),
        ("try { g(); } catch (const Error&) { }", "no trace"),
    ]
]

if __name__ == "__main__":
    guard.main(check, FAULTS)
