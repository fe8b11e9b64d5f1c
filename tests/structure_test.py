#!/usr/bin/env python3
"""structure.py finds what it is there to find: a small house in order, and broken once by each rule."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).with_name("structure.py")
HOUSE = {
    "packages.txt": "clang-format-14\n",
    "CMakeLists.txt": "project(House VERSION 1.2.0)\nset(QUICKSAND_RELEASE_DATE 2026-11-23)\n",
    "CITATION.cff": "version: 1.2.0\ndate-released: 2026-11-23\n",
    "CHANGELOG.md": "## [Unreleased]\n\n## [1.2.0] - 2026-11-23\n\n## [1.1.0] - 2026-01-31\n",
    ".clang-format": "BasedOnStyle: LLVM\n",
    "solver/CMakeLists.txt": "add_subdirectory(base)\nadd_subdirectory(water)\n",
    "solver/base/units.hpp": "#include <vector>\n",
    "solver/base/units.cpp": '#include "solver/base/units.hpp"\n',
    "solver/water/flow.hpp": '#include "solver/base/units.hpp"\n#include <Eigen/Core>\n',
    "geometry/CMakeLists.txt": "",
    "io/CMakeLists.txt": "add_subdirectory(files)\n",
    "io/files/csv.cpp": '#include "solver/water/flow.hpp"\n#include <fmt/format.h>\n',
    "app/CMakeLists.txt": "",
    "app/main.cpp": '#include "io/files/csv.hpp"\n',
    "io/files/csv.hpp": "",
    "tests/unit_test.cpp": '#include "solver/base/units.hpp"\n',
}


class House(unittest.TestCase):
    def findings(self, check, changes):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in {**HOUSE, **changes}.items():
                path = Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            run = subprocess.run([sys.executable, SCRIPT, check, folder], capture_output=True, text=True)
            self.assertEqual(run.returncode, 1 if run.stdout else 0, run.stderr)
            return run.stdout

    def test_a_house_in_order_has_no_findings(self):
        for check in ["includes", "sizes", "format", "spelling", "version"]:
            self.assertEqual(self.findings(check, {}), "")

    def test_no_room_looks_up(self):
        found = self.findings("includes", {"solver/base/units.cpp": '#include "solver/water/flow.hpp"\n'})
        self.assertIn("solver/base/units.cpp:1: looks up to solver/water", found)
        found = self.findings("includes", {"solver/water/flow.cpp": '\n#include "io/files/csv.hpp"\n'})
        self.assertIn("solver/water/flow.cpp:2: looks up to io/files", found)

    def test_libraries_stay_in_their_folders(self):
        found = self.findings("includes", {"solver/base/units.cpp": "#include <fmt/format.h>\n"})
        self.assertIn("<fmt/format.h> in solver; allowed are Eigen/, omp.h", found)

    def test_includes_are_named_from_the_root(self):
        found = self.findings("includes", {"solver/base/units.cpp": '#include "units.hpp"\n'})
        self.assertIn('"units.hpp" is no file of a room', found)

    def test_every_folder_is_a_room(self):
        self.assertIn("the folder is no room", self.findings("includes", {"solver/attic/old.hpp": ""}))

    def test_no_circles(self):
        found = self.findings("includes", {"solver/water/head.hpp": '#include "solver/water/flow.hpp"\n',
                                           "solver/water/flow.cpp": '#include "solver/water/head.hpp"\n'})
        self.assertIn("solver/water/flow -> solver/water/head -> solver/water/flow", found)

    def test_files_and_folders_stay_small(self):
        self.assertIn("401 lines", self.findings("sizes", {"io/files/csv.cpp": "\n" * 401}))
        many = {f"solver/base/part_{k}.hpp": "" for k in range(31)}
        self.assertIn("solver/base: 33 sources, at most 30", self.findings("sizes", many))

    def test_format(self):
        found = self.findings("format", {"io/files/csv.cpp": "int   a;\n"})
        self.assertIn("io/files/csv.cpp: not as clang-format-14 writes it", found)

    def test_spelling(self):
        self.assertIn("teh ==> the", self.findings("spelling", {"README.md": "teh dike\n"}))

    def test_one_version_and_date(self):
        cite = "version: 1.1.0\ndate-released: 2026-11-23\n"
        self.assertIn("not one version", self.findings("version", {"CITATION.cff": cite}))
        earlier = "## [Unreleased]\n\n## [1.2.0] - 2026-11-22\n"
        self.assertIn("CHANGELOG.md has 1.2.0 of 2026-11-22", self.findings("version", {"CHANGELOG.md": earlier}))
        found = self.findings("version", {"CHANGELOG.md": "## [1.2.0] - 2026-11-23\n"})
        self.assertIn("begins with ## [Unreleased]", found)
        undated = self.findings("version", {"CHANGELOG.md": "## [Unreleased]\n\n## [1.2.0]\n"})
        self.assertIn("CHANGELOG.md: no version with its date", undated)


unittest.main()
