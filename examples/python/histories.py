"""Draw crest settlement and the pore pressure ratio at the probes: histories.py RESULTS [PNG]"""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plot

from results import probe_names, read_history


def main(results, png):
    history = read_history(results)
    figure, (above, below) = plot.subplots(2, 1, sharex=True, figsize=(9, 6))
    above.plot(history.index, 1e3 * history["crest_settlement_m"])
    above.set_ylabel("crest settlement [mm]")
    for name in probe_names(results):
        probe = read_history(results, name)
        if "ru" in probe and probe["ru"].abs().max() > 0.0:
            below.plot(probe.index, probe["ru"], label=name)
    below.set_ylabel("ru [-]")
    below.set_xlabel("time [s]")
    if below.lines:
        below.legend()
    figure.savefig(png, dpi=120)
    print(f"{png}: crest settlement {1e3 * history['crest_settlement_m'].iloc[-1]:.4g} mm at {history.index[-1]:g} s")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else Path(sys.argv[1]) / "histories.png")
