# SPDX-License-Identifier: Apache-2.0
"""`aneurysm render` and `aneurysm view`: pictures of a short run that show what they should, and bad input.

usage: check_pictures.py PROGRAM PICTURES_PROGRAM DATA
Needs Debian's python3-matplotlib. Where Xvfb isn't installed, only what needs none is checked.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

import matplotlib.image
import numpy

program, pictures_program, data = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
scratch_directory = tempfile.TemporaryDirectory()
scratch = pathlib.Path(scratch_directory.name)
run_directory = scratch / "run"
scenario = scratch / "short.json"
failures = []


def expect(good, what):
    if not good:
        failures.append(what)


def run(*arguments, code=0, display=None):
    environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
    if display:
        environment.update(DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1")
    done = subprocess.run([program, *map(str, arguments)], cwd=scratch, env=environment, capture_output=True, text=True)
    label = " ".join(map(str, arguments))
    expect(done.returncode == code, f"{label}: exit code {done.returncode} instead of {code}: {done.stderr}")
    return done.stdout, done.stderr


def refused(*arguments, names):
    _, err = run(*arguments, code=2)
    expect(err.count("\n") == 1, f"{arguments}: one line expected: {err}")
    for name in names:
        expect(str(name) in err, f"{arguments}: '{name}' expected: {err}")


def read_png(file):
    """Width, height and pixels, row by row."""
    pixels = numpy.round(255 * matplotlib.image.imread(file)).astype(int)
    expect(pixels.shape[2:] == (3,), f"{file.name}: RGB expected")
    height, width, _ = pixels.shape
    return width, height, [tuple(pixel) for pixel in pixels.reshape(-1, 3).tolist()]


def is_red(pixel):
    """Blood: no gray, and neither the wall's rose nor the rim's orange."""
    return pixel[0] > 90 and pixel[1] < 0.45 * pixel[0] and pixel[2] < 0.45 * pixel[0]


def is_orange(pixel):
    """The breach's rim."""
    return pixel[0] > 150 and 0.4 * pixel[0] < pixel[1] < 0.75 * pixel[0] and pixel[2] < 0.35 * pixel[0]


def share(pixels, condition):
    return sum(map(condition, pixels)) / len(pixels)


def make_run():
    content = {"base": str(data / "scenarios/quick.json"), "name": "short",
               "output": {"particles_every_frames": 100, "checkpoint_every_frames": 0},
               "assumed": {"output.particles_every_frames": "a test", "output.checkpoint_every_frames": "a test"}}
    scenario.write_text(json.dumps(content))
    run("run", scenario, "--out", run_directory, "--backend", "cpu", "--precision", "float", "--frames", 400)


def check_bad_input():
    for command, names in (("render", ("--frames", "--sheet", "results/paper_tc1")),
                           ("view", ("--backend", "--keys", "quick.json"))):
        out, _ = run(command, "--help")
        expect(all(name in out for name in names), f"{command} --help: {out}")
    refused("render", names=["RUN_DIR"])
    refused("render", scratch / "none", names=[scratch / "none/manifest.json"])
    refused("render", run_directory, "--frames", 150, names=["frame_000150", "there are: 0, 100, 200, 300, 400"])
    refused("render", run_directory, "--frames", 900, names=["frames.csv", "up to 400"])
    refused("render", run_directory, "--state", "gas", names=["--state", "gas", "fluid"])
    refused("render", run_directory, "--color", "age", names=["--color", "age", "pressure"])
    refused("render", run_directory, "--view", "back", names=["--view", "back", "tilted"])
    refused("render", run_directory, "--size", "12", names=["--size", "12", "WIDTHxHEIGHT"])
    refused("render", run_directory, "--range", "3,1", names=["--range"])
    refused("render", run_directory, run_directory, names=["--sheet"])
    refused("render", run_directory, "--sheet", "--labels", "a,b", names=["--labels", "2 for 1"])
    damaged = scratch / "damaged"
    shutil.copytree(run_directory, damaged)
    file = damaged / "particles/frame_000100.hdf"
    file.write_bytes(file.read_bytes()[:2000])
    refused("render", damaged, "--frames", 100, names=[file])
    (damaged / "frames.csv").write_text("frame\n")
    refused("render", damaged, names=[damaged / "frames.csv"])
    refused("view", scratch / "none.json", names=[scratch / "none.json"])
    refused("view", scenario, names=["DISPLAY", "aneurysm render"])
    refused("view", scenario, "--keys", "x", names=["--keys", "x"])
    refused("view", data / "scenarios/verify_box.json", names=["verify_box.json", "domain.form", "artery"])
    alone = scratch / "alone"
    alone.mkdir()
    shutil.copy(program, alone / "aneurysm")
    done = subprocess.run([alone / "aneurysm", "render", run_directory], capture_output=True, text=True)
    expect(done.returncode == 2 and "aneurysm-pictures" in done.stderr and "libvtk9-dev" in done.stderr,
           f"the missing program expected: {done.returncode}: {done.stderr}")
    expect(not (run_directory / "pictures").exists(), "no pictures from bad input expected")


def servers():
    """Processes of ours called Xvfb."""
    found = set()
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and (entry / "comm").read_text().strip() == "Xvfb":
                found.add(entry.name)
        except OSError:
            pass
    return found


