"""Soil, ru, settlement and shear strain of a run beside each other in ParaView, with one clock and one camera.

As a macro (Macros > Import new macro...): open fields.pvd of a results folder, then press four_views.
As a command, which needs a display or xvfb-run:

    pvpython four_views.py RESULTS [--time SECONDS] [--image FILE.png] [--size 1600x900]
"""
import argparse
import os
import sys
from pathlib import Path

import numpy
import paraview
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

COLOURS = [0.87, 0.80, 0.62, 0.55, 0.63, 0.47, 0.65, 0.55, 0.45, 0.72, 0.72, 0.76, 0.80, 0.60, 0.45, 0.45, 0.55, 0.65]


class Panel:
    """A view: its title, the array it shows, its colours and how wide their range is."""

    def __init__(self, title, array, preset, range_of):
        self.title, self.array, self.preset, self.range_of = title, array, preset, range_of


def from_zero(values):
    """From 0 to what one particle in 200 exceeds: single grains that were thrown up do not set the colours."""
    return 0.0, max(round_up(numpy.percentile(values, 99.5)), 1e-6)


def both_ways(values):
    """Zero in the middle: what sinks and what rises have colours of their own."""
    largest = max(round_up(numpy.percentile(abs(values), 99.5)), 1e-6)
    return -largest, largest


def round_up(value):
    """The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten."""
    if not value > 0:
        return 0.0
    power = 10.0 ** numpy.floor(numpy.log10(value))
    return next(step * power for step in (1, 1.5, 2, 3, 4, 5, 6, 8, 10) if step * power >= value * (1 - 1e-9))


RU = Panel("Excess pore pressure ratio ru", "ru", "Viridis (matplotlib)", lambda values: (0.0, 1.0))
VOLUME = Panel("Volumetric strain", "volumetric_strain", "Cool to Warm", both_ways)
SETTLEMENT = Panel("Settlement [m]", "settlement", "Cool to Warm", both_ways)
SHEAR = Panel("Greatest shear strain", "shear_strain", "Inferno (matplotlib)", from_zero)


def open_series(results):
    """The reader of fields.pvd in the folder `results`, or of the .pvd file that is named itself."""
    file = Path(results)
    if file.is_dir():
        file = file / "fields.pvd"
    if not file.is_file():
        sys.exit(f"{file} is not there\nhint: name the folder that 'quicksand run' has written")
    return simple.PVDReader(FileName=str(file.resolve()))


def opened_series():
    """In ParaView's window: the series that is chosen, or else the first that is open."""
    sources = [simple.GetActiveSource(), *simple.GetSources().values()]
    for source in sources:
        if source and source.GetXMLName() == "PVDReader":
            return source
    raise RuntimeError("open fields.pvd of a results folder and press Apply before you call this macro")


def last_time(series):
    return list(series.TimestepValues)[-1]


def nearest_time(series, time):
    return min(series.TimestepValues, key=lambda frame: abs(frame - time))


def cell_values(source, array, time):
    """The finite values of an array at a time."""
    source.UpdatePipeline(time)
    values = vtk_to_numpy(servermanager.Fetch(source).GetCellData().GetArray(array))
    return values[numpy.isfinite(values)]


def material_names(series):
    """Names of the materials in the order of their numbers, which the frames carry."""
    series.UpdatePipeline(last_time(series))
    names = servermanager.Fetch(series).GetFieldData().GetAbstractArray("material_names")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def add_settlement(series):
    settlement = simple.Calculator(registrationName="settlement", Input=series)
    settlement.AttributeType = "Cell Data"
    settlement.ResultArrayName = "settlement"
    settlement.Function = "-displacement_Y"
    return settlement


def add_former_place(series):
    """Every particle moved back by its displacement: where the soil was when the shaking began."""
    corners = simple.CellDatatoPointData(registrationName="corners", Input=series)
    place = simple.WarpByVector(registrationName="former place", Input=corners)
    place.Vectors = ["POINTS", "displacement"]
    place.ScaleFactor = -1.0
    return place


def write_title(view, text):
    title = simple.Text(registrationName=text)
    title.Text = text
    style(simple.Show(title, view), "Upper Left Corner")


def write_time(view, series):
    clock = simple.AnnotateTimeFilter(registrationName="time", Input=series)
    clock.Format = "t = {time:g} s"
    style(simple.Show(clock, view), "Upper Right Corner")


def style(text, place):
    text.WindowLocation = place
    text.Color = [0.0, 0.0, 0.0]
    text.FontSize = 16


def show_surface(source, view):
    """Without light, so that colours are those of the bars."""
    display = simple.Show(source, view)
    display.Representation = "Surface"
    display.Ambient, display.Diffuse = 1.0, 0.0
    return display


def show_bar(display, view, table, length):
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(table, view)
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.ScalarBarLength = length
    bar.Title, bar.ComponentTitle = "", ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.LabelFontSize = 14
    bar.RangeLabelFormat = bar.LabelFormat = "%.3g"
    return bar


