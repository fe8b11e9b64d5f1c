#!/usr/bin/env python3
"""The numbers of the documents: numbers.toml beside what the program gives.

    regression.py                     run the short runs and compare their numbers
    regression.py RUN ...             compare those of these runs, long ones too
    regression.py --update [RUN ...]  take the numbers over, and write the documents' tables
    regression.py --long              all runs, some hours; also with --update
    regression.py --results FOLDER RUN   compare or take over from a folder of results that is there already
    regression.py --documents         compare the documents with numbers.toml; nothing is run
    regression.py --readme            write the documents' tables out of numbers.toml and tables/*.md
    regression.py --list              names of the short runs
"""
import argparse
import sys
from pathlib import Path

import results as run_results
from documents import Documents, commands_of
from number_table import NumberTable, differs, written
from workplace import PROGRAM, ROOT, Workplace

TABLE = Path(__file__).with_name("numbers.toml")


def read_numbers(table, run, folder, printed):
    """What the results have for each number of the run; a text where they have none."""
    values = {}
    for name, row in table.numbers_of(run).items():
        try:
            values[name] = run_results.read_number(folder, printed, row)
        except run_results.NotFound as missing:
            values[name] = str(missing)
    return values


def values_of(table, run, program):
    """Numbers that a run gives, by name; its commands have to end well and leave their files."""
    given, printed = table.runs[run], ""
    commands = given.get("commands") or commands_of(ROOT / given["document"])
    with Workplace(program) as place:
        for command in given.get("before", []) + commands:
            code, said = place.run(command)
            if code != 0:
                sys.exit(f"{run}: '{command}' ends with {code}:\n{said}")
            printed += said
        folder = place.path / given.get("results", "")
        for file in given.get("files", []):
            if not (folder / file).exists():
                sys.exit(f"{run}: there is no {file}")
        return read_numbers(table, run, folder, printed)


def findings(table, documents, values):
    """A message for every number out of its tolerance."""
    for name, got in values.items():
        row = table.numbers[name]
        unit = row.get("unit", "")
        if isinstance(got, str):
            yield f"{name}: {got}"
        elif differs(table, row, got):
            tolerance = table.tolerances[row["tolerance"]]
            bounds = ", ".join(f"{kind} {tolerance[kind]}" for kind in ("relative", "absolute") if kind in tolerance)
            yield (f"{name}: expected {written(row['value'])} {unit}, got {written(got)} {unit}\n"
                   f"  tolerance {row['tolerance']}: {bounds or 'none'}, for {tolerance['reason']}\n"
                   f"  quoted in {documents.quoted_in(name)}\n"
                   f"  Is the change meant? Then: tests/regression/regression.py --update {row['run']}")


def update(table, run, values):
    """Take the numbers of a run over, all of them, and tell those that were out of tolerance. A part of a longer
    run gives the first of its lists; the rest stays."""
    found = {name: got for name, got in values.items() if not isinstance(got, str)}
    for name, got in found.items():
        if isinstance(got, list):
            found[name] = got + table.numbers[name]["value"][len(got):]
    for name, got in found.items():
        if differs(table, table.numbers[name], got):
            print(f"{name}: {written(table.numbers[name]['value'])} -> {written(got)}")
    table.rewrite(run, found)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="*", metavar="RUN")
    for name in ("--update", "--long", "--documents", "--readme", "--list"):
        parser.add_argument(name, action="store_true")
    parser.add_argument("--results", type=Path, metavar="FOLDER")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    parser.add_argument("--table", type=Path, default=TABLE)
    return parser.parse_args()


def chosen(table, given):
    """The runs that are asked for."""
    if unknown := [run for run in given.runs if run not in table.runs or "measured" in table.runs[run]]:
        sys.exit(f"no run is named {', '.join(unknown)}; there are {', '.join(table.chosen_runs(True))}")
    return given.runs or table.chosen_runs(given.long)


def main():
    given = arguments()
    table = NumberTable(given.table)
    documents = Documents(ROOT, table)
    found = []
    if given.list:
        print("\n".join(table.chosen_runs(given.long)))
    elif given.documents:
        found = list(documents.findings())
    elif given.readme:
        documents.write_tables()
    else:
        for run in chosen(table, given):
            values = read_numbers(table, run, given.results, "") if given.results else values_of(
                table, run, given.program.resolve())
            print(f"{run}: {len(values)} numbers", flush=True)
            if given.update:
                update(table, run, values)
                values = {name: got for name, got in values.items() if isinstance(got, str)}
            found += findings(table, documents, values)
        if given.update:
            Documents(ROOT, NumberTable(given.table)).write_tables()
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
