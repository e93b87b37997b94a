#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""No function of Eigen is exported by the program: gmsh's library would call it for its own.

usage: check_hidden_symbols.py PROGRAM
"""
import subprocess
import sys


def exported_by(program):
    """Names, demangled, that shared libraries can take from a program."""
    command = ["nm", "--dynamic", "--demangle", "--defined-only", program]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()
    return [line.split(maxsplit=2)[2] for line in lines]


def main():
    names = exported_by(sys.argv[1])
    of_eigen = [name for name in names if "Eigen::" in name]
    print(f"{len(names)} exported names, {len(of_eigen)} of Eigen")
    for name in of_eigen[:20]:
        print(f"  {name}")
    sys.exit(1 if of_eigen or not names else 0)


if __name__ == "__main__":
    main()
