# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid accuracy RUN: how far a run is off, by coarser ones, and what halving its step or its mesh would cost."""

import fnmatch
import math
import os
import signal

from hybrid_run import UserError
from hybrid_tools.accuracy import coarser, estimate
from hybrid_tools.arguments import Arguments
from hybrid_tools.study import quantities
from hybrid_tools.study.run_directory import read_json
from hybrid_tools.table import Cell, Column, Table

LEAST_TIME = 0.5  # of steps, that tells what finer ones take [s]
MOST_GROWTH = {"step": 2.0, "mesh": 16.0}  # of the time, with half the step (twice the steps) or half the size (four times n, and n^2 at most)
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


def why_no_coarser_mesh(path):
    if not path:
        return "the blocks are not from a mesh"
    return "the mesh '%s' %s" % (path, "has no number Resolution/..." if path.endswith(".geo") else "is no .geo file")


def why_no_longer_step(parameters, summary):
    """A sentence; nothing where twice the step tells its error."""
    if parameters["Continuum/Time integrator"] == "explicit":
        return "explicit steps are divided into stable parts, which twice the step leaves as they are"
    error = summary.get("probable_error", {})
    if not summary.get("blocks") and error.get("estimated", False) and error.get("measured_from_time_step_s") is None:
        return "waves alone say the error of their step themselves: see the line 'Error' at the end of the run"
    return ""


def plan(parameters, summary, found):
    """{kind: [coarser, ...]}, the nearest first; of a mesh that cannot be made coarser nothing."""
    both = found.mesh == found.step
    kinds = {}
    if found.mesh or both:
        meshes = [coarser.coarser_mesh(parameters, factor) for factor in (2, 4)]
        reason = why_no_coarser_mesh(parameters["Mesh/File"])
        if None not in meshes:
            kinds["mesh"] = meshes
        elif found.mesh:
            raise UserError(reason + ": it cannot be made coarser")
        else:
            print(reason + ": it cannot be made coarser, and its error stays unknown")
    if found.step or both:
        reason = why_no_longer_step(parameters, summary)
        if not reason:
            kinds["step"] = [coarser.longer_steps(parameters, 2)]
        elif found.step:
            raise UserError(reason)
        else:
            print(reason)
    return kinds


def compute(directory, kinds):
    """{kind: [directory, ...]} of runs that are done; one that fails ends its kind, with a word."""
    done = {}
    for kind, runs in kinds.items():
        done[kind], finer = [], directory
        for run in runs:
            try:
                path = coarser.compute(directory, run)
            except UserError as error:
                print("%-7s failed: %s" % (run.name, error), flush=True)
                break
            print("%-7s %8.4g s   %s" % (run.name, time_of(path), ", ".join("%d %s" % (n, name) for name, n in coarser.counts(path).items())),
                  flush=True)
            if kind == "mesh":
                for name, numbers in coarser.unchanged(path, finer).items():
                    print("%-7s has %d %s, the finer mesh %d, hardly fewer: their own error is not in what follows" % ((run.name, numbers[0], name, numbers[1])),
                          flush=True)
                if not coarser.is_coarser(path, finer):
                    print("%-7s is left out" % run.name, flush=True)
                    break
            done[kind].append(path)
            finer = path
    return {kind: paths for kind, paths in done.items() if paths}


def time_of(directory):
    """Processor time [s]."""
    return read_json(os.path.join(directory, "summary.json")).get("processor_time_s", 0.0)


def time_of_steps(directory):
    """Wall time of a run's steps, without its start [s]."""
    timings = read_json(os.path.join(directory, "summary.json")).get("timings_s", {})
    return timings.get("blocks", 0.0) + timings.get("continuum", 0.0)


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
        by_mesh = errors.get("mesh", {}).get(name)
        order = None if by_mesh is None or not math.isfinite(by_mesh.order) else by_mesh.order
        table.add(name, quantities.root_mean_square(run[name]), quantities.unit(name), *map(shown, found), *[order] * ("mesh" in kinds))
    return table


def sentences(errors, run, coarser_runs):
    """What is largest, and what half of it costs. coarser_runs: {kind: directory of the nearest}."""
    found = []
    for kind, of_kind in errors.items():
        name, error = estimate.largest(of_kind)
        if error is None:
            continue
        scattered = sum(not e.converges for e in of_kind.values())
        found.append("Error of the %s: largest %s (%s)%s" % (
            kind, percent(error.value), name,
            "; %d of %d quantities do not converge (~): what is told is how far they scatter" % (scattered, len(of_kind)) if scattered else ""))
        own, other = time_of_steps(run), time_of_steps(coarser_runs[kind])
        if own > LEAST_TIME and other > 0:
            found.append("Half the %s takes about %.3g s, as the steps of this run took %.3g s and those of the coarser one %.3g s" % (
                kind if kind == "step" else "size of the mesh", own * min(max(1.0, own / other), MOST_GROWTH[kind]), own, other))
    return found


def main(words):
    found = read_words(words)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    parameters = coarser.parameters(found.run)
    patterns = [pattern.strip() for pattern in found.quantities.split(",") if pattern.strip()]
    values(found.run, quantities.end_of(found.run), patterns)  # what cannot be asked for is told before anything is computed
    for name in coarser.changed_files(found.run, parameters):
        print("warning: '%s' was changed after the run began; the coarser runs have what is in it now" % name)
    done = compute(found.run, plan(parameters, read_json(os.path.join(found.run, "summary.json")), found))
    if not done:
        raise UserError("there is no coarser run to compare with")
    directories = [path for paths in done.values() for path in paths]
    end = min(quantities.end_of(path) for path in [found.run] + directories)
    run, errors = values(found.run, end, patterns), {}
    for kind, paths in done.items():
        errors[kind] = estimate.errors(run, [values(path, end, patterns) for path in paths])
    table = table_of(run, errors)
    said = sentences(errors, found.run, {kind: paths[0] for kind, paths in done.items()})
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
