# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a study: runs, errors of each varied parameter, what does not converge, samples, what each option and effect costs."""

import itertools
import os
from dataclasses import dataclass

import numpy as np

from hybrid_run import convergence
from hybrid_tools.study import quantities
from hybrid_tools.study.axes import label_text
from hybrid_tools.study.quantities import Number
from hybrid_tools.table import Cell, Column, Table

NO_ORDER = {"does not converge": "does not converge", "irregular": "irregular", "equal": "equal", "two levels": "-", "one level": "-"}


def part(value):
    """An error as people see it."""
    if value is None or np.isnan(value):
        return "-"
    return "more" if np.isinf(value) else "0 %" if value == 0 else "%.2g %%" % (100 * value) if value < 1 else "%.0f %%" % (100 * value)


def in_words(name):
    """crest: displacement, L2."""
    monitor, quantity = name.split("/")
    return "%s: %s%s" % (monitor, quantity, ", L2" if quantity in quantities.UNITS else "")


def seconds(value):
    return "-" if value is None else "%.3g" % value


def level_columns(study, levels):
    return [label_text(axis.labels[level]) for axis, level in zip(study.axes, levels)]


def runs(analysis):
    """Every run: what it varies, how it ended, what it took, its largest error; what is on the Pareto front."""
    study = analysis.study
    columns = [Column(axis.short) for axis in study.axes]
    has_seeds = any(seed for _, _, seed in analysis.results)
    columns += [Column("effect")] * bool(study.effects) + [Column("seed")] * has_seeds
    columns += [Column("state"), Column("processor time", "s", seconds), Column("times"), Column("error", "", part), Column("largest in"),
                Column("Pareto front"), Column("reason"), Column("directory")]
    table, front = Table(columns), {id(result) for entry in pareto(analysis) for result in entry.results}
    for result in analysis.results.values():
        setting, manifest = result.setting, result.run.manifest
        error, worst = analysis.error(result) if result.values and not setting.effect and not setting.seed else (None, "")
        own = [setting.effect or "-"] * bool(study.effects) + [str(setting.seed)] * has_seeds
        table.add(*level_columns(study, setting.levels), *own, result.run.state, result.cost, times_of(manifest), error, worst,
                  "yes" if id(result) in front else "", manifest.get("reason", ""), os.path.relpath(result.run.path, study.directory))
    return table


def times_of(manifest):
    """How the processor time was taken."""
    if "times" in manifest:
        return "%s, least of %d" % (manifest["taken"], len(manifest["times"]))
    return manifest.get("taken", "") + (", resumed" if manifest.get("resumed") else "")


@dataclass
class Judged:
    """A setting whose error and time are known. With samples: the largest error and the mean time over them.

    results: its runs, one for each sample. worst: the quantity with the largest error, kind: what that refers to.
    """

    results: list
    cost: float
    error: float
    worst: str
    kind: str

    @property
    def setting(self):
        return self.results[0].setting

    def name(self, study):
        """Words for it, without the sample."""
        labels = level_columns(study, self.setting.levels)
        words = [axis.short + " " + label for axis, label in zip(study.axes, labels) if axis.kind != "samples"]
        return (", ".join(words) or "scene") + (" (%d samples)" % len(self.results) if len(self.results) > 1 else "")


def judged(analysis):
    """Settings of the grid with a known error and time, in the order of the plan."""
    samples, groups = analysis.study.axes_of("samples"), {}
    for result in analysis.done:
        if not result.setting.effect and not result.setting.seed and result.cost is not None and analysis.error(result)[0] is not None:
            groups.setdefault(tuple(level for k, level in enumerate(result.setting.levels) if k not in samples), []).append(result)
    found = []
    for results in groups.values():
        worst = max(results, key=lambda result: analysis.error(result)[0])
        error, quantity = analysis.error(worst)
        kind = analysis.errors(worst)[quantity][1]
        found.append(Judged(results, float(np.mean([result.cost for result in results])), error, quantity, kind))
    return found


def problems(analysis):
    """{words on its models: judged settings}: errors of one problem say nothing of another. Without models one problem, ""."""
    study, found = analysis.study, {}
    for entry in judged(analysis):
        labels = level_columns(study, entry.setting.levels)
        name = ", ".join("%s %s" % (study.axes[k].short, labels[k]) for k in study.axes_of("models"))
        found.setdefault(name, []).append(entry)
    return found


def front_of(found):
    """Of judged settings those that no other beats in both time and error, by rising time."""
    return [found[k] for k in convergence.pareto([entry.cost for entry in found], [entry.error for entry in found])]


def pareto(analysis):
    """The Pareto front of each problem, one after another."""
    return [entry for found in problems(analysis).values() for entry in front_of(found)]


def ladders(analysis):
    """Ladders of each refined parameter, the others at their finest; for every option, and the first of the samples."""
    study, found = analysis.study, []
    options = study.axes_of("options", "models")
    for index in study.axes_of("ladder"):
        for levels in itertools.product(*(range(len(study.axes[k].labels)) for k in options)):
            fixed = list(study.finest)
            for k, level in zip(options, levels):
                fixed[k] = level
            finest = analysis.finest(tuple(fixed))
            ladder = analysis.ladder(index, finest.setting.levels) if finest else None
            if ladder:
                found.append(ladder)
    return found


def ladder_title(analysis, ladder):
    """Time step (h 4, Scheme trapezoidal)"""
    labels = level_columns(analysis.study, ladder.fixed)
    others = ["%s %s" % (axis.short, labels[k]) for k, axis in enumerate(analysis.study.axes) if k != ladder.index]
    return ladder.axis.short + (" (%s)" % ", ".join(others) if others else "")


