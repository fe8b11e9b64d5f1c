#!/usr/bin/env python3
"""Every command that the documents show works: commands.py [--program FILE] DOCUMENT ...

A command is run as it is written, one that takes long in the shorter form of commands.toml. What opens a window or installs
packages is listed there with the reason, and what a short run of numbers.toml does is not done twice.
"""
import argparse
import sys
import tomllib
from pathlib import Path

from documents import commands_of, documents, files_of
from number_table import NumberTable
from workplace import PROGRAM, ROOT, Workplace

HERE = Path(__file__).resolve().parent


def done_by_numbers(table):
    """Commands of the short runs, which compare their numbers too."""
    return {command for run in table.chosen_runs(long=False) for command in table.runs[run].get("commands", [])}


def write_files(place, files, document):
    """Those whose folder is there by now."""
    for name, file in files.items():
        path = place.path / name
        blocks = [text for text in files_of(document, "toml") if text.startswith(file.get("block", "\0"))]
        if path.parent.exists() and not path.exists() and ("text" in file or blocks):
            path.write_text(file.get("text") or blocks[0])


def findings(document, rules, done, program):
    """A message for every command that fails."""
    with Workplace(program) as place:
        for shown in commands_of(document):
            command = rules["shortened"].get(shown, shown)
            if shown in rules["skipped"] or command in done:
                continue
            write_files(place, rules["files"], document)
            code, said = place.run(command)
            print(f"{command}: {code}", flush=True)
            if code != 0:
                form = "" if command == shown else f", run as '{command}',"
                yield f"{document.relative_to(ROOT)}: '{shown}'{form} ends with {code}:\n{said}"


def unused(rules):
    """A message for every rule about a command that no document shows any more."""
    shown = {command for document in documents(ROOT) for command in commands_of(document)}
    for kind in ("skipped", "shortened"):
        for command in rules[kind].keys() - shown:
            yield f"commands.toml: no document shows '{command}'"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("documents", nargs="+", type=Path, metavar="DOCUMENT")
    parser.add_argument("--program", type=Path, default=PROGRAM)
    given = parser.parse_args()
    table = NumberTable(HERE / "numbers.toml")
    rules = tomllib.loads((HERE / "commands.toml").read_text())
    done = done_by_numbers(table)
    found = [finding for document in given.documents
             for finding in findings(ROOT / document, rules, done, given.program.resolve())]
    found += unused(rules)
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
