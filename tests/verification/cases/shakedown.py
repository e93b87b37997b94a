# SPDX-License-Identifier: GPL-3.0-or-later
"""A slab whose seam is weak (cohesion c, no friction) below its lower half, under a slow pulse that comes three times.

Let F be the shear force on the weak part of length L, and F_el(t) that of the same slab with a strong seam. At the peak of the first event all of the
weak part slips: F = c L. What follows is elastic, so at rest F = c L - (F_el(peak) - F_el(rest)). A second equal event brings F back to c L
and no farther: it adds no slip (the theorem of Melan 1938: a residual stress with which nothing yields). With the weak seam below all of the slab
nothing can bear a residual stress: each event adds the same slip.
"""

import numpy as np
from hybrid_tools.condition.events import Events, is_conditioned
from scene_numbers import Numbers
from vtu_file import picture_at

PART = 0.1


class Seam:
    """The weak part of the seam."""

    def __init__(self, run):
        numbers = Numbers(run)
        b = np.radians(numbers.mesh("Angle"))
        self.along, self.normal = np.array([np.cos(b), np.sin(b)]), np.array([-np.sin(b), np.cos(b)])
        self.length = 0.5 * numbers.mesh("Width")
        self.edge = numbers.mesh("Resolution/h")
        self.cohesion = numbers.material("weak").cohesion

    def shear(self, run, time):
        """Size of the shear force on the slab [N/m]."""
        picture, found = picture_at(run.directory, "joints", time)
        assert abs(found - time) < 1e-6
        ground = run.history("monitors/ground/displacement")
        where = picture.centroids() - (ground[np.argmin(np.abs(run.time - time))] if time > 0 else 0)
        stress = picture.cell_fields["shear stress [Pa]"].astype(float)
        on = (np.abs(where @ self.normal) < 0.1 * self.edge) & (where @ self.along < self.length - 0.25 * self.edge)
        assert on.sum() == round(self.length / self.edge)
        return np.abs(stress[on].sum()) * self.edge


def check(case):
    run = case.run()
    elastic = case.run("elastic", "Materials/weak/Cohesion=1e9")
    weak = case.run("all_weak", "Water/Level=100", "Motion/Peak=1.2")  # its joints are not yet released
    numbers, seam = Numbers(run), Seam(run)
    period = numbers.number("Motion/Repetition interval")
    peak = run.time[run.get("input/acceleration")[:, 0][run.time < period].argmax()]
    case.events = {"half weak": Events(run, period).all(), "all weak": Events(weak, period).all()}
    limit = seam.cohesion * seam.length
    rest, loaded = (seam.shear(elastic, t) for t in (0.0, peak))
    case.near("shear force on the weak seam at the peak over c L", seam.shear(run, peak) / limit, 1.0, 1e-3)
    for number in (1, 2, 3):
        case.near("the same at rest after event %d" % number, seam.shear(run, number * period) / limit,
                  abs(1 - (loaded - rest) / limit), 0.02)
    first, second, third = case.events["half weak"]
    case.true("the first event leaves %.3g mm at %s" % (1e3 * first.added[0], first.added[1]), first.added[0] > 1e-4)
    for event in (second, third):
        case.below("mean slip that event %d adds, of the first" % event.number, event.slip / first.slip, 1e-4)
    case.true("the second event is conditioned", is_conditioned(first, second, PART))
    case.true("no joint fails", sum(event.failures for event in case.events["half weak"]) == 0)
    first, second, third = case.events["all weak"]
    for event in (second, third):
        # The slab is elastic, and rings as it stops.
        case.near("all weak: slip that event %d adds" % event.number, event.slip, first.slip, 0.05, "m")
    case.true("all weak: never conditioned", not is_conditioned(first, third, PART))


def draw(case, figure):
    for axes, (name, events) in zip(figure.subplots(1, 2), case.events.items()):
        axes.bar([event.number for event in events], [1e3 * event.slip for event in events])
        axes.set(title=name, xlabel="event", ylabel="mean slip added [mm]", xticks=[event.number for event in events])