def errors(ladder):
    """Errors of the levels of a ladder, observed orders, the reference; the last row is the time."""
    labels = [ladder.axis.labels[result.setting.levels[ladder.index]] for result in ladder.results]
    columns = [Column("monitor"), Column("quantity")]
    columns += [Column("%s %s" % (ladder.axis.short, label), "", part, head=label) for label in labels]
    table = Table(columns + [Column("order", "", order_words), Column("reference")])
    for row in ladder.rows.values():
        monitor, quantity = row.quantity.split("/")
        is_itself = row.kind == "finest run"
        shown = [None if is_itself and k == len(row.errors) - 1 else error for k, error in enumerate(row.errors)]
        order = row.order if np.isfinite(row.order) else None
        table.add(monitor, quantity + (", L2" if quantity in quantities.UNITS else ""), *shown,
                  Cell(order, NO_ORDER.get(row.convergence.verdict, "-")) if order is None else order, row.kind)
    failed = [result.values["joints/failed"].value for result in ladder.results]
    if any(failed):
        table.add("joints", "failed (number)", *(Cell(int(number), "%d" % number) for number in failed), None, "")
    table.add("processor time", "s", *(Cell(result.cost, seconds(result.cost)) for result in ladder.results), None, "")
    return table


def order_words(value):
    return "-" if value is None else "%.2f" % value


def scattered(analysis):
    """[(ladder, row)] of what does not converge."""
    return [(ladder, row) for ladder in ladders(analysis) for row in ladder.rows.values() if row.convergence.verdict == "does not converge"]


def needs_seeds(analysis):
    """Whether copies of the finest run would tell what its levels cannot."""
    rows = [row for ladder in ladders(analysis) for row in ladder.rows.values()]
    return any(row.convergence.is_doubtful or row.convergence.verdict == "does not converge" for row in rows)


def scatter(analysis):
    """What does not converge, and its values over the copies of the finest run (seeds)."""
    table = Table([Column("monitor"), Column("quantity"), Column("along"), Column("coarse runs differ by", "", part, head="coarse differ"),
                   Column("fine runs differ by", "", part, head="fine differ"), Column("seeds differ by", "", part, head="seeds differ"),
                   Column("seeds", "", "%d"), Column("mean"), Column("standard deviation", head="std"), Column("least"), Column("largest"),
                   Column("unit")])
    for ladder, row in scattered(analysis):
        copies = [copy.values[row.quantity] for copy in analysis.copies(ladder.results[-1].setting.levels) if row.quantity in copy.values]
        numbers = [copy.value for copy in copies if isinstance(copy, Number)] if len(copies) > 1 else []
        monitor, quantity = row.quantity.split("/")
        table.add(monitor, quantity, ladder_title(analysis, ladder), row.convergence.coarse, row.convergence.fine, row.scatter, len(copies),
                  *(statistics(numbers) if numbers else [None] * 4), quantities.unit(row.quantity))
    return table


def statistics(numbers):
    """Mean, standard deviation (of a sample), least, largest."""
    return [float(np.mean(numbers)), float(np.std(numbers, ddof=1)) if len(numbers) > 1 else None, float(min(numbers)), float(max(numbers))]


def samples(analysis):
    """Values over seeds of materials or motions, and over records, with all else at its finest."""
    study = analysis.study
    table = Table([Column("monitor"), Column("quantity"), Column("over"), Column("runs", "", "%d"), Column("mean"),
                   Column("standard deviation", head="std"), Column("least"), Column("largest"), Column("unit")])
    for index in study.axes_of("samples"):
        levels = [study.finest[:index] + (k,) + study.finest[index + 1 :] for k in range(len(study.axes[index].labels))]
        results = [result for result in map(analysis.of, levels) if result]
        for name in analysis.names if len(results) > 1 else ():
            values = [result.values[name] for result in results if name in result.values]
            if name not in analysis.small and isinstance(values[0], Number):
                numbers = statistics([value.value for value in values])
                table.add(*name.split("/"), study.axes[index].short, len(values), *numbers, quantities.unit(name))
    return table


def options(analysis):
    """Each option and each effect against the finest run: its time, and what it changes most."""
    study, reference = analysis.study, analysis.finest(analysis.study.finest)
    table = Table([Column("option or effect"), Column("processor time", "s", seconds), Column("times as much", "", "%.2f"),
                   Column("changes at most", "", part), Column("in")])
    if reference is None:
        return table
    others = [("%s = %s" % (study.axes[index].short, label), study.finest[:index] + (k,) + study.finest[index + 1 :], "")
              for index in study.axes_of("options", "models") for k, label in enumerate(study.axes[index].labels) if k != study.finest[index]]
    others += [(name, study.finest, name) for name in study.effects]
    if others:
        table.add("finest run", reference.cost, 1.0, None, "")
    for title, levels, effect in others:
        result = analysis.of(levels, effect)
        if result:
            change, worst = analysis.change(result, reference)
            table.add(title, result.cost, result.cost / reference.cost if result.cost and reference.cost else None, change, worst)
        else:
            table.add(title, None, None, None, "not done")
    return table


def values(analysis):
    """Every number and every error of every run, one line each."""
    study = analysis.study
    table = Table([Column("run"), Column("quantity"), Column("value"), Column("unit"), Column("error", "", part), Column("reference")])
    for result in analysis.done:
        known = analysis.errors(result) if not result.setting.effect and not result.setting.seed else {}
        for name, value in result.values.items():
            error, kind = known.get(name, (None, ""))
            number = value.value if isinstance(value, Number) else None
            table.add(study.describe(result.setting), name, number, quantities.unit(name), error, kind)
    return table
