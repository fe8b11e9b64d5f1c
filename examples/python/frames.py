"""Draw a field of the last frame, every particle with its own shape: frames.py RESULTS [FIELD [PNG]]"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot
import numpy
from matplotlib.collections import PolyCollection

from results import frame_files, read_frame


def main(results, field="displacement", png=None):
    time, file = frame_files(results)[-1]
    frame = read_frame(file)
    shapes, values = [], []
    for block, data in zip(frame.cells, frame.cell_data[field]):
        shapes += list(frame.points[block.data][:, :, :2])
        values += list(numpy.linalg.norm(data, axis=1) if data.ndim > 1 else data)
    values = numpy.array(values)
    colours = plot.get_cmap("viridis").copy()
    colours.set_bad("0.76")  # ru has no value where the soil bears no stress
    figure, axes = plot.subplots(figsize=(12, 4))
    soil = axes.add_collection(PolyCollection(shapes, array=values, cmap=colours, edgecolors="face"))
    axes.autoscale()
    axes.set_aspect("equal")
    axes.set_title(f"{field}, t = {time:g} s")
    figure.colorbar(soil, shrink=0.6)
    png = png or Path(results) / f"{field}.png"
    figure.savefig(png, dpi=120)
    print(f"{png}: {len(values)} particles, {field} from {numpy.nanmin(values):.4g} to {numpy.nanmax(values):.4g} in SI units")


if __name__ == "__main__":
    main(*sys.argv[1:])
