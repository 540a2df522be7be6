# SPDX-License-Identifier: Apache-2.0
"""The commit that a build takes for its sources': that of their own repository, of their archive, or none; never that of
a repository around them.

usage: check_commit.py PROGRAM DATA
"""
import re
import shutil
import subprocess

import program
from program import data, expect

project = data.parent
author = ["-c", "user.name=a", "-c", "user.email=a@b.c", "-c", "commit.gpgsign=false"]


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, *author, *arguments], check=True, capture_output=True, text=True).stdout.strip()


def commit_of(sources, scratch):
    """What the build would write."""
    out = scratch / "build_info.cpp"
    subprocess.run(["cmake", f"-DINPUT={sources}/output/build_info.cpp.in", f"-DOUTPUT={out}", "-DVERSION=1",
                    "-DCOMPILER=c", "-DFLAGS=f", "-P", sources / "cmake/build_info.cmake"], check=True, capture_output=True)
    return re.search(r'return \{"1", "(.*)", "c", "f"\}', out.read_text())[1]


def make_sources(folder):
    """As much of the project as this takes."""
    for name in ("cmake/build_info.cmake", "cmake/archive_commit", "output/build_info.cpp.in", ".gitattributes"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(project / name, folder / name)


def check_commits(scratch):
    own, outer = scratch / "own", scratch / "outer"
    make_sources(own)
    git(own, "init", "-q")
    git(own, "add", ".")
    git(own, "commit", "-qm", "x")
    commit = git(own, "rev-parse", "HEAD")
    (scratch / "link").symlink_to(own)
    for sources in (own, scratch / "link"):
        expect(commit_of(sources, scratch) == commit, f"{sources}: its own commit expected: {commit_of(sources, scratch)}")
    (outer / "copy").mkdir(parents=True)
    git(outer, "init", "-q")
    git(outer, "commit", "-q", "--allow-empty", "-m", "x")
    make_sources(outer / "copy")
    expect(commit_of(outer / "copy", scratch) == "unknown", f"no commit expected: {commit_of(outer / 'copy', scratch)}")
    (outer / "archive").mkdir()
    archive = subprocess.run(["git", "-C", own, "archive", "HEAD"], check=True, capture_output=True).stdout
    subprocess.run(["tar", "x", "-C", outer / "archive"], input=archive, check=True)
    expect(commit_of(outer / "archive", scratch) == commit, f"the archive's: {commit_of(outer / 'archive', scratch)}")
    (own / "cmake/archive_commit").write_text("changed\n")
    expect(commit_of(own, scratch) == commit + "-dirty", f"-dirty expected: {commit_of(own, scratch)}")


program.check_all(check_commits)
