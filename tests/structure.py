#!/usr/bin/env python3
"""Whether the house is in order: python3 tests/structure.py includes|sizes|format|spelling|version [root]

includes  Folders stand on each other as solver < geometry < io < app, and in each the rooms as their
          CMakeLists.txt adds them. A file includes its own room and lower ones; of other people's libraries those
          of its folder; and no circle leads back to it (a header and its source are one).
sizes     No file has more than 400 lines, no folder more than 30 sources.
format    clang-format, of the version in packages.txt, has nothing to change.
spelling  codespell finds no word that is spelt wrongly (.codespellrc says which are spelt so on purpose).
version   CMakeLists.txt, CITATION.cff and the newest dated heading of CHANGELOG.md name the same version and date.
"""
import re
import subprocess
import sys
from pathlib import Path

FOLDERS = ["solver", "geometry", "io", "app"]  # each may include those before it
LIBRARIES = {  # besides the standard library and the system's
    "solver": ["Eigen/", "omp.h"],
    "geometry": ["Eigen/", "CGAL/", "gmsh", "nlohmann/", "fmt/"],
    "io": ["Eigen/", "vtk", "hdf5", "toml++/", "nlohmann/", "fmt/"],
    "app": ["Eigen/", "CLI/", "fmt/"],
}
THEIRS = re.compile(r"^(Eigen/|omp\.h|CGAL/|gmsh|nlohmann/|fmt/|vtk|hdf5|H5|toml|CLI/|boost/|gtest/)")
INCLUDE = re.compile(r'^\s*#include\s+([<"])([^>"]+)[>"]')
MOST_LINES, MOST_SOURCES = 400, 30


def sources(root, folders):
    return [path.relative_to(root) for folder in folders for path in sorted((root / folder).rglob("*.[ch]pp"))]


def includes(root, file):
    for number, line in enumerate((root / file).read_text().splitlines(), 1):
        if found := INCLUDE.match(line):
            yield number, found[1] == '"', found[2]


def rooms_of(root, folder):
    return re.findall(r"^add_subdirectory\((\S+)\)", (root / folder / "CMakeLists.txt").read_text(), re.MULTILINE)


def place_of(file, rooms):
    """The folder's and the room's number; a file beside the rooms stands above them."""
    folder, room = file.parts[0], "/".join(file.parts[1:-1])
    if folder not in rooms:
        return None
    if not room:
        return FOLDERS.index(folder), len(rooms[folder])
    return (FOLDERS.index(folder), rooms[folder].index(room)) if room in rooms[folder] else None


def unit_of(file):
    return Path(file).with_suffix("").as_posix()


def find_circle(uses):
    """One circle among the units, or nothing."""
    done, path = set(), []

    def walk(unit):
        if unit in path:
            return path[path.index(unit):] + [unit]
        if unit in done:
            return None
        path.append(unit)
        for other in sorted(uses.get(unit, ())):
            if circle := walk(other):
                return circle
        done.add(path.pop())
        return None

    for unit in sorted(uses):
        if circle := walk(unit):
            return circle
    return None


def check_includes(root):
    rooms = {folder: rooms_of(root, folder) for folder in FOLDERS}
    uses = {}
    for file in sources(root, FOLDERS):
        folder, here = file.parts[0], place_of(file, rooms)
        if here is None:
            yield f"{file}: the folder is no room; add_subdirectory in {folder}/CMakeLists.txt names the rooms"
            continue
        for number, ours, included in includes(root, file):
            if not ours:
                if THEIRS.match(included) and not included.startswith(tuple(LIBRARIES[folder])):
                    yield f"{file}:{number}: <{included}> in {folder}; allowed are {', '.join(LIBRARIES[folder])}"
                continue
            there = place_of(Path(included), rooms)
            if there is None or not (root / included).exists():
                yield f"{file}:{number}: \"{included}\" is no file of a room; name it from the project's root"
            elif there > here:
                yield (f"{file}:{number}: looks up to {Path(included).parent}; {file.parent} may include itself and "
                       f"what stands before it in CMakeLists.txt")
            elif unit_of(included) != unit_of(file):
                uses.setdefault(unit_of(file), set()).add(unit_of(included))
    if circle := find_circle(uses):
        yield "a circle of includes: " + " -> ".join(circle)


def check_sizes(root):
    files = sources(root, FOLDERS + ["tests"])
    for file in files:
        lines = len((root / file).read_text().splitlines())
        if lines > MOST_LINES:
            yield f"{file}: {lines} lines, at most {MOST_LINES}: divide it by what its parts are about"
    for folder in sorted({file.parent for file in files}):
        count = sum(file.parent == folder for file in files)
        if count > MOST_SOURCES:
            yield f"{folder}: {count} sources, at most {MOST_SOURCES}: it holds more than one concept"


def check_format(root):
    version = re.search(r"^clang-format-(\d+)", (root / "packages.txt").read_text(), re.MULTILINE)[0]
    files = [str(file) for file in sources(root, FOLDERS + ["tests"])]
    try:
        run = subprocess.run([version, "--dry-run", "--Werror", *files], cwd=root, capture_output=True, text=True)
    except FileNotFoundError:
        yield f"{version} is not installed: apt install {version}"
        return
    wrong = sorted(set(re.findall(r"^([^:\n]+):\d+:\d+: error: ", run.stderr, re.MULTILINE)))
    yield from (f"{file}: not as {version} writes it: {version} -i {file}" for file in wrong)
    if run.returncode != 0 and not wrong:
        yield run.stderr.strip()


def check_spelling(root):
    try:
        run = subprocess.run(["codespell", "."], cwd=root, capture_output=True, text=True)
    except FileNotFoundError:
        yield "codespell is not installed: apt install codespell"
        return
    yield from run.stdout.splitlines()


def check_version(root):
    places = {  # where the version and its date stand
        "CHANGELOG.md": (r"^## \[(\d\S*)\] - ", r"^## \[\d\S*\] - (\d{4}-\d\d-\d\d)$"),
        "CMakeLists.txt": (r"^project\(\S+ VERSION ([\d.]+)", r"^set\(QUICKSAND_RELEASE_DATE (\S+)\)"),
        "CITATION.cff": (r"^version: (\S+)$", r"^date-released: (\S+)$"),
    }
    found = {}
    for file, patterns in places.items():
        text = (root / file).read_text()
        matches = [re.search(pattern, text, re.MULTILINE) for pattern in patterns]
        if not all(matches):
            yield f"{file}: no version with its date, of the form {' and '.join(patterns)}"
            return
        found[file] = " of ".join(match[1] for match in matches)
    if len(set(found.values())) > 1:
        yield "not one version: " + ", ".join(f"{file} has {what}" for file, what in found.items())
    headings = re.findall(r"^## .*$", (root / "CHANGELOG.md").read_text(), re.MULTILINE)
    if headings[0] != "## [Unreleased]":
        yield "CHANGELOG.md: begins with ## [Unreleased], which holds what comes after the newest version"


def main():
    checks = {"includes": check_includes, "sizes": check_sizes, "format": check_format, "spelling": check_spelling,
              "version": check_version}
    if len(sys.argv) not in (2, 3) or sys.argv[1] not in checks:
        sys.exit(__doc__)
    root = Path(sys.argv[2] if len(sys.argv) == 3 else Path(__file__).parent.parent).resolve()
    findings = list(checks[sys.argv[1]](root))
    for finding in findings:
        print(finding)
    sys.exit(1 if findings else 0)


main()
