# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, figures and words of what there is of a study."""

import os

from hybrid_tools import style
from hybrid_tools.study import costs, error_over_time, orders, profile_bands, report, scatter, tables
from hybrid_tools.study.analysis import Analysis
from hybrid_tools.study.run_directory import RunDirectory

FIGURES = (error_over_time, orders, costs, scatter, profile_bands)


def analyse(study, settings):
    return Analysis(study, [(setting, RunDirectory(study.directory, setting.name)) for setting in settings])


def needs_seeds(study, settings):
    """Whether copies of the finest run would tell what its levels cannot."""
    return tables.needs_seeds(analyse(study, settings))


def remove_earlier(folder, names):
    """Of what was written before there may be less now."""
    for file in os.listdir(folder) if os.path.isdir(folder) else ():
        if file.split(".")[0].rstrip("0123456789") in names:
            os.remove(os.path.join(folder, file))


def collect(study, settings):
    """Write and print everything. @return the analysis."""
    style.apply()
    analysis = analyse(study, settings)
    figures = os.path.join(study.directory, "figures")
    os.makedirs(figures, exist_ok=True)
    remove_earlier(figures, [figure.__name__.split(".")[-1] for figure in FIGURES])
    remove_earlier(os.path.join(study.directory, "tables"), report.TABLES)
    folder = report.write(analysis)
    for figure in FIGURES:
        figure.draw(analysis, figures)
    print(report.text(analysis))
    print("files     %s, %s" % (os.path.relpath(folder), os.path.relpath(figures)))
    return analysis
