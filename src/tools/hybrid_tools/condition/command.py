# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid condition SCENE: what a motion leaves in a slope that was never shaken, and in one that was shaken until little is added.

The motion comes again with quiet time between, in one run that is resumed with a later end, until an event adds little.
"""

import json
import os

import numpy as np

from hybrid_run import UserError
from hybrid_tools import style
from hybrid_tools.arguments import Arguments
from hybrid_tools.condition import figure
from hybrid_tools.condition.events import Events, is_conditioned, leaves_nothing
from hybrid_tools.condition.repetition import Repetition
from hybrid_tools.results_place import default_directory, refuse_other_scene
from hybrid_tools.table import Column, Table, percent

EXAMPLES = """  hybrid condition my.prm                        # at most 6 events, until one adds less than a tenth of the first
  hybrid condition my.prm --part 0.05 --events 10
  hybrid condition my.prm -s "Gravity/Initial stress=1 - sin phi"
  hybrid report output/my_condition/run          # the page of the run, all events in it
"""
LENGTH = "%.4g"


def read_words(words):
    arguments = Arguments("condition", "What a motion leaves in a slope that was never shaken (virgin), and in one that the same motion has shaken\n"
                          "until an event adds little (conditioned). Displacements and slip count from zero at the start of each event.", EXAMPLES)
    arguments.add_argument("scene", metavar="SCENE", help="parameter file")
    arguments.add_argument("-s", dest="overrides", metavar='"Section/Name=value"', action="append", default=[],
                           help="override one parameter")
    arguments.add_argument("--events", type=int, default=6, help="at most so many, 2 or more (default 6)")
    arguments.add_argument("--part", type=float, default=0.1,
                           help="conditioned: an event adds at most this part of the first one's displacement and slip (default 0.1)")
    arguments.add_argument("--quiet", type=float, default=5.0, help="time after Time/End time before the next event [s] (default 5)")
    arguments.add_argument("--output", metavar="DIR", help="where results go (default: output/SCENE_condition)")
    arguments.add_argument("--force", action="store_true", help="replace results of another scene in that directory")
    found = arguments.read(words)
    if not 2 <= found.events <= 1000:
        raise UserError("--events is %d: 2 to 1000 are allowed" % found.events)
    if not 0 < found.part < 1:
        raise UserError("--part is %g: between 0 and 1 is allowed" % found.part)
    if not 0 <= found.quiet <= 1e5:
        raise UserError("--quiet is %g: 0 to 1e5 s are allowed" % found.quiet)
    if not os.path.isfile(found.scene):
        raise UserError("'%s' is no parameter file" % found.scene)
    found.output = found.output or default_directory(found.scene, "_condition")
    if not found.force:
        refuse_other_scene(found.output, "condition", found.scene)
    return found


def part_of(now, before):
    return "-" if before == 0 else "%.0f %%" % (100 * now / before)


def tell(event, first):
    added, where = event.added
    slip = "" if event.slip is None else "   mean slip %8.3g mm  %5s" % (1e3 * event.slip, part_of(abs(event.slip), abs(first.slip)))
    print("event %2d   adds %8.3g mm at %-8s %5s%s   %d joints failed" % (
        event.number, 1e3 * added, where, part_of(added, first.sizes()[0]), slip, event.failures), flush=True)


def tell_warnings(warnings, told):
    """Those that are new."""
    for warning in warnings[len(told):]:
        print(warning, flush=True)
    told[:] = warnings


def table_of_events(done):
    table = Table([Column("event", "", "%d"), Column("displacement added", "m", LENGTH), Column("of the first", "", lambda v: "%.0f %%" % (100 * v)),
                   Column("at"), Column("mean slip added", "m", LENGTH), Column("largest slip added", "m", LENGTH),
                   Column("joints failed", "", "%d")])
    for event in done:
        added, where = event.added
        first = done[0].sizes()[0]
        table.add(event.number, added, added / first if first else None, where, event.slip, event.largest_slip, event.failures)
    return table


def table_of_states(first, last, conditioned):
    """Virgin beside conditioned: the first event and the last."""
    state = "conditioned" if conditioned else "event %d" % last.number
    table = Table([Column("monitor"), Column("left, virgin", "m", LENGTH), Column("left, " + state, "m", LENGTH),
                   Column("peak displacement, virgin", "m", LENGTH), Column("peak displacement, " + state, "m", LENGTH),
                   Column("peak acceleration, virgin", "m/s2", LENGTH), Column("its change", "", percent)])
    for name, before in first.points.items():
        after = last.points[name]
        change = after.acceleration / before.acceleration - 1 if before.acceleration else None
        table.add(name, float(np.linalg.norm(before.left)), float(np.linalg.norm(after.left)), before.peak, after.peak, before.acceleration, change)
    return table


def verdict(done, part):
    """(is conditioned, one sentence)."""
    first, last = done[0], done[-1]
    if leaves_nothing(first):
        return True, "The first event leaves nothing: there is nothing to condition."
    added, where = last.added
    text = "adds %.3g mm at %s, %s of the first" % (1e3 * added, where, part_of(added, first.sizes()[0]))
    if last.slip is not None:
        text += ", and %.3g mm of mean slip, %s" % (1e3 * last.slip, part_of(abs(last.slip), abs(first.slip)))
    if is_conditioned(first, last, part):
        return True, "Conditioned: event %d %s." % (last.number, text)
    return False, "Not conditioned: event %d %s, and at most %.0f %% are asked for; the motion leaves something every time, or wants more --events." % (last.number, text, 100 * part)


def what_displacements_are(base):
    said = "relative to %s" % base if base else "absolute, with the motion of the ground in them (Monitors/Base names a monitor to count from)"
    return "Displacements are sizes of vectors, %s; the lines of a run tell the larger component." % said


def keep_in_summary(run, content):
    """For hybrid report."""
    path = os.path.join(run.directory, "summary.json")
    with open(path, encoding="utf-8") as file:
        summary = json.load(file)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(dict(summary, conditioning=content), file, indent=1)
        file.write("\n")


def main(words):
    found = read_words(words)
    os.makedirs(found.output, exist_ok=True)
    repetition = Repetition(found.scene, found.overrides, found.quiet, found.events, os.path.join(found.output, "run"))
    style.apply()
    done, events, told = [], None, []
    tell_warnings(repetition.warnings, told)
    while len(done) < found.events:
        if events:
            events.run.file.close()  # the program writes it
        events = Events(repetition.run_event(len(done) + 1), repetition.period)
        done.append(events.event(len(done) + 1))
        tell(done[-1], done[0])
        tell_warnings(repetition.warnings, told)
        if leaves_nothing(done[0]) or (len(done) > 1 and is_conditioned(done[0], done[-1], found.part)):
            break
    conditioned, sentence = verdict(done, found.part)
    overview, states = table_of_events(done), table_of_states(done[0], done[-1], conditioned)
    meaning = what_displacements_are(events.relative_to)
    more = {"scene": os.path.abspath(found.scene), "overrides": found.overrides, "part": found.part, "period_s": repetition.period,
            "conditioned": conditioned, "verdict": sentence, "relative_to": events.relative_to, "warnings": told, "states": states.records()}
    above = "\n\n".join(["# Virgin and conditioned", sentence] + told) + "\n"
    overview.write(found.output, "condition", more, above, "\n" + states.markdown() + "\n\n" + meaning)
    keep_in_summary(events.run, dict(more, events=overview.records()))
    figure.draw(events, done, found.part, found.output)
    print("\n" + states.text() + "\n" + meaning + "\n\n" + sentence)
    print("files    %s: condition.json, condition.csv, condition.md, condition.png; run (all events)" % found.output)
    return 0
