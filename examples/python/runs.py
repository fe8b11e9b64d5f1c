"""Peaks and final values of several runs as one table: runs.py RESULTS RESULTS ... (from their manifests)"""
import json
import sys
from pathlib import Path

import pandas


def row(results):
    manifest = json.loads((Path(results) / "run_manifest.json").read_text())
    history = manifest.get("summary", {}).get("history", {})
    cells = {"run": Path(results).name, "verdict": manifest.get("verdict", "")}
    for column, value in history.items():
        cells[f"{column}, peak"] = value["peak"]
        cells[f"{column}, final"] = value["final"]
    return cells


if __name__ == "__main__":
    table = pandas.DataFrame([row(results) for results in sys.argv[1:]]).set_index("run")
    print(table.T.to_string())
