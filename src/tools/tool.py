# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 tool.py NAME words...: what `hybrid NAME words...` calls, with the program itself in the variable HYBRID_PROGRAM."""

import importlib
import importlib.util
import os
import sys

PACKAGES = {"h5py": "python3-h5py", "jinja2": "python3-jinja2", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy",
            "scipy": "python3-scipy", "shapely": "python3-shapely", "tabulate": "python3-tabulate"}  # of Debian


def check_modules():
    missing = [name for name in PACKAGES if importlib.util.find_spec(name) is None]
    if missing:
        sys.exit("error: this needs the Python %s %s, which %s does not have; on Debian: apt-get install %s" % (
            "module" if len(missing) == 1 else "modules", ", ".join(missing), sys.executable, " ".join(PACKAGES[m] for m in missing)))


def main(name, words):
    """Exit code of the tool; 2 for what the user gave wrongly, 130 for Ctrl-C."""
    check_modules()
    from hybrid_run import MissingData, UserError

    try:
        return importlib.import_module("hybrid_tools.%s.command" % name).main(words)
    except (UserError, MissingData) as error:
        print("error: %s" % error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:  # its reader has gone: nothing is left to say
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
