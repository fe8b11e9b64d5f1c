"""One history of pairs of runs, a panel each: sands.py OUT.png TITLE PROBE COLUMN RESULTS RESULTS [TITLE ...]

PROBE is the name of a probe, or history for history.csv; the runs of a pair bear the names of their laws.
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from results import read_history

LAWS = ("UBCSAND", "PM4Sand")


def main(out, cells):
    panels = [cells[k:k + 5] for k in range(0, len(cells), 5)]
    figure, axes = plt.subplots((len(panels) + 1) // 2, 2, figsize=(10, 3.2 * ((len(panels) + 1) // 2)), squeeze=False)
    for axis, (title, probe, column, *runs) in zip(axes.flat, panels):
        for law, results in zip(LAWS, runs):
            values = read_history(results, None if probe == "history" else probe)[column]
            sign = 1.0 if values.iloc[-1] > 0.0 else -1.0  # settlement is downward displacement
            axis.plot(values.index, sign * values * 1000.0, label=law, linewidth=1.0)
        axis.set(title=title, xlabel="time [s]", ylabel="mm")
        axis.legend()
    figure.tight_layout()
    figure.savefig(out, dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
