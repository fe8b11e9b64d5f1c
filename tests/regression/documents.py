"""The documents that show numbers: their generated tables, their statements, their commands."""
import re

MARKED = re.compile(r"^<!-- regression:(\w+) -->\n(.*?)^<!-- /regression -->\n", re.MULTILINE | re.DOTALL)
PLACE = re.compile(r"\{([a-z]\w*\.\w+)(?:\[(\d)\])?(?::([^}]+))?\}")


def documents(root):
    return [root / "README.md", root / "examples/TUTORIAL.md", root / "examples/GUIDE.md",
            *sorted((root / "examples").glob("*/README.md"))]


def shown(value, form):
    """A number as a document shows it; the form is Python's, or 'duration' for seconds, as 17m31s."""
    if isinstance(value, str):
        return value
    if isinstance(value, list):
        return " / ".join(shown(part, form) for part in value)
    if form == "duration":
        return f"{int(value // 60)}m{round(value % 60):02d}s" if value >= 60 else f"{value:g} s"
    return re.sub(r"e([-+])0(\d)", lambda power: "e" + power[1].strip("+") + power[2], format(value, form or "g"))


def filled(template, numbers):
    """The template with its numbers, each written {run.name:form}, or {run.name[0]:form} for one of a list."""
    def number(place):
        if place[1] not in numbers:
            raise SystemExit(f"there is no number {place[1]}")
        value = numbers[place[1]]["value"]
        return shown(value[int(place[2])] if place[2] else value, place[3])
    return PLACE.sub(number, template)


class Documents:
    """All documents beside the templates of their tables."""

    def __init__(self, root, table):
        self.root, self.table = root, table
        self.templates = {file.stem: file.read_text() for file in (table.file.parent / "tables").glob("*.md")}

    def name(self, document):
        return document.relative_to(self.root).as_posix()

    def quoted_in(self, number):
        """Documents that show the number."""
        names = [self.name(document) for document in documents(self.root) for mark in MARKED.finditer(
            document.read_text()) if number in {place[1] for place in PLACE.finditer(self.templates.get(mark[1], ""))}]
        names += [document for document, statements in self.table.statements.items()
                  if any(number in {place[1] for place in PLACE.finditer(text)} for text in statements)]
        return ", ".join(dict.fromkeys(names)) or "no document"

    def with_tables(self, document):
        """The document's text with its tables made anew."""
        def made(mark):
            if mark[1] not in self.templates:
                raise SystemExit(f"{self.name(document)}: there is no tests/regression/tables/{mark[1]}.md")
            body = filled(self.templates[mark[1]], self.table.numbers)
            return f"<!-- regression:{mark[1]} -->\n{body}<!-- /regression -->\n"
        return MARKED.sub(made, document.read_text())

    def write_tables(self):
        for document in documents(self.root):
            document.write_text(self.with_tables(document))

    def findings(self):
        """What the documents say that the table of numbers does not."""
        used = []
        for document in documents(self.root):
            text = document.read_text()
            used += [mark[1] for mark in MARKED.finditer(text)]
            for old, new in zip(MARKED.finditer(text), MARKED.finditer(self.with_tables(document))):
                wrong = [(a, b) for a, b in zip(old[2].splitlines(), new[2].splitlines()) if a != b]
                if old[2] != new[2]:
                    has, wants = wrong[0] if wrong else ("other rows", "those of the template")
                    yield (f"{self.name(document)}: table {old[1]} is not as tests/regression makes it:\n  has    {has}\n"
                           f"  wants  {wants}\n  change numbers.toml or tables/{old[1]}.md and make it anew: "
                           "tests/regression/regression.py --readme")
        for name in sorted(self.templates):
            if used.count(name) != 1:
                yield f"tests/regression/tables/{name}.md: {used.count(name)} documents have its table, not one"
        yield from self.other_files()
        for document, statements in self.table.statements.items():
            text = " ".join((self.root / document).read_text().split())
            for statement in statements:
                if (wanted := filled(statement, self.table.numbers)) not in text:
                    yield f"{document}: does not say '{wanted}', which numbers.toml states: change one of the two"

    def other_files(self):
        """Files that a document shows otherwise than they are."""
        for run in self.table.runs.values():
            for name in run.get("shows", []):
                file = self.root / name
                if file.read_text() not in files_of(self.root / run["document"], file.suffix[1:]):
                    yield f"{run['document']}: does not show {name} as it is"


def commands_of(document):
    """The lines of its blocks of shell, without their comments."""
    blocks = re.findall(r"^```sh\n(.*?)^```", document.read_text(), re.MULTILINE | re.DOTALL)
    lines = [re.sub(r"\s+#\s.*$", "", line).strip() for block in blocks for line in block.splitlines()]
    return [line for line in lines if line]


def files_of(document, language):
    """The texts of its blocks in a language."""
    return re.findall(rf"^```{language}\n(.*?)^```", document.read_text(), re.MULTILINE | re.DOTALL)
