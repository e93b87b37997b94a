# SPDX-License-Identifier: GPL-3.0-or-later
"""Infinite slope under a horizontal acceleration a (limit equilibrium of a slab of height H normal to the slope b):

    c + (rho g H cos b - rho a H sin b) tan phi = rho g H sin b + rho a H cos b     at a = a_c

and above it the slab slides with s'' = (a - a_c) (cos b + sin b tan phi), as the seam's residual strength is its peak: also
where its joints have been released and corners of triangles stand on the ground. Then the cohesion is that of the part of the
slab that is on the seam still, c (1 - s / width), less the half of the last edge that the corner at the rear end stands for: friction
turns the slab forwards, so that corner stands open and has no cohesion. A joint is released when it has slid by a tenth of its length.
"""

import numpy as np
from scene_numbers import Numbers
from slope import uphill


class Slope:
    def __init__(self, run):
        numbers = Numbers(run)
        b, seam, density = np.radians(numbers.mesh("Angle")), numbers.material("seam"), numbers.material("mass").density
        mu, mass = np.tan(seam.friction), density * numbers.mesh("Height")  # mass per area [kg/m2]
        weight = mass * numbers.gravity()
        self.rate = np.cos(b) + np.sin(b) * mu  # acceleration of the slide over that above the critical one [-]
        self.critical = (seam.cohesion + weight * (np.cos(b) * mu - np.sin(b))) / (mass * self.rate)  # [m/s2]
        self.peak = numbers.number("Motion/Peak")
        self.width, self.cohesion = numbers.mesh("Width"), seam.cohesion / (mass * self.rate)  # of the critical one [m/s2]
        self.edge = numbers.mesh("Resolution/h")  # of a block on the seam [m]
        self.release = 0.1 * self.edge  # [m]
        self.joints = int(np.ceil(numbers.mesh("Width") / numbers.mesh("Resolution/h") - 1e-9))  # of the seam


def slip(run):
    return -run.relative_displacement("slab") @ uphill(run)


def closed_form(time, slope):
    """Slip [m] of a rigid slab under the ramp of smooth_ramp.txt scaled to the peak [m/s2]."""
    fine = np.linspace(0.0, time[-1], 20001)
    base = slope.peak * 0.5 * (1 - np.cos(np.pi * np.minimum(fine, 2.0) / 2)) - slope.critical
    h, v = fine[1], 0.0
    s = np.zeros(fine.size)
    for i in range(1, fine.size):
        lost = s[i - 1] + 0.5 * (slope.edge - s[i - 1])  # off the seam, and below the open corner [m]
        left = slope.cohesion * lost / slope.width if s[i - 1] > slope.release else 0.0
        rate = (base[i] + left) * slope.rate
        v += h * (rate if v > 0 else max(rate, 0.0))
        s[i] = s[i - 1] + h * v
    return np.interp(time, fine, s)


def check(case):
    slides = case.run()
    slope = Slope(slides)
    case.below("peak of the scene over 1.02 of the critical acceleration, less 1", slope.peak / (1.02 * slope.critical) - 1,
               1e-3)
    holds = case.run("holds", "Motion/Peak=%.10g" % (0.98 * slope.critical))
    released = case.run("released", "Motion/Peak=%.10g" % (1.1 * slope.critical))
    case.curves = {part: (run.time, slip(run), closed_form(run.time, Slope(run))) for part, run in
                   ((0.98, holds), (1.02, slides), (1.1, released))}
    time, found, _ = case.curves[0.98]
    case.below("slip after the ramp at 0.98 of the critical acceleration", np.ptp(found[time > 2.5]), 1e-6, "m")
    time, found, expected = case.curves[1.02]
    case.true("slides at 1.02: %.3g m, as a rigid slab %.3g m" % (found[-1], expected[-1]), found[-1] > 0.01)
    steady = time > 2.2
    rate = 2 * np.polyfit(time[steady], found[steady], 2)[0]
    case.near("critical acceleration from the acceleration of the slide",
              slope.peak - rate / slope.rate, slope.critical, 0.02, "m/s2")
    time, found, expected = case.curves[1.1]
    case.true("all joints of the seam have failed in shear at 1.1: slide %.3g m, as a rigid slab %.3g m"
              % (found[-1], expected[-1]), released.summary["joints"]["shear"] == slope.joints)
    case.near("slide at 1.1, through the release", found[-1], expected[-1], 0.01, "m")
    loose = time > released.file["joints/failure_time"][:].max() + 0.1
    rate, wanted = (2 * np.polyfit(time[loose], slide[loose], 2)[0] for slide in (found, expected))
    case.near("acceleration of the slide after the release", rate, wanted, 0.01, "m/s2")


def draw(case, figure):
    axes = figure.subplots()
    for part, (time, found, expected) in case.curves.items():
        axes.plot(time, expected, color="0.7", linewidth=4)
        axes.plot(time, found, label="hybrid, %g of the critical acceleration" % part)
    axes.plot([], [], color="0.7", linewidth=4, label="limit equilibrium and rigid slide")
    axes.set(xlabel="time [s]", ylabel="slip down the slope [m]")
    axes.legend()
