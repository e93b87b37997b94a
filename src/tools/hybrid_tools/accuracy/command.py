# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid accuracy RUN: how far a run is off, by coarser ones, and what halving its step or its mesh would cost."""

import fnmatch
import os

from hybrid_run import UserError
from hybrid_tools.accuracy import coarser, estimate
from hybrid_tools.arguments import Arguments
from hybrid_tools.study import quantities
from hybrid_tools.study.run_directory import read_json
from hybrid_tools.table import Cell, Column, Table

EXAMPLES = """  hybrid accuracy output/my_run                  # mesh twice and four times as coarse, step twice as long
  hybrid accuracy output/my_run --mesh           # the mesh alone: about a sixth of the run's time
  hybrid accuracy output/my_run --quantities "crest/*,slip/*"
"""


def read_words(words):
    arguments = Arguments("accuracy", "How far a run that has finished is off. The same scene is computed with a mesh twice and four times as coarse, and\n"
                          "with steps twice as long; what that changes says the errors of the run itself, also of slip and of blocks.", EXAMPLES)
    arguments.add_argument("run", metavar="RUN", help="directory of a run")
    arguments.add_argument("--mesh", action="store_true", help="the error of the mesh alone")
    arguments.add_argument("--step", action="store_true", help="the error of the time step alone")
    arguments.add_argument("--quantities", metavar="PATTERNS", default="", help='what is shown and judged, e.g. "crest/*,slip/*" (default: all)')
    return arguments.read(words)


def plan(parameters, found):
    """{kind: [coarser, ...]}, the nearest first; of a mesh that cannot be made coarser nothing."""
    both = found.mesh == found.step
    kinds = {}
    if found.mesh or both:
        meshes = [coarser.coarser_mesh(parameters, factor) for factor in (2, 4)]
        if None not in meshes:
            kinds["mesh"] = meshes
        elif found.mesh:
            raise UserError("the mesh of the run, '%s', has no number Resolution/... that would make it coarser" % parameters["Mesh/File"])
        else:
            print("the mesh '%s' has no number Resolution/... that would make it coarser: its error stays unknown" % parameters["Mesh/File"])
    if found.step or both:
        kinds["step"] = [coarser.longer_steps(parameters, 2)]
    return kinds


def compute(directory, kinds):
    """{kind: [directory, ...]} of runs that are done; one that fails ends its kind, with a word."""
    done = {}
    for kind, runs in kinds.items():
        done[kind] = []
        for run in runs:
            try:
                path = coarser.compute(directory, run)
            except UserError as error:
                print("%-7s failed: %s" % (run.name, error), flush=True)
                break
            done[kind].append(path)
            print("%-7s %8.4g s" % (run.name, time_of(path)), flush=True)
    return {kind: paths for kind, paths in done.items() if paths}


def time_of(directory):
    """Processor time [s]."""
    return read_json(os.path.join(directory, "summary.json")).get("processor_time_s", 0.0)


def shown(error):
    """An error as people see it; ~ where the runs scatter."""
    if error is None:
        return Cell(None, "-")
    return Cell(error.value, ("" if error.converges else "~") + percent(error.value))


def percent(part):
    """With two digits: 0.031 %, 27 %, 134 %."""
    return ("%.0f %%" if part >= 0.995 else "%.2g %%") % (100 * part)


def table_of(run, errors):
    kinds = list(errors)
    table = Table([Column("quantity"), Column("size", "", "%.4g"), Column("unit")] + [Column("error of the " + kind) for kind in kinds]
                  + [Column("order in the mesh", "", "%.2g")] * ("mesh" in kinds))
    for name in estimate.judged(run):
        found = [errors[kind].get(name) for kind in kinds]
        order = [None if errors["mesh"].get(name) is None else errors["mesh"][name].order] if "mesh" in kinds else []
        table.add(name, quantities.root_mean_square(run[name]), quantities.unit(name), *map(shown, found), *order)
    return table


def sentences(errors, times, own_time):
    """What is largest, and what half of it costs."""
    found = []
    for kind, of_kind in errors.items():
        name, error = estimate.largest(of_kind)
        if error is None:
            continue
        scattered = sum(not e.converges for e in of_kind.values())
        found.append("Error of the %s: largest %s (%s)%s" % (
            kind, percent(error.value), name,
            "; %d of %d quantities do not converge (~): what is told is how far they scatter" % (scattered, len(of_kind)) if scattered else ""))
        if times[kind] > 0:
            found.append("Half the %s takes about %.3g s, as this run took %.3g s and the coarser one %.3g s" % (
                kind if kind == "step" else "size of the mesh", own_time * own_time / times[kind], own_time, times[kind]))
    return found


def main(words):
    found = read_words(words)
    parameters = coarser.parameters(found.run)
    done = compute(found.run, plan(parameters, found))
    if not done:
        raise UserError("no coarser run came to its end")
    directories = [path for paths in done.values() for path in paths]
    end = min(quantities.end_of(path) for path in [found.run] + directories)
    patterns = [pattern.strip() for pattern in found.quantities.split(",") if pattern.strip()]
    run, errors = values(found.run, end, patterns), {}
    for kind, paths in done.items():
        errors[kind] = estimate.errors(run, [values(path, end, patterns) for path in paths])
    table = table_of(run, errors)
    said = sentences(errors, {kind: time_of(paths[0]) for kind, paths in done.items()}, time_of(found.run))
    directory = os.path.join(found.run, "accuracy")
    table.write(directory, "accuracy", {"run": os.path.abspath(found.run), "sentences": said}, "# How far this run is off\n\n" + "\n".join(said) + "\n")
    print("\n" + table.text() + "\n\n" + "\n".join(said))
    print("files    %s: accuracy.json, accuracy.csv, accuracy.md; the coarser runs" % directory)
    return 0


def values(directory, end, patterns):
    """Of a run, those that the patterns name. @raises UserError if a pattern names none."""
    found = quantities.read(directory, end)
    for pattern in patterns:
        if not fnmatch.filter(found, pattern):
            raise UserError("--quantities: no quantity is like '%s'; there are %s" % (pattern, ", ".join(found)))
    return {name: value for name, value in found.items() if not patterns or any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)}
