# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid report RUN...: one HTML file that holds all it shows; nothing is fetched, no script runs."""

import os
import re
import subprocess

from hybrid_run import Run, UserError
from hybrid_tools.arguments import Arguments


def version():
    """What the program says of itself, where it is known."""
    program = os.environ.get("HYBRID_PROGRAM")
    if not program:
        return ""
    try:
        said = subprocess.run([program, "--version"], capture_output=True, text=True, timeout=20, check=True).stdout
    except (OSError, subprocess.SubprocessError):
        return ""
    return re.split(r"[\n(]", said)[0].strip()


def labels_of(directories):
    """Last folders of the paths; whole paths where two are the same."""
    last = [os.path.basename(os.path.abspath(directory)) for directory in directories]
    return last if len(set(last)) == len(last) else list(directories)


def write_page(runs, labels, path):
    from jinja2 import Environment, FileSystemLoader

    from hybrid_tools import style

    from .chapters import tell
    from .compared import compare

    style.apply()
    environment = Environment(loader=FileSystemLoader(os.path.dirname(__file__)), autoescape=True)
    told = [tell(run, "r%d" % (i + 1), label) for i, (run, label) in enumerate(zip(runs, labels))]
    title = told[0].title if len(told) == 1 else "%d runs: %s" % (len(told), ", ".join(labels))
    comparison = compare(runs, labels) if len(runs) > 1 else None
    text = environment.get_template("page.html").render(title=title, runs=told, comparison=comparison, version=version())
    temporary = path + ".part"
    try:
        with open(temporary, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(temporary, path)
    except OSError as error:
        raise UserError("cannot write '%s': %s" % (path, error.strerror)) from error


def main(words):
    arguments = Arguments("report", "A page (HTML) that says what happened in a run, or in several, for a browser or a printer.",
                          "  hybrid report output/badong                 output/badong/report.html\n"
                          "  hybrid report output/a output/b --output both.html\n")
    arguments.add_argument("runs", metavar="RUN", nargs="+", help="output directory of a run; the first of several is the reference")
    arguments.add_argument("--output", metavar="FILE", help="where to (default: report.html in RUN; of several runs beside the first)")
    given = arguments.read(words)
    runs = [Run(directory) for directory in given.runs]
    first = os.path.abspath(given.runs[0])
    path = given.output or os.path.join(given.runs[0] if len(runs) == 1 else os.path.dirname(first), "report.html")
    write_page(runs, labels_of(given.runs), path)
    print("report: %s, %.1f MB" % (path, os.path.getsize(path) / 1e6))
    return 0
