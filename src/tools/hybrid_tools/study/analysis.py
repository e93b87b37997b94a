# SPDX-License-Identifier: GPL-3.0-or-later
"""Errors and orders of the runs of a study, what they refer to, and what does not converge."""

import fnmatch
from dataclasses import dataclass

import numpy as np

from hybrid_run import MissingData, UserError, convergence
from hybrid_tools.study import quantities
from hybrid_tools.study.quantities import Blend, Number, norm

SMALL = 1e-3  # of the largest of its kind: a monitor that hardly moves is not judged


@dataclass
class Result:
    """A run of the study. values: None unless it is done."""

    setting: object
    run: object
    values: dict = None

    @property
    def cost(self):
        """Processor time [s], or None."""
        return self.run.manifest.get("processor_time_s")


@dataclass
class Row:
    """One quantity along a ladder. kind: of the reference, "closed form", "Richardson" or "finest run"; values, errors: of each level [-].

    scatter: largest difference among the copies of the finest run, over the value [-]; None without copies.
    """

    quantity: str
    values: list
    errors: list
    order: float
    kind: str
    reference: object
    convergence: object
    scatter: float = None


@dataclass
class Ladder:
    """Levels of one axis, coarse to fine, with the others held. fixed: levels of all axes in its finest run."""

    axis: object
    index: int
    fixed: tuple
    results: list
    rows: dict


class Analysis:
    """results: by (levels, effect, seed). closed: {quantity: value}. end: all histories are cut there [s]. small: quantities left out."""

    def __init__(self, study, runs):
        """runs: of (setting, run directory)."""
        self.study = study
        self.results = {(s.levels, s.effect, s.seed): Result(s, run) for s, run in runs}
        done = [result for result in self.results.values() if result.run.state == "done"]
        ends = {}
        for result in list(done):
            try:
                ends[id(result)] = quantities.end_of(result.run.path)
            except (MissingData, UserError) as error:
                result.run.manifest.update(state="failed", reason=str(error))
        self.done = [result for result in done if id(result) in ends]
        self.end = min(ends.values(), default=0.0)
        for result in self.done:
            result.values = quantities.read(result.run.path, self.end)
        self.closed = {}
        for entry in study.closed_forms.items() if self.done else ():
            self.closed.update({name: value for name, value in quantities.closed_form(entry, self.end).items()
                                if name not in self.closed and (name == entry[0] or name not in study.closed_forms)})
        self.names = list(dict.fromkeys(name for result in self.done for name in result.values))
        for name in study.closed_forms:
            if self.done and name not in self.names:
                raise UserError("there is no quantity '%s' that the closed form is for; there are %s" % (name, ", ".join(self.names)))
        self.small = self._small()
        for pattern in study.quantities:
            if self.done and not fnmatch.filter(self.names, pattern):
                raise UserError("--quantities: no quantity is like '%s'; there are %s" % (pattern, ", ".join(self.names)))
        self._ladders, self._best = {}, {}

    def _small(self):
        """What is far below the largest of its unit: nothing is asked of a monitor that hardly moves, or of slip within elastic joints."""
        sizes, largest = {}, {}
        for name in self.names:
            sizes[name] = max(quantities.root_mean_square(result.values[name]) for result in self.done if name in result.values)
            largest[quantities.unit(name)] = max(largest.get(quantities.unit(name), 0.0), sizes[name])
        return [name for name, size in sizes.items() if size <= SMALL * largest[quantities.unit(name)]
                and name not in self.closed and name not in quantities.COUNTS]

    def of(self, levels, effect="", seed=0):
        """A result that is done, or None."""
        result = self.results.get((tuple(levels), effect, seed))
        return result if result is not None and result.values is not None else None

    def copies(self, levels):
        """The run at these levels and its copies that differ in rounding alone."""
        return [r for (key, effect, _), r in sorted(self.results.items(), key=lambda i: i[0][2]) if key == levels and not effect and r.values]

    def judged(self, name):
        """Whether errors are made of a quantity."""
        patterns = self.study.quantities
        if patterns:
            return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns) and name not in quantities.COUNTS
        return name not in self.small and name not in quantities.COUNTS

    def ladder(self, index, fixed):
        """Levels of a ladder with the other axes at these levels; None if fewer than two are done."""
        axis = self.study.axes[index]
        fixed = fixed[:index] + (axis.reference,) + fixed[index + 1 :]
        if (index, fixed) not in self._ladders:
            found = [(k, self.of(fixed[:index] + (k,) + fixed[index + 1 :])) for k in range(len(axis.labels))]
            results = [result for _, result in found if result]
            rows = {}
            if len(results) > 1:
                sizes = [axis.sizes[k] for k, result in found if result] if axis.sizes else None
                copies = self.copies(results[-1].setting.levels)
                for name in self.names:
                    if self.judged(name) and all(name in result.values for result in results):
                        rows[name] = make_row(name, sizes, [r.values[name] for r in results], self.closed.get(name),
                                              [copy.values[name] for copy in copies if name in copy.values])
            self._ladders[index, fixed] = Ladder(axis, index, fixed, results, rows) if rows else None
        return self._ladders[index, fixed]

    def finest(self, fixed):
        """The run at these levels; if it is not done, that of the finest levels of the ladders that is."""
        ladders = self.study.axes_of("ladder")
        others = [result for result in self.done if not result.setting.effect and not result.setting.seed
                  and all(level == wanted for k, (level, wanted) in enumerate(zip(result.setting.levels, fixed)) if k not in ladders)]
        return self.of(fixed) or max(others, key=lambda result: sum(result.setting.levels[k] for k in ladders), default=None)

    def best(self, fixed):
        """{quantity: (value, kind, whether it converges)} at the finest of all ladders; kind as in Row."""
        if fixed in self._best:
            return self._best[fixed]
        finest, found = self.finest(fixed), {}
        levels = finest.setting.levels if finest else fixed
        ladders = [self.ladder(index, levels) for index in self.study.axes_of("ladder") if len(self.study.axes[index].labels) > 1]
        for name in self.names:
            rows = [ladder.rows[name] for ladder in ladders if ladder and name in ladder.rows]
            converges = all(row.convergence.verdict != "does not converge" for row in rows)
            if name in self.closed:
                found[name] = (self.closed[name], "closed form", converges)
            elif finest and name in finest.values:
                clean = [ladder.rows[name] for ladder in ladders if ladder and ladder.results[-1] is finest and name in ladder.rows
                         and ladder.rows[name].convergence.is_clean]
                if clean and len(clean) == len(ladders):
                    parts = [(1.0 - len(clean), finest.values[name])] + [(1.0, row.reference) for row in clean]
                    found[name] = (Blend(parts), "Richardson", converges)
                else:
                    found[name] = (finest.values[name], "finest run", converges)
        self._best[fixed] = found
        return found

    def reference_levels(self, levels):
        """Finest levels and first options; models, seeds and records are problems of their own."""
        own = self.study.axes_of("samples", "models")
        return tuple(level if index in own else axis.reference for index, (axis, level) in enumerate(zip(self.study.axes, levels)))

    def errors(self, result):
        """{quantity: (error [-], kind of the reference)} of a run, without what does not converge; None where it is its own reference."""
        fixed = self.reference_levels(result.setting.levels)
        found = {}
        for name, (reference, kind, converges) in self.best(fixed).items():
            if not self.judged(name) or not converges or name not in result.values:
                continue
            is_itself = kind == "finest run" and result is self.finest(fixed)
            found[name] = (None if is_itself else distance(result.values[name], reference), kind)
        return found

    def error(self, result):
        """(largest error [-], its quantity); (None, "") of the finest run if anything is judged by it."""
        errors = self.errors(result)
        if not errors or any(error is None for error, _ in errors.values()):
            return None, ""
        worst = max(errors, key=lambda name: errors[name][0])
        return errors[worst][0], worst

    def change(self, result, reference):
        """(largest relative change of a judged quantity from another run, which); (None, "") if nothing can be compared."""
        stable = self.best(self.study.finest)
        changes = {name: distance(value, reference.values[name]) for name, value in result.values.items()
                   if name in reference.values and self.judged(name) and stable.get(name, (None, "", True))[2]}
        worst = max(changes, key=changes.get, default="")
        return (changes[worst], worst) if worst else (None, "")


