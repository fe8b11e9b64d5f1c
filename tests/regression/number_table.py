"""The table of numbers, numbers.toml: read, compared with what a run gives, rewritten."""
import datetime
import math
import re
import tomllib


class NumberTable:
    """Runs, tolerances and numbers; a number is named run.name."""

    def __init__(self, file):
        self.file = file
        whole = tomllib.loads(file.read_text())
        self.runs, self.tolerances = whole["runs"], whole["tolerances"]
        self.statements = whole.get("statements", {})
        self.numbers = {f"{run}.{name}": {**row, "run": run}
                        for run, rows in whole["numbers"].items() for name, row in rows.items()}
        for name, row in self.numbers.items():
            self.check(name, row)

    def check(self, name, row):
        run = self.runs.get(row["run"])
        if run is None:
            raise SystemExit(f"{self.file}: {name}: there is no [runs.{row['run']}]")
        if "measured" not in run and row.get("tolerance") not in self.tolerances:
            raise SystemExit(f"{self.file}: {name}: its tolerance is none of {', '.join(self.tolerances)}")

    def chosen_runs(self, long):
        """Those that can be run: the short ones, or all."""
        return [name for name, run in self.runs.items() if "measured" not in run and (long or not run.get("long"))]

    def numbers_of(self, run):
        """Numbers that this run gives: its own, and the first of each list of a longer run's."""
        whole = self.runs[run].get("part_of")
        return {name: row for name, row in self.numbers.items()
                if row["run"] == run or (row["run"] == whole and isinstance(row["value"], list))}

    def allowed(self, row, expected):
        tolerance = self.tolerances[row["tolerance"]]
        return max(tolerance.get("relative", 0.0) * abs(expected), tolerance.get("absolute", 0.0))

    def rewrite(self, run, values):
        """Put a run's new values into the file, and the day where it says one; all else stays as it is."""
        lines, heading = self.file.read_text().splitlines(keepends=True), ""
        for k, line in enumerate(lines):
            if line.startswith("["):
                heading = line.strip("[]\n")
            elif heading == f"runs.{run}" and line.startswith("taken_over = "):
                lines[k] = f'taken_over = "{datetime.date.today()}"\n'
            elif heading.startswith("numbers."):
                lines[k] = with_value(line, heading.removeprefix("numbers."), values)
        self.file.write_text("".join(lines))


def with_value(line, run, values):
    """The line of a number with its new value, if there is one."""
    found = re.match(r"(\w+) = \{ value = (\[[^\]]*\]|[^,}]*[^,} ])", line)
    if not found or f"{run}.{found[1]}" not in values:
        return line
    return f"{found[1]} = {{ value = {written(values[f'{run}.{found[1]}'])}{line[found.end():]}"


def written(value):
    """As the table has it: six digits."""
    if isinstance(value, list):
        return "[" + ", ".join(written(part) for part in value) + "]"
    text = f"{value:.6g}"
    return text if math.isfinite(value) else "nan"


def pairs(expected, got):
    """Numbers to compare: one, or as many of a list as the run has."""
    return zip(expected, got) if isinstance(expected, list) else [(expected, got)]


def differs(table, row, got):
    """Whether what a run gives is out of tolerance."""
    return any(not abs(one - other) <= table.allowed(row, one) for one, other in pairs(row["value"], got))