def show_panel(view, source, panel, time):
    display = show_surface(source, view)
    simple.ColorBy(display, ("CELLS", panel.array))
    table = simple.GetColorTransferFunction(panel.array)
    table.ApplyPreset(panel.preset, True)
    table.NanColor = [0.76, 0.76, 0.76]
    values = cell_values(source, panel.array, time)
    if len(values):
        table.RescaleTransferFunction(*panel.range_of(values))
    table.AutomaticRescaleRangeMode = "Never"
    show_bar(display, view, table, 0.5)
    write_title(view, panel.title)


def show_soil(view, series, depth):
    """The materials, before the place where they were in light grey, `depth` behind them."""
    display = show_surface(series, view)
    simple.ColorBy(display, ("CELLS", "material"))
    table = simple.GetColorTransferFunction("material")
    names = material_names(series)
    table.InterpretValuesAsCategories = 1
    table.Annotations = [word for number, name in enumerate(names) for word in (str(number), name)]
    table.IndexedColors = [COLOURS[i % len(COLOURS)] for i in range(3 * len(names))]
    show_bar(display, view, table, 0.85)
    former = show_surface(add_former_place(series), view)
    former.ColorArrayName = ["POINTS", ""]
    former.AmbientColor = former.DiffuseColor = [0.80, 0.80, 0.84]
    former.Position = [0.0, 0.0, -depth]
    write_title(view, "Soil as it is (light grey: as it was)")


def four_views(layout):
    """Two above two, all looking along the same camera."""
    left = layout.SplitHorizontal(0, 0.5)
    cells = [layout.SplitVertical(left, 0.5), layout.SplitVertical(left + 1, 0.5)]
    places = [cells[0], cells[1], cells[0] + 1, cells[1] + 1]
    views = []
    for place in places:
        view = simple.CreateView("RenderView")
        view.InteractionMode = "2D"
        view.OrientationAxesVisibility = 0
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        simple.AssignViewToLayout(view=view, layout=layout, hint=place)
        views.append(view)
    for i, view in enumerate(views[1:]):
        simple.AddCameraLink(views[0], view, f"four views {id(layout)} {i}")
    return views


def look_at(view, bounds):
    """The whole section, with room below for the colour bar and above for the title."""
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    shape = view.ViewSize[0] / max(view.ViewSize[1], 1)
    middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2]
    view.CameraFocalPoint = [*middle, 0.0]
    view.CameraPosition = [*middle, 10.0 * max(width, height)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelProjection = 1
    view.CameraParallelScale = max(0.53 * width / shape, 0.5 * height / 0.64)


def arrange(series, time=None, size=None):
    """The layout of four views on a series, its clock at the frame next to `time` or at the last."""
    layout = simple.CreateLayout("four views")
    views = four_views(layout)
    if size:
        layout.SetSize(*size)
    last = last_time(series)
    series.UpdatePipeline(last)
    bounds = series.GetDataInformation().GetBounds()
    show_soil(views[0], series, 0.01 * (bounds[3] - bounds[2]))
    has_water = series.CellData.GetArray("ru") is not None
    show_panel(views[1], series, RU if has_water else VOLUME, last)
    show_panel(views[2], add_settlement(series), SETTLEMENT, last)
    show_panel(views[3], series, SHEAR, last)
    for view in views:
        write_time(view, series)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().AnimationTime = last if time is None else nearest_time(series, time)
    simple.RenderAllViews()
    look_at(views[0], bounds)
    simple.RenderAllViews()
    return layout


def two_numbers(text):
    try:
        width, height = (int(number) for number in text.split("x"))
    except ValueError:
        raise argparse.ArgumentTypeError("a size is written WIDTHxHEIGHT, for example 1600x900") from None
    return width, height


def draw():
    parser = argparse.ArgumentParser(prog="four_views.py", description="Four views of a run by ParaView.")
    parser.add_argument("results", help="folder that 'quicksand run' has written, or a .pvd file of particles")
    parser.add_argument("--time", type=float, help="time in s, of which the nearest frame is drawn; the last without it")
    parser.add_argument("--image", help="PNG file to write; RESULTS/four_views.png without it")
    parser.add_argument("--size", type=two_numbers, default=(1600, 900), help="of the image, 1600x900 without it")
    options = parser.parse_args()
    series = open_series(options.results)
    if sys.platform == "linux" and not os.environ.get("DISPLAY"):
        sys.exit("ParaView draws on a display, and there is none\nhint: xvfb-run -a -s '-noreset -screen 0 1280x1024x24' pvpython four_views.py ...")
    results = Path(options.results)
    image = options.image or (results if results.is_dir() else results.parent) / "four_views.png"
    layout = arrange(series, options.time, options.size)
    simple.SaveScreenshot(str(image), layout, ImageResolution=options.size)
    print(f"{image}: t = {simple.GetAnimationScene().AnimationTime:g} s")


def in_a_window():
    """Whether ParaView's window runs this: it gives a macro an empty name."""
    return paraview.fromGUI or not any(sys.argv)


if in_a_window():
    arrange(opened_series())
elif __name__ == "__main__":
    draw()