def common_times(values):
    """Of the value with the fewest samples."""
    times = [value.time for value in values if value.time is not None]
    return min(times, key=len) if times else None


def weights_at(times):
    return np.ones(1) if times is None else np.gradient(times)


def distance(value, reference, times=None):
    """Norm of the difference over that of the reference, or over the value's floor [-]; infinite if only the reference is zero."""
    times = common_times([value]) if times is None else times
    weights, wanted = weights_at(times), reference.at(times)
    difference, size = norm(value.at(times) - wanted, weights), max(norm(wanted, weights), value.floor, reference.floor)
    return 0.0 if difference == 0 else difference / size if size > 0 else np.inf


def make_row(name, sizes, values, closed, copies):
    """What one quantity does along a ladder of values, coarse to fine."""
    times = common_times(values)
    weights = weights_at(times)
    samples = [value.at(times) for value in values]
    scale = max(norm(samples[-1], weights), values[-1].floor) or max(norm(sample, weights) for sample in samples) or 1.0
    steps = [a - b for a, b in zip(samples, samples[1:])]
    norms = [norm(step, weights) / scale for step in steps]
    directions = [float((weights[:, None] * a * b).sum()) / max(norm(a, weights) * norm(b, weights), 1e-300)
                  for a, b in zip(steps, steps[1:])]
    spread = convergence.scatter([np.sqrt(weights)[:, None] * copy.at(times) for copy in copies], scale) if len(copies) > 1 else None
    found = convergence.assess(sizes, norms, directions, spread)
    if sizes is None:
        found.is_clean = found.verdict == "equal"
    reference, kind = values[-1], "finest run"
    if found.is_clean:
        factor = convergence.correction(sizes[-2:], found.order) if found.verdict == "converges" else 0.0
        reference, kind = Blend([(1 + factor, values[-1]), (-factor, values[-2])]), "Richardson"
    if closed is not None:
        reference, kind = closed, "closed form"
    errors = [distance(value, reference, times) for value in values]
    return Row(name, values, errors, order_of(found, sizes, errors, kind), kind, reference, found, spread)


def order_of(found, sizes, errors, kind):
    """Observed order; NaN where there is none."""
    if sizes is None or found.verdict == "does not converge":
        return np.nan
    if kind == "closed form":
        return convergence.order_of_errors(sizes[-2:], errors[-2:])
    return found.order
