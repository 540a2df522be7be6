# SPDX-License-Identifier: Apache-2.0
"""cmake/install_dependencies.sh on systems that stand-ins play: with root, with sudo, without either, without apt.

usage: check_dependencies.py ROOT
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(sys.argv[1])
TOOLS = ("sh", "grep", "sed", "cut", "tr", "awk", "cat", "env", "true")
PACKAGES = """# a comment
needed-here
needed-gone
optional-here: this
optional-gone: that
not-in-archive: the third
a-program: the fourth
"""
# Installed is what the file `installed` lists; apt-get adds to it, and the archive has all but one package.
STAND_INS = {
    "dpkg-query": 'for last; do :; done; grep -qx -- "$last" "$HERE/installed" && echo "install ok installed"',
    "apt-cache": 'shift; for p; do echo "$p:"; case $p in not-in-archive) echo "  Candidate: (none)";; '
                 '*) echo "  Candidate: 1.0";; esac; done',
    "apt-get": 'echo "apt-get $*" >>"$HERE/calls"; for p; do case $p in -*|install|update) ;; *) echo "$p" >>"$HERE/installed";; '
               'esac; done',
    "a-program": "",  # here, but by no package
}
failures = []


def expect(good, what):
    if not good:
        failures.append(what)


def install(*others, uid, apt=True):
    """What the script printed, its errors, and the calls of apt-get; it has to end with 0."""
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        (here / "list").write_text(PACKAGES)
        (here / "installed").write_text("needed-here\noptional-here\n")
        (here / "calls").write_text("")
        stand_ins = {**STAND_INS, "id": f"echo {uid}", **dict(others)}
        for name, text in stand_ins.items():
            if apt or name in ("id", "a-program"):
                (here / name).write_text(f"#!/bin/sh\n{text}\n")
                (here / name).chmod(0o755)
        for name in TOOLS:
            (here / name).symlink_to(shutil.which(name))
        process = subprocess.run(["/bin/sh", root / "cmake/install_dependencies.sh", here / "list"], capture_output=True, text=True,
                                 stdin=subprocess.DEVNULL, env={**os.environ, "PATH": folder, "HERE": folder})
        expect(process.returncode == 0, f"exit code {process.returncode}: {process.stderr}")
        return process.stdout, process.stderr, (here / "calls").read_text()


INSTALLED = "apt-get install -y -qq --no-install-recommends needed-gone optional-gone"
sudo = ("sudo", '[ "$1" = -n ] && shift; exec "$@"')

for who, case in [("root", install(uid=0)), ("sudo", install(sudo, uid=1000))]:
    out, err, calls = case
    expect(calls.splitlines()[-1:] == [INSTALLED], f"{who}: {calls}")
    expect("missing, so left out: not-in-archive: the third" in err and err.count("\n") == 1, f"{who}: {err}")

for who, case in [("nobody", install(uid=1000)), ("sudo that refuses", install(("sudo", "exit 1"), uid=1000))]:
    out, err, calls = case
    expect(calls == "", f"{who}: {calls}")
    expect("needed unless it is here by another way: needed-gone \n" in err, f"{who}: {err}")
    left_out = [line.split("left out: ")[1] for line in err.splitlines() if "left out: " in line]
    expect(left_out == ["optional-gone: that", "not-in-archive: the third"], f"{who}: {err}")

out, err, calls = install(uid=0, apt=False)
expect("needed: needed-here needed-gone \n" in err and "of use: optional-here optional-gone not-in-archive \n" in err, err)

out, err, calls = install(("apt-get", 'echo "$*" >>"$HERE/calls"; [ "$1" = update ]'), uid=0)
expect("could not install" in err and "needed-gone" in err, f"a full disk, say: {err}")

print("\n".join(failures) or "all checks passed")
sys.exit(bool(failures))
