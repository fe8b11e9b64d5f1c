"""Does examples/paraview/four_views.py draw what it says? Run by pvpython on a display: four_views_check.py RESULTS"""
import os
import subprocess
import sys
from pathlib import Path

from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SCRIPT = Path(__file__).resolve().parents[2] / "examples/paraview/four_views.py"
ARRAYS = ["material", "ru", "settlement", "shear_strain"]


def expect(holds, what):
    if not holds:
        sys.exit(f"four_views_check.py: {what}")


def pixels(png):
    """Rows from the top of the picture, columns, red green blue."""
    reader = vtkPNGReader()
    reader.SetFileName(str(png))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]


def expect_four_pictures(png, size):
    """Every quarter has soil, that is: more than white paper with black letters."""
    image = pixels(png)
    expect(image.shape[:2] == (size[1], size[0]), f"{png} has {image.shape[1]} x {image.shape[0]} pixels")
    for row in range(2):
        for column in range(2):
            quarter = image[row * size[1] // 2 : (row + 1) * size[1] // 2, column * size[0] // 2 : (column + 1) * size[0] // 2]
            coloured = (quarter.max(axis=2).astype(int) - quarter.min(axis=2) > 8).mean()
            expect(coloured > 0.02, f"{png}: {coloured:.2%} of the picture in row {row}, column {column} is coloured")


def shown_arrays(layout):
    """What the soil in front is coloured by, view by view from the upper left to the lower right."""
    views = simple.GetViewsInLayout(layout)
    shown = [[representation.ColorArrayName[1] for representation in view.Representations
              if hasattr(representation, "ColorArrayName") and representation.ColorArrayName[1]] for view in views]
    return sorted((names[0] for names in shown if names), key=ARRAYS.index)


def check_macro(results):
    """As ParaView's window runs it: an empty name, the series chosen in the list."""
    series = simple.PVDReader(FileName=str(results / "fields.pvd"))
    simple.SetActiveSource(series)
    sys.argv = [""]
    exec(compile(SCRIPT.read_text(), str(SCRIPT), "exec"), {"__name__": "__main__"})
    layout = simple.GetLayoutByName("four views")
    expect(shown_arrays(layout) == ARRAYS, f"the views show {shown_arrays(layout)}")
    clock = simple.GetAnimationScene()
    times = list(series.TimestepValues)
    expect(clock.AnimationTime == times[-1], f"the clock stands at {clock.AnimationTime} s")
    expect(list(clock.TimeKeeper.TimestepValues) == times, "the clock does not have the times of the frames")
    clock.AnimationTime = times[0]
    simple.RenderAllViews()
    expect(all(view.ViewTime == times[0] for view in simple.GetViewsInLayout(layout)), "a view does not follow the clock")


def called(*arguments, **environment):
    call = subprocess.run(["pvpython", SCRIPT, *arguments], env={**os.environ, **environment}, capture_output=True, text=True)
    return call.returncode, call.stdout + call.stderr


def check_command(results):
    image = results / "views.png"
    code, said = called(results, "--image", image, "--size", "800x600", "--time", "0.00101")
    expect(code == 0 and said.strip() == f"{image}: t = 0.001 s", f"exit code {code}: {said}")
    expect_four_pictures(image, (800, 600))
    code, said = called(results / "nowhere")
    expect(code == 1 and "nowhere is not there" in said and "quicksand run" in said, f"exit code {code}: {said}")
    code, said = called(results, DISPLAY="")
    expect(code == 1 and "hint: xvfb-run" in said, f"exit code {code}: {said}")
    code, said = called(results, "--size", "800")
    expect(code == 2 and "WIDTHxHEIGHT" in said, f"exit code {code}: {said}")


if __name__ == "__main__":
    folder = Path(sys.argv[1]).resolve()
    check_macro(folder)
    check_command(folder)
    print("four views: macro and command work")
