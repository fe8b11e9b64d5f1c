#!/usr/bin/env python3
"""The tools of this folder find what they are there to find: results, a table and documents of a few lines."""
import argparse
import datetime
import math
import tempfile
import unittest
from pathlib import Path

import commands
import regression
import results
from documents import Documents, commands_of, filled
from number_table import NumberTable, differs

HISTORY = """# Quicksand
time_s,crest_settlement_m,excess_pore_pressure_Pa,ru
0,0,1000,0.1
1,0.001,3000,0.96
2,0.003,-9000,
"""
TABLE = """[tolerances.close]
relative = 0.01
reason = "of rounding"
[runs.dike]
commands = ["./qs run examples/dike"]
[runs.dike_costs]
measured = "once"
[runs.grids]
long = true
taken_over = "before all"
[runs.grids_short]
part_of = "grids"
[numbers.dike]
settlement = { value = 3, unit = "mm", column = "crest_settlement_m", take = "last", tolerance = "close" }
steps = { value = 12345, manifest = "steps", tolerance = "close" }
[numbers.dike_costs]
time = { value = 75, unit = "s" }
[numbers.grids]
errors = { value = [4.0, 1.0], file = "errors.csv", column = "error", where = { cells = 10 }, tolerance = "close" }
order = { value = 2.0, tolerance = "close" }
[statements]
"README.md" = ["settles by {dike.settlement:.0f} mm in {dike_costs.time:duration}"]
"""
README = """<!-- regression:dike -->
| 3.0 mm | 12,345 steps |
<!-- /regression -->
The dike settles by 3 mm
in 1m15s.
```sh
./qs run examples/dike   # long
gmsh a.geo
```
"""
TEMPLATE = "| {dike.settlement:.1f} mm | {dike.steps:,} steps |\n"