def check_render():
    before = servers()
    out, _ = run("render", run_directory, "--frames", "100,400", "--size", "240x200", "--range", "0,10")
    directory = run_directory / "pictures"
    expect(str(directory) in out, f"the directory expected: {out}")
    names = ["fluid_000100.png", "fluid_000400.png", "particles_000100.png", "particles_000400.png"]
    expect(sorted(p.name for p in directory.iterdir()) == names, f"four pictures: {list(directory.iterdir())}")
    pixels = {}
    for name in names:
        width, height, pixels[name] = read_png(directory / name)
        expect((width, height) == (240, 200), f"{name}: {width}x{height}")
        expect(len(set(pixels[name])) > 1000, f"{name}: {len(set(pixels[name]))} colors")
        corner = pixels[name][239]
        expect(min(corner) > 200, f"{name}: a bright background expected: {corner}")
    for frame in ("100", "400"):
        red = {state: share(pixels[f"{state}_000{frame}.png"], is_red) for state in ("fluid", "particles")}
        expect(red["fluid"] > 0.08 and red["fluid"] > 4 * red["particles"], f"frame {frame}: red blood: {red}")
    expect(pixels[names[0]] != pixels[names[1]], "two frames differ")
    breach = scratch / "breach"
    run("render", run_directory, "--frames", "100,400", "--state", "particles", "--view", "breach", "--size", "240x200",
        "--out", breach, "--range", "0,10")
    rim = [share(read_png(breach / f"particles_000{frame}.png")[2], is_orange) for frame in ("100", "400")]
    expect(rim[1] > 0.003 and rim[1] > 5 * rim[0], f"a rim after the rupture alone: {rim}")
    again = scratch / "again"
    run("render", run_directory, "--frames", 400, "--size", "240x200", "--range", "0,10", "--out", again)
    for name in ("fluid_000400.png", "particles_000400.png"):
        same = (again / name).read_bytes() == (directory / name).read_bytes()
        expect(same, f"{name}: the same bytes again expected")
    expect(servers() <= before, "no X server left over expected")


def check_sheet_and_video():
    out_directory = scratch / "sheet"
    run("render", run_directory, run_directory, "--frames", "100,400", "--sheet", "--size", "120x120", "--labels", "a,b",
        "--columns", 2, "--out", out_directory)
    width, height, pixels = read_png(out_directory / "sheet.png")
    expect(width == 240 and height > 480, f"2 columns, 4 rows and a color bar: {width}x{height}")
    tiles = {(i, j): [pixels[y * width + 120 * j:y * width + 120 * (j + 1)] for y in range(120 * i + 40, 120 * (i + 1))]
             for i in range(4) for j in range(2)}  # below their labels
    expect(all(tiles[i, j] == tiles[i + 2, j] for i in (0, 1) for j in (0, 1)), "the same run, the same tiles expected")
    expect(len({str(tiles[i, j]) for i in (0, 1) for j in (0, 1)}) == 4, "tiles that differ expected")
    out_directory = scratch / "video"
    out, _ = run("render", run_directory, "--state", "fluid", "--size", "120x120", "--animation", "--out", out_directory)
    expect(len(list(out_directory.glob("fluid_*.png"))) == 5, "the pictures of the video expected")
    video = (out_directory / "fluid.webm").read_bytes()
    expect(video[:4] == b"\x1aE\xdf\xa3" and b"V_VP9" in video, "WebM with VP9 expected")
    expect("fluid.webm" in out, f"the video named: {out}")
    expect(not list(out_directory.glob("*.tmp")), "nothing left of the video's making expected")


def check_interrupted():
    """Ctrl-C leaves whole pictures and no server."""
    before = servers()
    out_directory = scratch / "interrupted"
    process = subprocess.Popen([pictures_program, "render", run_directory, "--size", "240x200", "--out", out_directory],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while process.poll() is None and not list(out_directory.glob("*.png")):
        time.sleep(0.02)
    process.send_signal(2)
    _, err = process.communicate()
    expect(process.returncode == 130 and "interrupted" in err, f"interrupted: {process.returncode}: {err}")
    expect(not list(out_directory.glob("*.tmp")), "no half pictures expected")
    expect(servers() <= before, "interrupted: no X server left over expected")


def view(display, keys, picture, *more):
    out, _ = run("view", scenario, "--paused", "--size", "480x320", "--keys", keys, "--picture", picture, *more,
                 display=display)
    return out, read_png(scratch / picture)


def check_view(display):
    out, (width, height, plain) = view(display, "n n n q", "plain.png")
    expect("Closed at frame 3 of 400" in out, f"three steps expected: {out}")
    expect((width, height) == (480, 320) and len(set(plain)) > 1000, f"a picture: {width}x{height}, {len(set(plain))}")
    bright = share(plain, lambda pixel: min(pixel) > 200)
    expect(0.3 < bright < 0.95, f"a bright background around the artery and the charts: {bright}")
    out, (_, _, colored) = view(display, "n n n c q", "colored.png")
    expect("frame 3" in out and colored != plain, "another color expected")
    out, (_, _, fluid) = view(display, "n n c f q", "fluid.png")
    expect("frame 2" in out and share(fluid, is_red) > 4 * share(plain, is_red), f"red blood expected: {out}")
    out, (_, _, back) = view(display, "n n n c c w w 1 2 h h q", "back.png")
    expect(back == plain, "everything back again: the same picture expected")
    out, _ = view(display, "space n q", "end.png", "--frames", 5)
    expect("of 5" in out, f"the last frame: {out}")


def with_display(check):
    number, report = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(report), "-screen", "0", "1024x768x24", "-nolisten", "tcp"],
                              pass_fds=[report], stderr=subprocess.DEVNULL)
    os.close(report)
    try:
        with os.fdopen(number) as stream:
            check(":" + stream.readline().strip())
    finally:
        server.terminate()
        server.wait()


make_run()
check_bad_input()
if shutil.which("Xvfb"):
    check_render()
    check_sheet_and_video()
    check_interrupted()
    with_display(check_view)
else:
    refused("render", run_directory, names=["xvfb"])
scratch_directory.cleanup()
print("\n".join(failures) or "all checks passed")
sys.exit(bool(failures))
