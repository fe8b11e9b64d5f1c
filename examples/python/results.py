"""Results of Quicksand as tables and arrays: histories with pandas, frames with meshio."""
import re
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import pandas


def read_history(results, probe=None):
    """history.csv, or the rows of a probe, with time_s as index; every column has its unit in its name."""
    name = f"probes/{probe}.csv" if probe else "history.csv"
    return pandas.read_csv(Path(results) / name, comment="#", index_col="time_s")


def probe_names(results):
    """Of the probes that are points: a profile has the column distance_m."""
    names = sorted(file.stem for file in (Path(results) / "probes").glob("*.csv"))
    return [name for name in names if "distance_m" not in read_history(results, name).columns]


def frame_files(results, series="fields"):
    """[(time in s, file)] of fields.pvd, the particles, or grid.pvd, the nodes of the grid."""
    tree = xml.parse(Path(results) / f"{series}.pvd")
    return [(float(entry.get("timestep")), Path(results) / entry.get("file")) for entry in tree.iter("DataSet")]


def read_frame(file):
    """A frame as meshio has it. Its list of units, which meshio cannot read, is left out."""
    text = re.sub(r"<FieldData>.*?</FieldData>", "", Path(file).read_text(), flags=re.DOTALL)
    with tempfile.NamedTemporaryFile("w", suffix=".vtu") as copy:
        copy.write(text)
        copy.flush()
        return meshio.read(copy.name)
