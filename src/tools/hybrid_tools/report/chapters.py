# SPDX-License-Identifier: GPL-3.0-or-later
"""What the page tells of one run, in its order."""

from dataclasses import dataclass, field

from hybrid_tools.plot import failure_process, velocities

from . import costs, errors, facts, panels, random_field

# (identifier, heading, drawings); a chapter whose data the run lacks is left out.
CHAPTERS = (("motion", "Motion of the ground", (panels.motion, panels.spectrum)),
            ("slip", "Slip", (panels.slip_history, panels.slip_profile)),
            ("place", "Where blocks lie", (panels.final, panels.model)))


@dataclass
class Chapter:
    id: str
    name: str
    panels: list = field(default_factory=list)
    head: list = None
    rows: list = None


@dataclass
class Told:
    """One run as the template wants it."""

    id: str
    label: str
    title: str
    directory: str
    state: str
    is_good: bool
    headline: str
    facts: list
    picture: object
    warnings: list
    chapters: list
    card: list
    changed: list
    parameters: list


def tell(run, identifier, label):
    """Everything about a run; figures are drawn here."""
    state, is_good = facts.state(run)
    changed, everything = facts.parameters(run)
    return Told(identifier, label, run.title(), run.directory, state, is_good, facts.headline(run), facts.facts(run),
                panels.panel(run, panels.section, identifier + "-section"), facts.warnings(run), chapters(run, identifier), facts.card(run),
                changed, everything)


def chapters(run, identifier):
    found = []
    for name, heading, drawings in CHAPTERS:
        found.append(Chapter(name, heading, drawn(run, identifier, drawings)))
    found.insert(2, monitors(run, identifier))
    found.insert(3, conditioning(run))
    found.insert(4, Chapter("failure", "How the mass fails", panels.of_plot(run, failure_process, identifier, (
        "The section at six times, with the joints that have failed by then."))))
    found.append(Chapter("boreholes", "Boreholes", [panel for name in holes(run) if (panel := panels.panel(
        run, panels.of_borehole, "%s-hole-%s" % (identifier, safe(name)), name))]))
    found.append(Chapter("random", "Heterogeneity", drawn(run, identifier, (random_field.modulus, random_field.strength))))
    found.append(Chapter("energy", "Energy", drawn(run, identifier, (panels.energy,))))
    found.append(Chapter("errors", "How far off", head=errors.HEAD, rows=errors.rows_of(run)))
    rows = costs.rows_of(run)
    found.append(Chapter("cost", "Where the time went", drawn(run, identifier, (costs.steps,)), costs.HEAD if rows else None, rows))
    found.append(Chapter("velocities", "Velocities", panels.of_plot(run, velocities, identifier, (
        "Horizontal velocities of the monitors; neighbours that move alike stand together."))))
    found.append(histories(run, identifier))
    return [chapter for chapter in found if chapter.panels or chapter.rows]


def drawn(run, identifier, drawings):
    return [panel for draw in drawings if (panel := panels.panel(run, draw, "%s-%s" % (identifier, draw.__name__)))]


def holes(run):
    paths = {name: "profiles/%s/displacement" % name for name in run.names("profiles")}
    return [name for name, path in paths.items() if run.has(path) and len(run.file[path])]


def monitors(run, identifier):
    unit, rows = facts.monitor_rows(run)
    against = " relative to " + run.base if run.base else ""
    head = ["monitor", "peak displacement%s [%s]" % (against, unit), "left [%s]" % unit, "peak acceleration [m/s²]", "× outcrop in its direction",
            "peak velocity [m/s]", "x [m]", "y [m]"]
    return Chapter("monitors", "Monitors", drawn(run, identifier, (panels.displacements, panels.ratios)), head if rows else None, rows)


def conditioning(run):
    """What hybrid condition has found: the first event beside the last, in millimetres."""
    found = run.summary.get("conditioning")
    if not found:
        return Chapter("conditioning", "Virgin and conditioned")
    columns = [column for column in found["states"][0] if "displacement" in column or "left" in column] if found["states"] else []
    rows = [[state["monitor"]] + ["%.4g" % (1e3 * state[column]) for column in columns] for state in found["states"]]
    rows.append([found["verdict"]] + [""] * len(columns))
    return Chapter("conditioning", "Virgin and conditioned", head=["monitor"] + [column + " [mm]" for column in columns], rows=rows)


def histories(run, identifier):
    """Every monitor, group after group."""
    names = [name for group in run.monitor_groups().values() for name in group] if run.n >= 2 else []
    return Chapter("histories", "Histories", [panel for name in names if (panel := panels.panel(
        run, panels.of_monitor, "%s-monitor-%s" % (identifier, safe(name)), name))])


def safe(name):
    """For an identifier: what is no letter or digit by its number."""
    return "".join(letter if letter.isalnum() and letter.isascii() else "-%x-" % ord(letter) for letter in name)
