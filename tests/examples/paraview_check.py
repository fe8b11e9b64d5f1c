#!/usr/bin/env python3
"""Do ParaView (or plain VTK) and the probe files tell the same?

    paraview_check.py RESULTS [--reader paraview|vtk] [--tolerance 1e-6]

Opens fields.pvd and grid.pvd, lists their times, and compares at every frame
  - each fixed probe's CSV with the grid probed at the same point,
  - each material probe's CSV with the cell of its particle in fields.pvd, but for stresses: probes have
    those of a plane through the particles around.
Differences count relative to the largest magnitude of the history. Exit code 0: all agree.
"""
import argparse
import csv
import pathlib
import re
import sys
import xml.etree.ElementTree

PROBED = {
    "pore_pressure_Pa": "pore_pressure",
    "excess_pore_pressure_Pa": "excess_pore_pressure",
    "mean_effective_stress_Pa": "mean_effective_stress",
    "vertical_effective_stress_Pa": "vertical_effective_stress",
}
OF_PARTICLE = {column: field for column, field in PROBED.items() if "stress" not in column}


class ParaViewSeries:
    """A .pvd series as ParaView's own pipeline reads it."""

    def __init__(self, index):
        from paraview import servermanager, simple

        self.simple, self.fetch = simple, servermanager.Fetch
        self.reader = simple.PVDReader(FileName=str(index))
        self.reader.UpdatePipelineInformation()
        self.times = [float(time) for time in self.reader.TimestepValues]

    def whole(self, time):
        self.reader.UpdatePipeline(time)
        return self.fetch(self.reader)

    def at_point(self, time, x, y):
        """Point data at (x, y), None outside the soil."""
        probe = self.simple.ProbeLocation(Input=self.reader, ProbeType="Fixed Radius Point Source")
        probe.ProbeType.Center = [x, y, 0.0]
        probe.ProbeType.Radius = 0.0
        probe.ProbeType.NumberOfPoints = 1
        probe.UpdatePipeline(time)
        found = self.fetch(probe)
        self.simple.Delete(probe)
        return point_values(found)


class VtkSeries:
    """The same by VTK's XML reader and probe filter."""

    def __init__(self, index):
        from vtkmodules import vtkCommonCore, vtkCommonDataModel, vtkFiltersCore, vtkIOXML

        self.core, self.model, self.filters, self.xml = vtkCommonCore, vtkCommonDataModel, vtkFiltersCore, vtkIOXML
        entries = xml.etree.ElementTree.parse(index).getroot().iter("DataSet")
        self.files = {float(entry.get("timestep")): index.parent / entry.get("file") for entry in entries}
        self.times = sorted(self.files)

    def whole(self, time):
        reader = self.xml.vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(self.files[time]))
        reader.Update()
        return reader.GetOutput()

    def at_point(self, time, x, y):
        points = self.core.vtkPoints()
        points.SetDataTypeToDouble()
        points.InsertNextPoint(x, y, 0.0)
        place = self.model.vtkPolyData()
        place.SetPoints(points)
        probe = self.filters.vtkProbeFilter()
        probe.SetInputData(place)
        probe.SetSourceData(self.whole(time))
        probe.Update()
        return point_values(probe.GetOutput())


def point_values(found):
    data = found.GetPointData()
    mask = data.GetArray("vtkValidPointMask")
    if mask is None or mask.GetTuple1(0) == 0:
        return None
    names = [data.GetArrayName(k) for k in range(data.GetNumberOfArrays())]
    return {name: data.GetArray(name).GetTuple1(0) for name in names if data.GetArray(name).GetNumberOfComponents() == 1}


def cell_values(grid, particle):
    data = grid.GetCellData()
    numbers = data.GetArray("particle_id")
    for cell in range(grid.GetNumberOfCells()):
        if int(numbers.GetTuple1(cell)) == particle:
            return {name: data.GetArray(name).GetTuple1(cell) for name in OF_PARTICLE.values() if data.HasArray(name)}
    return None


class Probe:
    """One probes/NAME.csv: its kind, its particle if it rides with one, and its rows."""

    def __init__(self, path):
        lines = path.read_text(encoding="utf-8").splitlines()
        comment = next((line for line in lines if line.startswith("# probe: ")), "")
        self.name = path.stem
        self.kind = next((kind for kind in ("material", "fixed") if f"{path.stem}, {kind}: " in comment), "other")
        particle = re.search(r"rides with particle (\d+)", comment)
        self.particle = int(particle.group(1)) if particle else None
        self.rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))

    def row_at(self, time):
        near = min(self.rows, key=lambda row: abs(float(row["time_s"]) - time))
        return near if abs(float(near["time_s"]) - time) <= 1e-9 * max(1.0, time) else None

    def largest(self, column):
        return max((abs(float(row[column])) for row in self.rows if row.get(column)), default=0.0)


def read_there(probe, row, time, fields, grid):
    """What the reader finds at the probe's place at that time."""
    if probe.kind == "fixed":
        return grid.at_point(time, float(row["x_m"]), float(row["y_m"]))
    return cell_values(fields.whole(time), probe.particle)


def compare(probe, fields, grid):
    """(number of values compared, worst relative difference, where) of a probe."""
    count, worst, where = 0, 0.0, "-"
    for time in grid.times:
        row = probe.row_at(time)
        if row is None or not row["x_m"]:
            continue
        values = read_there(probe, row, time, fields, grid)
        if values is None:
            return count, float("inf"), f"no value at t = {time} s"
        for column, field in (PROBED if probe.kind == "fixed" else OF_PARTICLE).items():
            if not row.get(column) or field not in values:
                continue
            scale = probe.largest(column)
            difference = abs(values[field] - float(row[column])) / scale if scale > 0.0 else abs(values[field])
            count += 1
            if difference >= worst:
                worst, where = difference, f"{field} at t = {time:g} s: {values[field]:.9g} against {row[column]}"
    return count, worst, where


def check_times(fields, grid):
    print(f"fields.pvd: {len(fields.times)} times, {fields.times[0]:g} to {fields.times[-1]:g} s")
    print(f"grid.pvd:   {len(grid.times)} times, {grid.times[0]:g} to {grid.times[-1]:g} s")
    return fields.times == grid.times and len(set(grid.times)) == len(grid.times)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--reader", choices=("paraview", "vtk"), default="paraview")
    parser.add_argument("--tolerance", type=float, default=1e-6)
    options = parser.parse_args()

    Series = ParaViewSeries if options.reader == "paraview" else VtkSeries
    fields, grid = Series(options.results / "fields.pvd"), Series(options.results / "grid.pvd")
    good = check_times(fields, grid)
    if not good:
        print("the times of fields.pvd and grid.pvd differ")

    kinds = set()
    for path in sorted((options.results / "probes").glob("*.csv")):
        probe = Probe(path)
        if probe.kind == "other":
            continue
        count, worst, where = compare(probe, fields, grid)
        agrees = count > 0 and worst <= options.tolerance
        print(f"{probe.name} ({probe.kind}): {count} values, worst difference {worst:.3g} ({where})"
              f"{'' if agrees else '  <-- WRONG'}")
        good = good and agrees
        kinds.add(probe.kind)
    if kinds != {"fixed", "material"}:
        print("the results need a fixed and a material probe for this check")
        good = False
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
