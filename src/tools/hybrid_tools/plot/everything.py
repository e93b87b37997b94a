# SPDX-License-Identifier: GPL-3.0-or-later
"""What --all draws beside the figures of each run: a film of each, and the runs side by side."""

import os

from hybrid_run import MissingData, UserError
from hybrid_tools import style
from hybrid_tools.animate import command as animate
from hybrid_tools.compare import command as compare
from hybrid_tools.compare.comparison import Comparison, labels_of

from . import catalogue

FEWEST = 2  # pictures: no film of them


def films(runs):
    """RUN/figures/motion.mp4 (or .gif) of each run that has pictures of its blocks; each says its file."""
    for run in runs:
        try:
            if len(run.pictures("blocks")) <= FEWEST:  # Output/Picture interval = 0
                raise MissingData("'%s' has pictures of its beginning and its end only; they come every Output/Picture interval" % run.directory)
            animate.film_of(run)
        except MissingData as reason:
            print("film: left out, %s" % reason)


def side_by_side(runs):
    """Table and figures of several runs that can be compared, in compare/ beside the first. @return how many figures failed."""
    if len(runs) < 2:
        return 0
    before = len(style.written)
    try:
        comparison = Comparison(runs, labels_of([run.directory for run in runs]))
        compare.check_sections(comparison)
        directory = compare.directory_for(runs, None)
        answer, _, failed = compare.compare(comparison, directory)
    except (MissingData, UserError) as reason:
        print("side by side: left out, %s" % reason)
        return 0
    for verdict in answer.verdicts:
        print("verdict: " + verdict)
    catalogue.say("side by side", [os.path.join(directory, "table." + kind) for kind in ("csv", "json", "md")] + style.written[before:])
    return failed
