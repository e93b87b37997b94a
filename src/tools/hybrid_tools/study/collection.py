# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables, figures and words of what there is of a study."""

import os

from hybrid_tools import style
from hybrid_tools.study import costs, error_over_time, orders, report, scatter, tables
from hybrid_tools.study.analysis import Analysis
from hybrid_tools.study.run_directory import RunDirectory

FIGURES = (error_over_time, orders, costs, scatter)


def analyse(study, settings):
    return Analysis(study, [(setting, RunDirectory(study.directory, setting.name)) for setting in settings])


def needs_seeds(study, settings):
    """Whether copies of the finest run would tell what its levels cannot."""
    return tables.needs_seeds(analyse(study, settings))


def collect(study, settings):
    """Write and print everything. @return the analysis."""
    style.apply()
    analysis = analyse(study, settings)
    folder = report.write(analysis)
    figures = os.path.join(study.directory, "figures")
    os.makedirs(figures, exist_ok=True)
    for figure in FIGURES:
        figure.draw(analysis, figures)
    print(report.text(analysis))
    print("files     %s, %s" % (os.path.relpath(folder), os.path.relpath(figures)))
    return analysis
