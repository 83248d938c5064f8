"""The text of a parameter file: entries are read and replaced where they stand, all else stays as it is."""

import re
from dataclasses import dataclass
from pathlib import Path

from thelma.errors import ThelmaError

NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(.*)$", re.DOTALL)


@dataclass(frozen=True)
class Entry:
    """`set NAME = VALUE # COMMENT` at some lines."""

    path: tuple  # sections and name
    value: str
    comment: str
    lines: range

    @property
    def name(self):
        """As `thelma --set` takes it."""
        return "/".join(self.path)


def words(text):
    """Runs of blanks count as one."""
    return " ".join(text.split())


class ParameterText:
    """A parameter file in memory."""

    def __init__(self, text, name="parameters"):
        self.lines, self.name = text.splitlines(), name
        self.entries, self.sections = {}, {(): range(len(self.lines) + 1)}
        self.parse()

    @classmethod
    def read(cls, path):
        """Of a file."""
        try:
            return cls(Path(path).read_text(encoding="utf-8-sig"), str(path))
        except (OSError, UnicodeDecodeError):
            raise ThelmaError(f"{path}: cannot read this parameter file; give the path of an existing "
                              ".prm") from None

    def parse(self):
        """Finds entries and sections."""
        self.entries.clear()
        self.sections = {(): range(len(self.lines))}
        opened, i = [], 0
        while i < len(self.lines):
            first, line = i, self.lines[i]
            while line.partition("#")[0].rstrip().endswith("\\") and i + 1 < len(self.lines):
                i += 1
                line = line.partition("#")[0].rstrip()[:-1] + self.lines[i]
            i += 1
            statement, _, comment = line.partition("#")
            kind, _, rest = words(statement).partition(" ")
            if kind == "subsection":
                opened.append((rest, first))
            elif kind == "end" and opened:
                path = tuple(name for name, _ in opened)
                self.sections.setdefault(path, range(opened.pop()[1], i))
            elif kind == "set" and "=" in rest:
                name, _, value = rest.partition("=")
                path = (*(name for name, _ in opened), name.strip())
                self.entries[path] = Entry(path, value.strip(), comment.strip(), range(first, i))

    def set(self, entry, value):
        """Gives an entry, `Section/Entry`, a value, where it stands or at the end of its section."""
        path = tuple(words(part) for part in entry.split("/"))
        if path in self.entries:
            self.replace(self.entries[path], str(value), self.entries[path].comment)
        else:
            self.insert(path, str(value))
        self.parse()

    def replace(self, entry, value, comment):
        """A new value and comment."""
        head = re.match(r"[^=]*=\s*", self.lines[entry.lines[0]]).group()
        tail = f"  # {comment}" if comment else ""
        self.lines[entry.lines.start:entry.lines.stop] = [f"{head}{value}{tail}"]

    def insert(self, path, value):
        """A new entry in the innermost of its sections that is there."""
        depth = max(n for n in range(len(path)) if path[:n] in self.sections)
        missing = path[depth:-1]
        indents = ["  " * (depth + n) for n in range(len(missing) + 1)]
        lines = [f"{indent}subsection {name}" for indent, name in zip(indents, missing)]
        lines.append(f"{indents[-1]}set {path[-1]} = {value}")
        lines += [f"{indent}end" for indent in reversed(indents[:-1])]
        section = self.sections[path[:depth]]
        place = section.stop - 1 if depth else section.stop
        self.lines[place:place] = lines

    def section(self, path):
        """The text of a section, from `subsection` to `end`, at the left margin."""
        lines = [self.lines[i] for i in self.sections[tuple(path)]]
        indent = len(lines[0]) - len(lines[0].lstrip())
        return "\n".join(line[indent:] if not line[:indent].strip() else line for line in lines) + "\n"

    def subsections(self, *path):
        """Names of the sections in a section."""
        return [one[-1] for one in self.sections if one[:-1] == path and one]

    def __str__(self):
        return "\n".join(self.lines) + "\n"


def numbers(value):
    """(number, what follows it) of the parts of a value, `15 kPa` or `0.5, -0.36`."""
    parts = [NUMBER.match(part) for part in value.split(",")]
    if not all(parts):
        raise ValueError(value)
    return [(float(part[1]), part[2].rstrip()) for part in parts]
