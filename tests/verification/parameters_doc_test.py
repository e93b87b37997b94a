# SPDX-License-Identifier: GPL-3.0-or-later
"""doc/parameters.md must say what `hybrid --print-parameters` says.

    parameters_doc_test.py HYBRID FILE           compare; exit code 1 if they differ
    parameters_doc_test.py HYBRID FILE --write   write the file
"""

import difflib
import re
import subprocess
import sys

HEADER = """# Parameters

Every parameter of a scene, generated from `hybrid --print-parameters` (which prints the same as a valid `.prm`).
A path is used as in `-s "Section/Name=value"`. SI units unless the range says otherwise.
Files resolve against the file that names them; a duplicate or unknown name is an error.
"""

MATERIALS = """
One subsection per name in `Materials/Names`.
"""


def tables(printed):
    """The printed parameters as markdown, one table per section."""
    lines, path, comment, shown = [HEADER], [], [], None
    material = None
    for line in printed.splitlines():
        line = line.strip()
        if line.startswith("#"):
            comment.append(line.lstrip("# ") if not line.startswith(("# Listing", "# ---")) else "")
            continue
        if line.startswith("subsection "):
            path.append(line[len("subsection ") :])
            if len(path) == 2:
                material = material or path[1]
                path[1] = path[1] if path[1] != material else "<name>"
            continue
        if line == "end":
            path.pop()
            continue
        found = re.match(r"set (.*?)\s*= ?(.*)", line)
        if not found:
            comment = []
            continue
        if len(path) == 2 and path[1] != "<name>":
            comment = []
            continue
        if path != shown:
            lines.append("\n## %s" % "/".join(path or ["(top level)"]))
            if len(path) == 2:
                lines.append(MATERIALS.rstrip("\n"))
            lines.append("\n| name | default | allowed | meaning |\n|---|---|---|---|")
            shown = list(path)
        lines.append(row(found.group(1), found.group(2), " ".join(comment).strip()))
        comment = []
    return "\n".join(lines) + "\n"


def row(name, value, comment):
    value, changed, default = value.partition("# default:")
    text = (default if changed else value).strip()
    meaning, _, allowed = comment.partition("Allowed: ")
    cells = (name, "`%s`" % text if text else "", allowed.rstrip("."), meaning.strip())
    return "| %s |" % " | ".join(cell.replace("|", "\\|").replace("<", "&lt;") for cell in cells)


def main(arguments):
    if len(arguments) not in (2, 3):
        return "usage: parameters_doc_test.py HYBRID FILE [--write]"
    printed = subprocess.run([arguments[0], "--print-parameters"], check=True, capture_output=True, text=True).stdout
    expected = tables(printed)
    if arguments[2:] == ["--write"]:
        with open(arguments[1], "w", encoding="utf-8") as file:
            file.write(expected)
        return 0
    with open(arguments[1], encoding="utf-8") as file:
        found = file.read()
    if found == expected:
        return 0
    sys.stdout.writelines(
        line + "\n" for line in difflib.unified_diff(found.split("\n"), expected.split("\n"), lineterm="")
    )
    return "%s differs from what the program prints; --write makes it anew" % arguments[1]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
