# SPDX-License-Identifier: GPL-3.0-or-later
"""A study as a part of a page, such as doc/accuracy-vs-time.md: what each error costs, models and effects, the verdict, the figure.

The page has a pair of marks for each study, <!-- study NAME --> and <!-- end of study NAME -->, NAME that of its directory without "-study".
"""

import os
import shutil

from hybrid_tools import marked_page
from hybrid_tools.benchmark import machine
from hybrid_tools.study import report, tables
from hybrid_tools.table import Column, Table


def marks(study):
    """Begin and end of the study's part."""
    name = name_of(study)
    return "<!-- study %s -->" % name, "<!-- end of study %s -->" % name


def name_of(study):
    return os.path.basename(study.directory).removesuffix("-study")


def check(path, study):
    """@raises UserError if the page has no place for the study."""
    marked_page.around(path, *marks(study))


def put(path, analysis):
    """Write the study's part of the page, and its figure into figures/ beside the page."""
    marked_page.put(path, *marks(analysis.study), text(analysis, figure_beside(path, analysis.study)))


def figure_beside(path, study):
    """Copy the figure of errors over time. @return its path as the page sees it; "" if there is none."""
    drawn = os.path.join(study.directory, "figures", "error_over_time.png")
    if not os.path.isfile(drawn):
        return ""
    name = os.path.join("figures", "study_%s.png" % name_of(study))
    folder = os.path.dirname(os.path.abspath(path))
    os.makedirs(os.path.join(folder, "figures"), exist_ok=True)
    shutil.copyfile(drawn, os.path.join(folder, name))
    return name


def text(analysis, figure):
    """The part, in Markdown."""
    study = analysis.study
    parts = [facts(analysis)]
    if figure:
        parts.append("![%s: error against processor time](%s)" % (study.base.get("Title") or name_of(study), figure))
    parts += [table.markdown() for table in (settings(analysis), tables.options(analysis), tables.samples(analysis)) if table.rows]
    said = report.chaos(analysis) + [report.sentence(analysis)] * bool(report.sentence(analysis))
    return "\n\n".join(parts + ["\n".join("- " + line for line in said)] * bool(said)) + "\n"


def facts(analysis):
    """Machine, versions of the program, how times were taken."""
    facts_here = machine.machine()
    programs = sorted({result.run.manifest.get("program", {}).get("commit", "?") for result in analysis.done})
    times = sorted({tables.times_of(result.run.manifest) for result in analysis.done})
    return "%s, %d cores; commit %s; %d runs, times taken %s." % (
        facts_here["processor"], facts_here["cores"], ", ".join(programs), len(analysis.done), "; ".join(times) or "in no run")


def settings(analysis):
    """Settings that no other of the same options and models beats in both time and error."""
    study, groups = analysis.study, {}
    own = study.axes_of("options", "models")
    for entry in tables.judged(analysis):
        labels = tables.level_columns(study, entry.setting.levels)
        groups.setdefault(", ".join(labels[k] for k in own), []).append(entry)
    table = Table([Column(", ".join(study.axes[k].short for k in own))] * bool(own) + [
        Column("setting"), Column("processor time", "s", tables.seconds), Column("largest error", "", tables.part), Column("of"), Column("against")])
    for name, found in groups.items():
        for entry in tables.front_of(found):
            table.add(*[name] * bool(own), words_for(study, entry), entry.cost, entry.error, tables.in_words(entry.worst), report.KINDS[entry.kind])
    return table


def words_for(study, entry):
    """What is refined: h 4, Time step 0.002."""
    labels = tables.level_columns(study, entry.setting.levels)
    return ", ".join("%s %s" % (study.axes[k].short, labels[k]) for k in study.axes_of("ladder")) or "scene"
