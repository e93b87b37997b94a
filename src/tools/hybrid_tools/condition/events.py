# SPDX-License-Identifier: GPL-3.0-or-later
"""What each event of a repeated motion adds: displacements and slip are counted from zero at its start."""

from dataclasses import dataclass, field

import numpy as np

WINDOW = 2.0  # mean over so much at the end of an event is what it leaves [s], at most a tenth of the event
NOTHING = 1e-9  # an event that adds less has left nothing [m]
NOTHING_PART = 1e-5  # likewise, of the largest displacement in it: the ground still swings by as much


@dataclass
class Point:
    """A monitor in one event, relative to its place at the start of the event and to the base (Events.relative_to)."""

    left: np.ndarray  # [m]
    peak: float  # largest size of displacement [m]
    acceleration: float  # largest size of a component below the run's corner [m/s2]


@dataclass
class Event:
    """One event of a run."""

    number: int  # from 1
    points: dict = field(default_factory=dict)  # Point by monitor; tops of boreholes are monitors
    slip: float = None  # mean slip on the sliding surface that it adds, downhill positive [m]; None: no such surface
    largest_slip: float = None  # of the sole that has slid farthest [m]
    failures: int = 0  # joints that fail

    @property
    def added(self):
        """The largest displacement that it leaves [m], and the monitor."""
        name = max(self.points, key=lambda n: np.linalg.norm(self.points[n].left))
        return float(np.linalg.norm(self.points[name].left)), name

    def sizes(self):
        """What has to become small: displacement left and mean slip [m]."""
        return [self.added[0] if self.points else 0.0, abs(self.slip or 0.0)]

    @property
    def nothing(self):
        """What counts as nothing [m]."""
        return max([NOTHING] + [NOTHING_PART * point.peak for point in self.points.values()])


def is_conditioned(first, last, part):
    """An event adds at most a part of what the first one has left, in displacement and in slip."""
    return all(now <= max(part * before, last.nothing) for now, before in zip(last.sizes(), first.sizes()))


def leaves_nothing(event):
    return max(event.sizes()) <= event.nothing


class Events:
    """Events of a run, each of so many seconds."""

    def __init__(self, run, period):
        self.run, self.period = run, period
        self.window = min(WINDOW, 0.1 * period)
        histories = {name: run.relative_displacement(name) for name in run.names("monitors") if name != run.base}
        for hole in run.names("profiles"):
            histories.setdefault(hole, run.history("profiles/%s/displacement" % hole)[:, :2])
        if self.is_relative_to_motion:
            histories = {name: history - run.history("input/displacement") for name, history in histories.items()}
        self.histories = histories
        self.count = int(round(run.time[-1] / period))

    @property
    def is_relative_to_motion(self):
        """Without a base monitor: relative to a rigid base, which moves as the motion says."""
        return not self.run.base and self.run.parameters["Model/Bedrock"] == "rigid" and self.run.has("input/displacement")

    @property
    def relative_to(self):
        """What displacements are relative to; None: to nothing."""
        return "the base monitor " + self.run.base if self.run.base else "the rigid base" if self.is_relative_to_motion else None

    def span(self, number):
        """Rows of an event."""
        end = 1e-9 * self.period
        return (self.run.time > (number - 1) * self.period + end) & (self.run.time <= number * self.period + end)

    def end_of(self, number, history):
        """Mean of a history at the end of an event; zero before the first."""
        if number == 0:
            return 0 * history[0]
        time = self.run.time
        return history[self.span(number) & (time >= number * self.period - self.window)].mean(axis=0)

    def peak_acceleration(self, name, number):
        path = "monitors/%s/acceleration" % name
        if not self.run.has(path):
            return None
        time, values = self.run.filtered(path)
        rows = (time > (number - 1) * self.period) & (time <= number * self.period)
        return float(np.abs(values[rows]).max())

    def event(self, number):
        found = Event(number)
        for name, history in self.histories.items():
            start = self.end_of(number - 1, history)
            moved = np.linalg.norm(history[self.span(number)] - start, axis=1).max()
            found.points[name] = Point(self.end_of(number, history) - start, float(moved), self.peak_acceleration(name, number))
        if self.run.has("slip/mean"):
            mean, largest = self.run.history("slip/mean"), self.run.history("slip/largest")
            found.slip = float(self.end_of(number, mean) - self.end_of(number - 1, mean))
            found.largest_slip = float(self.end_of(number, largest) - self.end_of(number - 1, largest))
        if self.run.has("joints/failure_time"):
            times = self.run.file["joints/failure_time"][:]
            found.failures = int(((times > (number - 1) * self.period) & (times <= number * self.period)).sum())
        return found

    def all(self):
        return [self.event(k + 1) for k in range(self.count)]