class Regression(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in {"numbers.toml": TABLE, "README.md": README, "tables/dike.md": TEMPLATE,
                           "examples/TUTORIAL.md": "", "examples/GUIDE.md": "", "history.csv": HISTORY,
                           "run_manifest.json": '{"steps": 12400}', "errors.csv": "cells,error\n10,4\n20,1\n"}.items():
            file = self.root / name
            file.parent.mkdir(exist_ok=True)
            file.write_text(text)
        self.table = NumberTable(self.root / "numbers.toml")

    def read(self, **row):
        return results.read_number(self.root, "factor is 1,234.5\n", {"value": 0.0, **row})

    def documents(self):
        return Documents(self.root, NumberTable(self.root / "numbers.toml"))

    def change(self, name, old, new):
        file = self.root / name
        self.assertIn(old, file.read_text())
        file.write_text(file.read_text().replace(old, new))

    def test_numbers_are_read_in_their_unit(self):
        self.assertEqual(self.read(column="crest_settlement_m", unit="mm", at=0.9), 1.0)
        self.assertEqual(self.read(column="crest_settlement_m", unit="m", take="last"), 0.003)
        self.assertEqual(self.read(column="excess_pore_pressure_Pa", unit="kPa", take="size"), 9.0)
        self.assertEqual(self.read(column="excess_pore_pressure_Pa", unit="kPa", mean=[0, 2]), -0.5)
        self.assertEqual(self.read(column="ru", unit="s", reaches=0.95, scale=120), 120.0)
        self.assertEqual(self.read(column="ru", take="max"), 0.96)
        self.assertEqual(self.read(file="errors.csv", column="error", unit="%", where={"cells": 20}), 100.0)
        self.assertEqual(self.read(file="errors.csv", column="error", where={}, value=[1.0]), [4.0, 1.0])
        self.assertEqual(self.read(manifest="steps"), 12400)
        self.assertEqual(self.read(printed="factor is ([0-9.,]+)"), 1234.5)

    def test_what_results_lack_is_said(self):
        for row, said in (({"column": "height_m", "take": "last"}, "history.csv has no column height_m"),
                          ({"file": "probes/A.csv", "column": "ru"}, "there is no"),
                          ({"column": "ru", "reaches": 2.0}, "2.0 is not reached"),
                          ({"column": "ru", "at": 3.0}, "the run ends at 2.0 s, before 3.0 s"),
                          ({"column": "ru", "mean": [5, 6]}, "less than two rows between 5 and 6 s"),
                          ({"column": "ru", "where": {"time_s": 7}}, "no row where"),
                          ({"printed": "no such line"}, "did not print 'no such line'")):
            with self.assertRaisesRegex(results.NotFound, said):
                self.read(**row)

    def test_a_number_out_of_tolerance_is_told_with_all_that_is_known(self):
        values = regression.read_numbers(self.table, "dike", self.root, "")
        self.assertEqual(list(regression.findings(self.table, self.documents(), values)), [])
        (said,) = regression.findings(self.table, self.documents(), {"dike.settlement": 3.2})
        for words in ("dike.settlement: expected 3 mm, got 3.2 mm", "tolerance close: relative 0.01, for of rounding",
                      "quoted in README.md", "regression.py --update dike"):
            self.assertIn(words, said)
        self.assertTrue(differs(self.table, self.table.numbers["dike.settlement"], math.nan))

    def test_a_shortened_run_has_the_first_numbers_of_lists(self):
        self.assertEqual(list(self.table.numbers_of("grids_short")), ["grids.errors"])
        row = self.table.numbers["grids.errors"]
        self.assertFalse(differs(self.table, row, [4.0]))
        self.assertTrue(differs(self.table, row, [4.1]))

    def test_long_and_measured_runs_are_not_run_unasked(self):
        self.assertEqual(self.table.chosen_runs(long=False), ["dike", "grids_short"])
        self.assertEqual(self.table.chosen_runs(long=True), ["dike", "grids", "grids_short"])

    def test_a_run_has_to_end_well_and_leave_its_files(self):
        self.table.runs["dike"] = {"commands": ["echo gone wrong; false"]}
        with self.assertRaisesRegex(SystemExit, "dike: 'echo gone wrong; false' ends with 1:\ngone wrong"):
            regression.values_of(self.table, "dike", Path("/bin/false"))
        self.table.runs["dike"] = {"commands": ["./qs --version"], "files": ["picture.png"]}
        with self.assertRaisesRegex(SystemExit, "dike: there is no picture.png"):
            regression.values_of(self.table, "dike", Path("/bin/true"))
        with self.assertRaisesRegex(SystemExit, "no run is named dike_costs, dyke; there are dike, grids, grids_short"):
            regression.chosen(self.table, argparse.Namespace(runs=["dike_costs", "dyke"], long=False))

    def test_an_update_changes_values_and_the_day_alone(self):
        self.table.rewrite("dike", {"dike.settlement": 3.1234567})
        self.table.rewrite("grids", {"grids.errors": [4.1, 1.2]})
        expected = TABLE.replace("value = 3,", "value = 3.12346,").replace("[4.0, 1.0]", "[4.1, 1.2]")
        expected = expected.replace("before all", f"{datetime.date.today()}")
        self.assertEqual((self.root / "numbers.toml").read_text(), expected)

    def test_an_update_of_a_shortened_run_keeps_the_rest_of_lists(self):
        regression.update(self.table, "grids_short", {"grids.errors": [4.02]})
        self.assertIn("value = [4.02, 1]", (self.root / "numbers.toml").read_text())

    def test_a_number_needs_a_run_and_a_tolerance(self):
        self.change("numbers.toml", 'take = "last", tolerance = "close"', 'take = "last"')
        with self.assertRaisesRegex(SystemExit, "dike.settlement: its tolerance is none of close"):
            NumberTable(self.root / "numbers.toml")
        self.change("numbers.toml", "[numbers.dike]", "[numbers.dyke]")
        with self.assertRaisesRegex(SystemExit, r"there is no \[runs.dyke\]"):
            NumberTable(self.root / "numbers.toml")

    def test_documents_and_table_agree(self):
        self.assertEqual(list(self.documents().findings()), [])
        self.change("README.md", "3.0 mm", "3.3 mm")
        (said,) = self.documents().findings()
        for words in ("README.md: table dike", "has    | 3.3 mm", "wants  | 3.0 mm", "regression.py --readme"):
            self.assertIn(words, said)
        self.documents().write_tables()
        self.assertEqual((self.root / "README.md").read_text(), README)

    def test_sentences_and_templates_are_looked_for(self):
        self.change("README.md", "in 1m15s", "in a minute")
        (self.root / "tables/nowhere.md").write_text("")
        said = "\n".join(self.documents().findings())
        self.assertIn("README.md: does not say 'settles by 3 mm in 1m15s'", said)
        self.assertIn("tables/nowhere.md: 0 documents have its table, not one", said)
        self.change("README.md", "regression:dike", "regression:dyke")
        with self.assertRaisesRegex(SystemExit, "README.md: there is no tests/regression/tables/dyke.md"):
            list(self.documents().findings())

    def test_a_document_shows_files_as_they_are(self):
        (self.root / "a.geo").write_text("Point(1);\n")
        self.change("numbers.toml", "[runs.dike]\n", '[runs.dike]\ndocument = "README.md"\nshows = ["a.geo"]\n')
        self.assertEqual(list(self.documents().findings()), ["README.md: does not show a.geo as it is"])

    def test_numbers_are_shown_as_python_writes_them(self):
        numbers = {"a.b": {"value": 4.9e-5}, "a.c": {"value": [0.5, 0.25]}, "a.d": {"value": 12}}
        self.assertEqual(filled("{a.b:.1e}, {a.c}, {a.c[1]:.1f}, {a.d:duration}", numbers), "4.9e-5, 0.5 / 0.25, 0.2, 12 s")
        with self.assertRaisesRegex(SystemExit, "there is no number a.e"):
            filled("{a.e}", numbers)

    def test_commands_of_documents(self):
        self.assertEqual(commands_of(self.root / "README.md"), ["./qs run examples/dike", "gmsh a.geo"])
        rules = {"skipped": {"gmsh no_longer.geo": "opens a window"}, "shortened": {}}
        self.assertEqual(list(commands.unused(rules)), ["commands.toml: no document shows 'gmsh no_longer.geo'"])

    def test_a_command_that_fails_is_told(self):
        document = commands.ROOT / "README.md"
        first, *others = commands_of(document)
        rules = {"skipped": dict.fromkeys(others, ""), "shortened": {first: "echo gone wrong; false"}, "files": {}}
        (said,) = commands.findings(document, rules, set(), Path("/bin/false"))
        self.assertEqual(said, f"README.md: '{first}', run as 'echo gone wrong; false', ends with 1:\ngone wrong\n")


if __name__ == "__main__":
    unittest.main()
