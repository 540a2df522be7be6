# SPDX-License-Identifier: Apache-2.0
"""The suite's reports as others read them: junit.xml is what CI systems expect, report.html stands alone, and all say
the same as report.json.

usage: check_report.py DIRECTORY [--planted]
With --planted: plants faults in copies of the reports and fails when one isn't found.
"""
import html.parser
import json
import pathlib
import re
import sys
import xml.etree.ElementTree

VOID = {"meta"}  # elements of HTML without an end
LEVELS = 7
WIDEST = 500  # row of a table in Markdown, characters


class Page(html.parser.HTMLParser):
    """What is wrong with a page, its ids, links and text."""

    def __init__(self, text):
        super().__init__()
        self.findings, self.ids, self.links, self.words, self.open = [], [], [], [], []
        self.feed(text)
        self.close()
        if self.open:
            self.findings.append(f"html: not closed: {self.open}")

    def handle_starttag(self, tag, attributes):
        self.handle_startendtag(tag, attributes)
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        for name, value in attributes:
            if name == "id":
                self.ids.append(value)
            elif name in ("href", "src", "action", "data", "xlink:href", "srcset"):
                self.links.append(value)
            elif name.startswith("on"):
                self.findings.append(f"html: a script in {tag} {name}")
        if tag in ("script", "link", "iframe", "object", "embed", "base", "img"):
            self.findings.append(f"html: <{tag}> in a page that stands alone")

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.findings.append(f"html: </{tag}> closes nothing, line {self.getpos()[0]}")

    def handle_data(self, data):
        self.words.append(data)


def check_html(text, report):
    page = Page(text)
    findings = page.findings
    findings += [f"html: external: {link}" for link in page.links if not link.startswith("#")]
    findings += [f"html: {link} leads nowhere" for link in page.links if link.startswith("#") and link[1:] not in page.ids]
    findings += [f"html: id {i} twice" for i in set(page.ids) if page.ids.count(i) > 1]
    if re.search(r"url\(|@import", text):
        findings.append("html: the style sheet loads something")
    words = " ".join(" ".join(page.words).split())
    said = [report["headline"]] + [e["title"] for e in report["equations"]]
    for result in report["results"]:
        said += [result["id"], result["title"], result["message"]]
        said += [text for q in result["quantities"] for text in (q["name"], q["derivation"])]
        said += [text for p in result["plots"] for text in (p["title"], p["x_label"], p["y_label"])]
        if f"check-{result['id']}" not in page.ids:
            findings.append(f"html: no section on {result['id']}")
    findings += [f"html: not said: {s}" for s in said if " ".join(s.split()) not in words]
    plots = sum(len(result["plots"]) for result in report["results"])
    if text.count("<svg") != plots:
        findings.append(f"html: {text.count('<svg')} pictures of {plots} plots")
    return findings


def check_junit(text, report):
    try:
        root = xml.etree.ElementTree.fromstring(text)
    except xml.etree.ElementTree.ParseError as error:
        return [f"junit: {error}"]
    findings = []
    suites = root.findall("testsuite")
    if root.tag != "testsuites" or len(suites) != LEVELS:
        findings.append(f"junit: {len(suites)} suites in {root.tag}")
    for element in [root, *suites]:
        cases = list(element.iter("testcase"))
        for name, count in [("tests", len(cases)), ("errors", 0),
                            ("failures", sum(c.find("failure") is not None for c in cases)),
                            ("skipped", sum(c.find("skipped") is not None for c in cases))]:
            if element.get(name) != str(count):
                findings.append(f"junit: {element.get('name')}: {name} is {element.get(name)}, not {count}")
    outcome = {None: "holds", "failure": "FAILS", "skipped": "not run", "system-out": "not met yet"}
    found = [(c.get("classname"), c.get("name"), outcome[c[0].tag if len(c) else None],
              (c[0].get("message") or c[0].text) if len(c) else "")
             for c in root.iter("testcase")]
    expected = [(f"{r['level']}.{r['id']}", r["subject"], r["verdict"], r["message"]) for r in report["results"]]
    findings += [f"junit: {case} in one only" for case in set(found) ^ set(expected)]
    return findings


def check_markdown(text, report):
    findings = [] if report["headline"] in text else ["markdown: no headline"]
    columns = None
    for line in text.splitlines():
        cells = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else None
        if columns and cells and cells != columns:
            findings.append(f"markdown: a row of other length: {line}")
        columns = cells
        if cells and len(line) > WIDEST:
            findings.append(f"markdown: a row of {len(line)} characters: {line}")
    words = text.replace("\\", "")
    said = {q["name"] for r in report["results"] for q in r["quantities"]} | {r["id"] for r in report["results"]}
    return findings + [f"markdown: not said: {s}" for s in said if s not in words]


def check(texts):
    report = json.loads(texts["report.json"])
    return (check_html(texts["report.html"], report) + check_junit(texts["junit.xml"], report)
            + check_markdown(texts["report.md"], report))


FAULTS = [  # file, old text, new text, what must be found
    ("report.html", "</h1>", "", "closes nothing"),
    ("report.html", 'href="#about"', 'href="#abuot"', "leads nowhere"),
    ("report.html", 'href="#about"', 'href="https://example.org/"', "external"),
    ("report.html", "</h1>", '</h1><img alt="x"/>', "stands alone"),
    ("report.html", "body {", "body { background: url(x.png);", "style sheet"),
    ("report.html", 'id="checks"', 'id="about"', "twice"),
    ("report.html", "equations hold", "equations", "not said"),
    ("junit.xml", "</testsuites>", "", "junit"),
    ("junit.xml", 'failures="', 'failures="1', "failures"),
    ("junit.xml", 'name="reference"', 'name="ref"', "in one only"),
    ("report.md", "| equation |", "| equation | |", "other length"),
    ("report.md", "equations hold", "hold", "no headline"),
    ("report.md", "✓ holds ", "✓ holds" + 500 * " ", "a row of"),
    ("report.md", "eq01_", "eq_", "not said"),
]


def planted(texts):
    missed = []
    for file, old, new, expected in FAULTS:
        if old not in texts[file]:
            missed.append(f"{file}: nothing to plant a fault in: {old}")
        elif not any(expected in finding for finding in check({**texts, file: texts[file].replace(old, new)})):
            missed.append(f"{file}: {old!r} -> {new!r} was not found")
    return missed


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--planted"]):
        sys.exit(__doc__)
    directory = pathlib.Path(sys.argv[1])
    names = ("report.json", "report.html", "report.md", "junit.xml")
    texts = {name: (directory / name).read_text(encoding="utf-8") for name in names}
    findings = planted(texts) if sys.argv[2:] else check(texts)
    print("\n".join(findings) or f"{directory}: nothing found")
    sys.exit(bool(findings))


main()
