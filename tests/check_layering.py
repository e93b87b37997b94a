#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rejects includes that break the layering of the modules, and files that are too long.

Usage: check_layering.py [ROOT]
"""
import pathlib
import re
import sys

# module -> modules whose headers it may include, besides its own
ALLOWED = {
    "scene": set(),
    "restart": {"scene"},
    "continuum": {"scene", "restart"},
    "dda": {"scene", "restart"},
    "coupling": {"scene", "restart", "continuum", "dda"},
    "output": {"scene", "restart", "continuum", "dda", "coupling"},
    "study": {"scene", "output"},
    "simulation": {"scene", "restart", "continuum", "dda", "coupling", "output", "study"},
}
# module -> its folders from the bottom to the top; "" is the module's own. A folder may include those below it.
FOLDERS = {
    "scene": ("", "boundary", "parameters", "mesh", "bedrock", "motion", "checks"),
    "dda": ("geometry", "block", "joint", "contact", "linear", "model", "springs", "failure", "step", "statics"),
}
MAXIMUM_LINES = {".h": 300, ".cc": 500}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
# Libraries that stay out of the places below: deal.II and Trilinos, gmsh, MPI.
HEAVY = re.compile(r"^(deal\.II/|gmsh|mpi\.h|mpi/|Epetra|Trilinos|hdf5|H5)")
# Folders (relative to the root) whose files include none of them.
LIGHT_FOLDERS = ("include/hybrid/dda/", "include/hybrid/scene/", "src/dda/", "tests/unit/dda/")


def module_of(path):
    """The module that a file belongs to, or None for the program's own files (which may know all)."""
    parts = path.split("/")
    folder = {"include": 2, "src": 1, "tests": 2}[parts[0]]
    return parts[folder] if len(parts) > folder + 1 else None


def folder_of(path):
    """The folder of a file or header in its module, "" for the module's own."""
    parts = path.split("/")
    if parts[0] == "hybrid":
        return parts[2] if len(parts) > 3 else ""
    first = {"include": 3, "src": 2, "tests": 3}[parts[0]]
    return parts[first] if len(parts) > first + 1 else ""


def check_folder(path, module, header):
    """A complaint if the header lies in a folder above that of the file."""
    folders = FOLDERS.get(module)
    if folders is None or path.startswith("tests/"):
        return []
    mine, other = folder_of(path), folder_of(header)
    for folder in (mine, other):
        if folder not in folders:
            return [f"{path}: folder '{folder}' of '{module}' is unknown; add it to FOLDERS in tests/check_layering.py"]
    if folders.index(other) > folders.index(mine):
        return [f"{path}: '{module}/{mine}' must not include <{header}>"]
    return []


def check_file(path, text):
    """Complaints about one file; path is relative to the root, with '/'."""
    complaints = []
    lines = text.splitlines()
    limit = MAXIMUM_LINES[pathlib.PurePosixPath(path).suffix]
    if len(lines) > limit:
        complaints.append(f"{path}: {len(lines)} lines, at most {limit} are allowed")
    module = module_of(path)
    if module is not None and module not in ALLOWED and not path.startswith("tests/"):
        complaints.append(f"{path}: module '{module}' is unknown; add it to ALLOWED in tests/check_layering.py")
    for number, line in enumerate(lines, 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        header = found.group(1)
        if path.startswith(LIGHT_FOLDERS) and HEAVY.match(header):
            complaints.append(f"{path}:{number}: <{header}> is not allowed in {path.rsplit('/', 1)[0]}")
        parts = header.split("/")
        if parts[0] != "hybrid" or module not in ALLOWED:
            continue
        other = parts[1] if len(parts) > 2 else None
        if other is None and module == "simulation":
            continue  # tests of the program's own files
        if other == module:
            complaints += check_folder(path, module, header)
        elif other not in ALLOWED[module]:
            complaints.append(f"{path}:{number}: module '{module}' must not include <{header}>")
    return complaints


def self_test():
    """The checks refuse what they are for."""
    refused = [
        ("src/dda/a.cc", "#include <hybrid/continuum/continuum.h>"),
        ("src/dda/a.cc", '#  include "deal.II/base/point.h"'),
        ("include/hybrid/scene/a.h", "#include <gmsh.h>"),
        ("include/hybrid/scene/a.h", "#include <hybrid/dda/block/block.h>"),
        ("include/hybrid/dda/a.h", "#include <mpi.h>"),
        ("src/continuum/a.cc", "#include <hybrid/simulation.h>"),
        ("include/hybrid/dda/a.h", "\n" * 301),
        ("src/dda/a.cc", "\n" * 501),
        ("src/surprise/a.cc", ""),
        ("src/dda/contact/a.cc", "#include <hybrid/dda/step/block_solver.h>"),
        ("include/hybrid/scene/a.h", "#include <hybrid/scene/parameters/scene_parameters.h>"),
        ("src/dda/surprise/a.cc", "#include <hybrid/dda/geometry/polygon.h>"),
    ]
    accepted = [
        ("src/scene/a.cc", "#include <deal.II/base/point.h>\n#include <hybrid/scene/types.h>"),
        ("src/coupling/a.cc", "#include <hybrid/dda/block/block.h>\n// #include <hybrid/output/log.h>"),
        ("src/main.cc", "#include <hybrid/output/log.h>"),
    ]
    for path, text in refused:
        assert check_file(path, text), f"not refused: {path}: {text.strip()}"
    for path, text in accepted:
        assert not check_file(path, text), check_file(path, text)


def main():
    self_test()
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    files = [
        file
        for folder in ("include", "src", "tests")
        for file in sorted((root / folder).rglob("*"))
        if file.suffix in MAXIMUM_LINES
    ]
    complaints = [
        complaint
        for file in files
        for complaint in check_file(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))
    ]
    if not files:
        complaints.append(f"{root}: no source file found to check")
    for complaint in complaints:
        print(complaint)
    print(f"{len(files)} files checked, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
