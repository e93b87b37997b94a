# SPDX-License-Identifier: GPL-3.0-or-later
"""What figures are called and what they show, known without drawing; and what is said of their files."""

import ast
import difflib
import os

from hybrid_run import UserError

# Where a figure's file is not called as its module.
NAMES = {"monitor_histories": "monitors", "section_view": "section", "energy_balance": "energy", "step_costs": "steps"}


def name_of(module):
    return NAMES.get(module, module)


def modules(text, known):
    """Modules of "section,slip", in the order of drawing. @raises UserError for a figure that is not known."""
    by_name = {name_of(module): module for module in known}
    asked = [name.strip() for name in text.split(",") if name.strip()]
    for name in asked:
        if name not in by_name and name not in known:
            near = difflib.get_close_matches(name, list(by_name) + list(known), 1)
            raise UserError("unknown figure '%s' in --figures%s; there are: %s" % (
                name, " (did you mean '%s'?)" % near[0] if near else "", ", ".join(by_name)))
    if not asked:
        raise UserError("--figures names no figure; there are: %s" % ", ".join(by_name))
    return [module for module in known if module in asked or name_of(module) in asked]


def descriptions(known):
    """{module: first sentence of its docstring}; the modules are not imported, as that takes a second."""
    found = {}
    for module in known:
        with open(os.path.join(os.path.dirname(__file__), module + ".py"), encoding="utf-8") as source:
            found[module] = (ast.get_docstring(ast.parse(source.read())) or "").split("\n")[0].rstrip(".")
    return found


def as_text(known):
    about = descriptions(known)
    return "\n".join("  %-13s  %s" % (name_of(module), about[module]) for module in known)


def say(what, paths):
    """Files that were written, by their directory."""
    directories = {}
    for path in paths:
        directories.setdefault(os.path.dirname(path), []).append(os.path.basename(path))
    for directory, names in directories.items():
        print("%s: %s: %s" % (what, directory, ", ".join(names)))
