"""One history of pairs of runs, a panel each: sands.py OUT.png TITLE FILE COLUMN RESULTS RESULTS [TITLE ...]

FILE is that of the history in the results, as probes/surface.csv; the runs of a pair bear the names of their laws.
"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import pandas

LAWS = ("UBCSAND", "PM4Sand")


def main(out, cells):
    panels = [cells[k:k + 5] for k in range(0, len(cells), 5)]
    figure, axes = plt.subplots((len(panels) + 1) // 2, 2, figsize=(10, 3.2 * ((len(panels) + 1) // 2)), squeeze=False)
    for axis, (title, file, column, *runs) in zip(axes.flat, panels):
        for law, results in zip(LAWS, runs):
            table = pandas.read_csv(Path(results) / file, comment="#")
            sign = 1.0 if table[column].iloc[-1] > 0.0 else -1.0  # settlement is downward displacement
            axis.plot(table["time_s"], sign * table[column] * 1000.0, label=law, linewidth=1.0)
        axis.set(title=title, xlabel="time [s]", ylabel="mm")
        axis.legend()
    figure.tight_layout()
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
