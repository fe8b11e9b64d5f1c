"""Numbers out of the results of a run: rows of CSV files, the manifest, printed lines."""
import csv
import json
import math
import re

# Columns of the program are SI and carry their unit at the end of their names.
FACTORS = {("m", "mm"): 1e3, ("Pa", "kPa"): 1e-3, ("", "%"): 1e2}
UNITS = ["N_s", "m_s2", "m_s", "Pa", "m", "s", "J", "kg", "m3"]


class NotFound(Exception):
    """The results do not have what is asked for; says what."""


def read_csv(file):
    """Columns by name; what is no number stays a text, an empty cell is nan."""
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.reader(lines))
    return {name: [cell_of(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def cell_of(text):
    try:
        return float(text) if text else math.nan
    except ValueError:
        return text


def factor_of(column, unit):
    """What a column's values are multiplied with to be in the unit."""
    own = next((known for known in UNITS if column.endswith("_" + known)), "")
    return FACTORS.get((own, unit), 1.0)


def rows_where(table, conditions):
    count = len(next(iter(table.values())))
    return [k for k in range(count) if all(table[name][k] == wanted for name, wanted in conditions.items())]


def mean_between(times, values, begin, end):
    """By the trapezoidal rule, so that the mean of whole cycles has none of their swing."""
    slack = 1e-9 * max(1.0, end)
    rows = [k for k, time in enumerate(times) if begin - slack <= time <= end + slack]
    if len(rows) < 2:
        raise NotFound(f"less than two rows between {begin} and {end} s")
    area = sum((times[k + 1] - times[k]) * (values[k] + values[k + 1]) / 2 for k in rows[:-1])
    return area / (times[rows[-1]] - times[rows[0]])


def value_at(times, values, wanted):
    """That of the row nearest in time."""
    if wanted > times[-1] * (1 + 1e-9):
        raise NotFound(f"the run ends at {times[-1]} s, before {wanted} s")
    return values[min(range(len(times)), key=lambda k: abs(times[k] - wanted))]


def time_when(times, values, level):
    for time, value in zip(times, values):
        if value >= level:
            return time
    raise NotFound(f"{level} is not reached")


def of_column(table, row):
    """One number of a column, as the row says it: where, at, mean, reaches or take."""
    values = table[row["column"]]
    if "where" in row:
        found = [values[k] for k in rows_where(table, row["where"])]
        if not found:
            raise NotFound(f"no row where {row['where']}")
        return found if isinstance(row["value"], list) else found[-1]
    times = table["time_s"]
    if "at" in row:
        return value_at(times, values, row["at"])
    if "mean" in row:
        return mean_between(times, values, *row["mean"])
    if "reaches" in row:
        return time_when(times, values, row["reaches"])
    finite = [value for value in values if not math.isnan(value)]
    take = {"max": max, "min": min, "last": lambda all_of: all_of[-1], "size": lambda all_of: max(map(abs, all_of))}
    return take[row["take"]](finite)


def read_number(results, printed, row):
    """What the run gives for a row of the table, in the row's unit."""
    if "printed" in row:
        found = re.search(row["printed"], printed)
        if not found:
            raise NotFound(f"the program did not print '{row['printed']}'")
        return float(found[1].replace(",", "")) * row.get("scale", 1.0)
    if "manifest" in row:
        return json.loads((results / "run_manifest.json").read_text())[row["manifest"]] * row.get("scale", 1.0)
    file = results / row.get("file", "history.csv")
    if not file.exists():
        raise NotFound(f"there is no {file}")
    table = read_csv(file)
    if row["column"] not in table:
        raise NotFound(f"{file.name} has no column {row['column']}")
    # a time at which something happens is in the unit of the time
    source = "time_s" if "reaches" in row else row["column"]
    factor = factor_of(source, row.get("unit", "")) * row.get("scale", 1.0)
    value = of_column(table, row)
    return [factor * part for part in value] if isinstance(value, list) else factor * value
