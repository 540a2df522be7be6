# SPDX-License-Identifier: Apache-2.0
"""The documentation site: it is made without a warning, has every value of a scenario and every equation, its links lead
somewhere, and a public declaration without a comment stops it.

usage: check_site.py PROGRAM DATA DOXYGEN DOXYFILE
"""
import html.parser
import pathlib
import re
import subprocess
import sys
import urllib.parse

import program
from program import data, expect, read_json

project = data.parent
doxygen, doxyfile = sys.argv[3:5]


def make(scratch, text):
    """The site in `scratch`; errors of Doxygen."""
    (scratch / "equations.txt").write_text(program.run("info")[0])
    subprocess.run([sys.executable, "-B", project / "docs/site/pages.py", project, scratch / "equations.txt", scratch / "pages"],
                   check=True)
    (scratch / "Doxyfile").write_text(text)
    return subprocess.run([doxygen, "Doxyfile"], cwd=scratch, capture_output=True, text=True)


def settings(scratch):
    text = pathlib.Path(doxyfile).read_text()
    site = re.search(r'^OUTPUT_DIRECTORY += "(.*)"$', text, re.MULTILINE)[1]
    return text.replace(f'"{site}', f'"{scratch}')


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        self.anchors |= {of[key] for key in ("id", "name") if key in of}
        self.links += [of["href"]] if tag == "a" and "href" in of else []


def check_links(site):
    pages = {file.name: Page(file) for file in site.glob("*.html")}
    for name, page in pages.items():
        for link in page.links:
            target = urllib.parse.urlsplit(link)
            if target.scheme or link.startswith(("#", "javascript:")):
                continue
            found = pages.get(target.path)
            expect(found and (not target.fragment or target.fragment in found.anchors), f"{name}: a link to {link}")


def check_site(scratch):
    done = make(scratch, settings(scratch))
    expect(done.returncode == 0 and not done.stderr, f"no warning expected: {done.stderr[:2000]}")
    site = scratch / "html"
    check_links(site)
    values = (site / "page_parameters.html").read_text()
    for group, schema in read_json(data / "scenario.schema.json")["properties"].items():
        for key in schema.get("properties", {}):
            expect(f"<code>{group}.{key}</code>" in values, f"parameters: {group}.{key} expected")
    rows = (site / "page_equations.html").read_text()
    for number in [f"({n})" for n in range(1, 29)] + ["EOS"]:
        expect(re.search(rf">{re.escape(number)}\s*</td>", rows), f"equations: {number} expected")


def check_undocumented(scratch):
    (scratch / "bad.hpp").write_text("namespace aneurysm::reference\n{\ndouble without_comment(double x);\n}\n")
    done = make(scratch, settings(scratch) + f'INPUT += "{scratch}/bad.hpp"\n')
    expect(done.returncode != 0 and "without_comment" in done.stderr, f"a refusal expected: {done.returncode}: {done.stderr}")


program.check_all(check_site, check_undocumented)
