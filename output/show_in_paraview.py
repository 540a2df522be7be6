# SPDX-License-Identifier: Apache-2.0
"""Shows the run of this folder in ParaView 5.10 or later: particles by speed, and the wall, over time.

    paraview --script=DIR/show_in_paraview.py
    pvpython DIR/show_in_paraview.py PICTURE.png    # the last frame as a picture, without a window
"""
import os
import sys

from paraview.simple import *

SERIES = "particles.hdf.series"
WALL, BREACH = 0, 1  # of the array part; 2, 3 and 4 are the open ends


def run_folder():
    """Where this script is. The window runs it under no name, so that the command line has to tell, or the folder that
    ParaView was started in."""
    words = [globals().get("__file__", "")]
    if os.path.exists("/proc/self/cmdline"):
        with open("/proc/self/cmdline", errors="surrogateescape") as file:
            words += file.read().replace("--script=", "").split("\0")
    for folder in [os.path.dirname(os.path.abspath(word)) for word in words if word] + [os.getcwd()]:
        if os.path.exists(os.path.join(folder, SERIES)):
            return folder
    raise SystemExit("no " + SERIES + " here; needed: ParaView started in the folder of a run that has one")


def open_series(file):
    reader = OpenDataFile(os.path.join(FOLDER, file))
    reader.UpdatePipeline(max(reader.TimestepValues))
    return reader


def part(wall, first, last, name):
    threshold = Threshold(registrationName=name, Input=wall, Scalars=["CELLS", "part"])
    threshold.LowerThreshold, threshold.UpperThreshold = first, last
    return threshold


def show_particles(view):
    particles = open_series(SERIES)
    RenameSource("particles", particles)
    bounds = particles.GetDataInformation().GetBounds()
    volume = (bounds[1] - bounds[0]) * (bounds[3] - bounds[2]) * (bounds[5] - bounds[4])
    shown = Show(particles, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.ShaderPreset = "Sphere"
    shown.GaussianRadius = 0.25 * (volume / particles.GetDataInformation().GetNumberOfPoints()) ** (1 / 3)
    ColorBy(shown, ("POINTS", "velocity", "Magnitude"))
    shown.RescaleTransferFunctionToDataRangeOverTime()
    bar = GetScalarBar(GetColorTransferFunction("velocity"), view)
    bar.Title, bar.ComponentTitle = "speed [m/s]", ""
    shown.SetScalarBarVisibility(view, True)


def show_wall(view):
    wall = open_series("wall.hdf.series")
    RenameSource("wall and openings", wall)
    for name, first, last, color, opacity in (("wall", WALL, WALL, (0.86, 0.62, 0.58), 0.25),
                                              ("breach", BREACH, BREACH, (0.95, 0.55, 0.05), 0.6),
                                              ("open ends", BREACH + 1, BREACH + 3, (0.6, 0.6, 0.6), 0.2)):
        shown = Show(part(wall, first, last, name), view)
        shown.ColorArrayName = ["POINTS", ""]  # a plain color
        shown.DiffuseColor = color
        shown.Opacity = opacity


FOLDER = run_folder()
view = GetActiveViewOrCreate("RenderView")
view.OrientationAxesVisibility = 0
show_particles(view)
if os.path.exists(os.path.join(FOLDER, "wall.hdf.series")):  # of an artery
    show_wall(view)
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
GetAnimationScene().GoToLast()
ResetCamera(view)
Render(view)
if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
    SaveScreenshot(sys.argv[1], view, ImageResolution=[1200, 900])
