# SPDX-License-Identifier: GPL-3.0-or-later
"""A table that is shown in the terminal and in Markdown, and written as CSV and JSON: the same rows in each.

    table = Table([Column("step", "s"), Column("crest peak", "m", "%.4g"), Column("change", show=percent)])
    table.add(0.001, 0.01122, 0.0)
    print(table.text())
    table.write("output/study", "table")

Numbers are kept as they are (SI in files); `show` says how people see them. A Cell has words of its own instead.
"""

import csv
import io
import json
import math
import os
from dataclasses import dataclass

from tabulate import tabulate


@dataclass(frozen=True)
class Column:
    """name: unique, the head in files. unit: "" for none. show: format or function of a number. head: of people, by default name [unit]."""

    name: str
    unit: str = ""
    show: object = "%.4g"
    head: str = None

    @property
    def title(self):
        return self.name + (" [%s]" % self.unit if self.unit else "")

    def words(self, value):
        """How people see a value of this column."""
        if isinstance(value, Cell):
            return value.shown
        if value is None:
            return "-"
        if isinstance(value, (str, bool)):
            return str(value)
        return self.show(value) if callable(self.show) else self.show % value


@dataclass(frozen=True)
class Cell:
    """A value that people see otherwise than its column says, in another unit for example."""

    value: object
    shown: str


def percent(value):
    """+2 %, -0.4 %, +0.002 %, ~0 %; 0 % only for what is the same. from 0: infinite. ?: not a number."""
    if not math.isfinite(value):
        return "?" if math.isnan(value) else "from 0"
    number = 100 * value
    if abs(number) < 5e-4:
        return "~0 %" if number else "0 %"
    return ("%+.0f %%" if abs(number) >= 0.95 else "%+.1g %%") % number


class Table:
    """Columns and rows; a row has a value for each column: number, text, None (there is none) or Cell."""

    def __init__(self, columns, rows=()):
        self.columns, self.rows = list(columns), [list(row) for row in rows]

    def add(self, *values):
        """Append a row."""
        if len(values) != len(self.columns):
            raise ValueError("%d values for %d columns" % (len(values), len(self.columns)))
        self.rows.append(list(values))

    def text(self, without_repeats=True):
        """For a terminal. without_repeats: words of the first column are left out where they are those of the row above."""
        words = self._words()
        if without_repeats:
            words = [[("" if row and words[row - 1][0] == line[0] else line[0])] + line[1:] for row, line in enumerate(words)]
        lines = tabulate(words, self._heads(), tablefmt="plain", colalign=self._alignment(), disable_numparse=True)
        return "\n".join(line.rstrip() for line in lines.splitlines())

    def markdown(self):
        """A table of GitHub's Markdown."""
        def safe(line):
            return [word.replace("|", "\\|").replace("\n", " ") for word in line]

        return tabulate([safe(line) for line in self._words()], safe(self._heads()), tablefmt="pipe", colalign=self._alignment(),
                        disable_numparse=True)

    def csv(self):
        """Comma-separated values with every digit; heads are "name [unit]"; what there is not is empty."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow([column.title for column in self.columns])
        writer.writerows([["" if value is None else value for value in line] for line in self._values()])
        return text.getvalue()

    def records(self):
        """Rows for JSON: {name: value}; numbers that are not finite are None."""
        def plain(value):
            return None if isinstance(value, float) and not math.isfinite(value) else value

        return [{column.name: plain(value) for column, value in zip(self.columns, line)} for line in self._values()]

    def write(self, directory, name, more=None, above="", below=""):
        """directory/name.csv, .md and .json, this with "units", "rows" and the members of `more`; above and below: of the table in
        Markdown. @return their paths."""
        content = dict(more or {}, units={column.name: column.unit for column in self.columns if column.unit}, rows=self.records())
        texts = {"csv": self.csv(), "md": "\n\n".join(filter(None, [above, self.markdown(), below])).rstrip() + "\n",
                 "json": json.dumps(content, indent=2, allow_nan=False) + "\n"}
        os.makedirs(directory, exist_ok=True)
        paths = [os.path.join(directory, "%s.%s" % (name, kind)) for kind in texts]
        for path, text in zip(paths, texts.values()):
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return paths

    def _values(self):
        return [[_plain(value) for value in row] for row in self.rows]

    def _words(self):
        return [[column.words(value) for column, value in zip(self.columns, row)] for row in self.rows]

    def _heads(self):
        return [column.title if column.head is None else column.head for column in self.columns]

    def _alignment(self):
        """Numbers to the right, words to the left."""
        return ["left" if any(isinstance(row[c], str) for row in self._values()) else "right" for c in range(len(self.columns))]


def _plain(value):
    """What a cell holds; numbers of numpy as those of Python."""
    value = value.value if isinstance(value, Cell) else value
    return value.item() if hasattr(value, "item") else value
