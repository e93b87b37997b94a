# SPDX-License-Identifier: GPL-3.0-or-later
"""The hard cases: their runs, limits, and what is asked of one besides that of all."""

import dataclasses
import pathlib
import re
import typing

import numpy as np
from overlaps import area
from vtu_file import pictures

HARD = pathlib.Path(__file__).resolve().parents[2] / "parameters/hard"


@dataclasses.dataclass
class Wanted:
    """What a case runs (variant: overrides) and what it must meet."""

    variants: dict = dataclasses.field(default_factory=lambda: {"scene": []})
    full_size: dict = dataclasses.field(default_factory=dict)  # runs of --long, instead of the others
    refusals: list = dataclasses.field(default_factory=list)  # (variant, overrides, words of the message)
    full_speed: float = 0.0  # bound on the velocity of --long [m/s]; 0: that of the scene
    residual: float = 0.01  # of the energy audit; 0.001 where nothing hits or breaks
    penetration: float = 0.01  # overlap over block size
    full_penetration: float = 0.0  # that of --long; 0: that of the scene
    more: typing.Optional[typing.Callable] = None  # more(case, variant, run)

    def runs(self, long):
        return (self.full_size if long and self.full_size else self.variants).items()


def moved(run):
    """Largest way of a block since the static stage [m]."""
    return run.get("section/blocks_peak_displacement").max()


def rests(limit):
    return lambda case, variant, run: case.below("%s: way of a block" % variant, moved(run), limit, "m")


def rebound_is_slower(case, variant, run):
    kinetic = run.get("energy/blocks_kinetic")
    case.true("%s: the block hit the ground, kinetic energy fell from %.3g to %.3g J/m" % (variant, kinetic.max(), kinetic[-1]),
              kinetic[-1] < 0.9 * kinetic.max())


def most_joints_fail(case, variant, run):
    log = (run.directory_path / "log.txt").read_text(encoding="utf-8")
    joints = sum(map(int, re.search(r"(\d+) joints between them, a belt of (\d+) edge", log).groups()))
    time = run.get("joints/failure_time")
    at_once = (time < 1.1e-3).sum()
    case.true("%s: %d of %d joints failed, %d of them within 1 ms" % (variant, len(time), joints, at_once),
              at_once == joints if variant == "thrown" else len(time) > 0.5 * joints)


def heavy_block_is_not_thrown(case, variant, run):
    """Speed of the heavy one of two blocks, which falls by 1.2 m at most."""
    heavy = 0 if variant == "light above" else 1
    speed = max(np.linalg.norm(p.point_fields["velocity [m/s]"][p.cells[heavy], :2].mean(axis=0))
                for _, p in pictures(run.directory_path, "blocks"))
    case.below("%s: velocity of the heavy block" % variant, speed, np.sqrt(2 * 9.81 * 1.2), "m/s")


def lies_in_the_bin(case, variant, run):
    """All blocks above the bin's bottom and between its walls; nearly all energy is gone."""
    kinetic, corners = run.get("energy/blocks_kinetic"), run.get("section/blocks_points_final")
    case.below("%s: kinetic energy at the end, of its peak" % variant, kinetic[-1] / kinetic.max(), 0.02)
    bin_ends = np.abs(run.get("section/outline")[:, [0, 2]]).max()
    case.below("%s: corner farthest from the middle" % variant, np.abs(corners[:, 0]).max(), bin_ends, "m")


def falls_apart(case, variant, run):
    joints = run.summary["joints"]
    failed = joints["tensile"] + joints["shear"]
    moved_most = run.get("section/blocks_peak_displacement").max()
    case.true("%s: %d joints failed, largest displacement %.2f m" % (variant, failed, moved_most), failed > 50)


def gapes(case, variant, run):
    joints, moved_most = run.summary["joints"], run.get("section/blocks_peak_displacement").max()
    case.true("%s: the joint with the base has failed, the square fell by %.1f m" % (variant, moved_most),
              joints["tensile"] == 1 and moved_most > 5)


def says(words):
    def look(case, variant, run):
        log = (run.directory_path / "log.txt").read_text(encoding="utf-8")
        case.true("%s: the log says '%s'" % (variant, words), words in log)

    return look


def ends_at_rest(case, variant, run):
    """The record's offset is taken off, and its end before that of the run is reported."""
    case.below("%s: velocity of the ground at the end" % variant, np.abs(run.get("input/velocity")[-1]).max(), 1e-6, "m/s")
    says("the motion ends at")(case, variant, run)


def falls_freely(case, variant, run):
    lowest = run.get("section/blocks_points_final")[:, 1].min()
    case.true("%s: a block is %.1f m below the end of the slope" % (variant, -1.5 - lowest), lowest < -3)


def moved_until_it_touched(case, variant, run):
    """The block has crossed the 5 cm before the wall; the toe of the wedge is on the bench."""
    drawn, final = (run.get("section/" + name) for name in ("blocks_points", "blocks_points_final"))
    if variant == "bench":
        case.below("%s: toe below the bench" % variant, 2 - final[7, 1], 0.02, "m")  # the joint wakes its blocks after 1/400 of 6 m
    else:
        case.below("%s: distance from the wall" % variant, abs(final[8, 0] - final[6, 0]), 1e-3, "m")
    case.true("%s: it moved" % variant, np.linalg.norm(final - drawn, axis=1).max() > (0.01 if variant == "bench" else 0.04))


def stands_on_its_tread(case, variant, run):
    """All blocks where they were drawn, but for the elastic settlement of the largest one in mud: 0.2 % of its size."""
    drawn, final = (run.get("section/" + name) for name in ("blocks_points", "blocks_points_final"))
    size = np.repeat([np.sqrt(area(corners)) for corners in drawn.reshape(-1, 4, 2)], 4)
    case.below("%s: way of a corner, of the block's size" % variant, (np.linalg.norm(final - drawn, axis=1) / size).max(), 4e-3)


def same_as_alone(case, variant, run):
    if variant == "scene":
        case.together = run
        return
    a, b = (r.get("section/blocks_points_final")[:4] for r in (case.together, run))
    case.below("%s: difference of the first block's corners" % variant, np.abs(a - b).max(), 1e-9, "m")
    case.true("%s: it moved" % variant, np.abs(b - run.get("section/blocks_points")[:4]).max() > 0.1)


def tips_over_the_end(case, variant, run):
    """The slab as at a cliff; its end may be the left one."""
    corners = run.get("section/blocks_points_final")
    if variant == "scene":
        case.at_cliff = np.sort(corners, axis=0)
    elif variant == "square":
        case.below("square: its middle lies at half its size, error", abs(corners[:, 1].mean() - 0.5), 1e-3, "m")
    else:
        side = -1 if variant == "left end" else 1
        found = np.sort(corners * [side, 1], axis=0)
        case.below("%s: difference of the slab's corners" % variant, np.abs(found - case.at_cliff).max(), 1e-3, "m")


def light_as_alone(case, variant, run):
    pebble = run.get("section/blocks_points_final")[:4] - run.get("section/blocks_points")[:4]
    if variant == "scene":
        case.together = pebble
    elif variant == "alone":
        way = np.abs(pebble).max()
        case.below("%s: difference of the pebble's way of %.3g m, over it" % (variant, way), np.abs(pebble - case.together).max() / way, 1e-5)
    else:
        slope, t = np.radians(45), run.time[-1]
        expected = 0.5 * 9.81 * (np.sin(slope) - np.cos(slope) * np.tan(np.radians(30))) * t**2
        way = np.linalg.norm(run.get("section/blocks_displacement")[0])
        case.below("%s: the pebble slides %.5f m, closed form %.5f, error" % (variant, way, expected), abs(way / expected - 1), 5e-3)


def lands_or_pushes(case, variant, run):
    corners = run.get("section/blocks_points_final")
    if variant == "row":
        slab, t = corners[:4] - run.get("section/blocks_points")[:4], run.time[-1]
        expected = 6 * t - 0.5 * 9.81 * np.tan(np.radians(20)) * t**2
        case.below("%s: the slab slides %.4f m, closed form %.4f, error" % (variant, slab[:, 0].mean(), expected), abs(slab[:, 0].mean() / expected - 1), 1e-3)
        return
    if variant == "meets":
        front = corners[:4, 0].max()
        case.true("%s: the pebbles are before the block, by %.2f m and more" % (variant, corners[4:, 0].min() - front), corners[4:, 0].min() > front - 1e-3)
    else:
        overlap = 0.02 if variant == "soft" else 1e-4  # of 10 m of 10 MPa: rho g h^2 / (40 E) = 6 mm
        case.below("%s: corners below the ground" % variant, -corners[:, 1].min(), overlap, "m")


def momentum_along_ground(picture):
    """Over the density, per metre of thickness [m3/s]."""
    velocity = picture.point_fields["velocity [m/s]"]
    return sum(area(picture.points[c, :2]) * velocity[c, 0].mean() for c in picture.cells)


def pushes_or_rides(case, variant, run):
    """No square is where its wedge was and the wedge there still; without friction nothing slows them but each other."""
    seen = [picture for _, picture in pictures(run.directory_path, "blocks")]
    if variant != "friction":
        first, last = (momentum_along_ground(picture) for picture in (seen[0], seen[-1]))
        case.below("%s: momentum along the ground lost, of it" % variant, abs(last / first - 1), 1e-5)
    wedges = [c for c, behind in zip(seen[0].cells, seen[0].cells[1:]) if len(c) == 3 and len(behind) == 4]
    ways = [(seen[0].points[c, 0] - seen[-1].points[c, 0]).mean() for c in wedges]
    case.true("%s: the wedges are pushed along, by %.3g to %.3g m" % (variant, min(ways), max(ways)), min(ways) > 0.1)


def slides_as_one(case, variant, run):
    """Closed form of a rigid block on the slope, within 0.5 %; columns of five (--long) lean on each other instead."""
    if variant != "scene":
        return
    slope, friction, t = np.radians(20), np.radians(15), run.time[-1]
    expected = 0.5 * 9.81 * (np.sin(slope) - np.cos(slope) * np.tan(friction)) * t**2
    mean = np.linalg.norm(run.get("section/blocks_displacement").mean(axis=0))
    case.below("%s: mean slide %.5f m, closed form %.5f, error" % (variant, mean, expected), abs(mean / expected - 1), 5e-3)


def slides_uncut(case, variant, run):
    slides_as_one(case, variant, run)
    needs_no_cut(case, variant, run)


def gives_nothing_back(case, variant, run):
    """No step gives more than the filter has on loan, and all of them none; joints fail."""
    loss, kinetic = run.get("energy/blocks_integration_loss"), run.get("energy/blocks_kinetic")
    play = kinetic.max() - kinetic.min()
    case.below("%s: largest gain of a step, of the energy in play" % variant, -np.diff(loss).min() / play, 0.05)
    case.below("%s: gain of all steps, of the energy in play" % variant, -loss.min() / play, 1e-4)
    joints = run.summary["joints"]
    case.true("%s: %d joints failed" % (variant, joints["tensile"] + joints["shear"]), joints["tensile"] > 0)


def gains_nothing_in_the_air(case, variant, run):
    """What moves and strains holds is never more than it has been before; stress is locked in the body."""
    held = sum(run.get("energy/" + name).ravel() for name in ("blocks_kinetic", "blocks_strain", "joints_and_contacts"))
    play = held.max() - held.min()
    case.below("%s: largest gain, of the energy in play" % variant, (held - np.minimum.accumulate(held)).max() / play, 5e-4)
    strain = (run.get("energy/blocks_strain") + run.get("energy/joints_and_contacts")).ravel()[-1]
    case.true("%s: %.2g J/m are locked in strains and joints" % (variant, strain), strain > 10)


def holds_together(case, variant, run):
    joints = run.summary["joints"]
    failed = joints["tensile"] + joints["shear"]
    case.true("%s: %d joints failed" % (variant, failed), failed == 0)
    case.true("%s: it moved" % variant, moved(run) > 0.1)


def needs_no_cut(case, variant, run):
    case.true("%s: %d steps were cut" % (variant, run.summary["cuts"]), run.summary["cuts"] == 0)


CASES = {
    "stiffness_ratio": Wanted({"scene": [], "soft_below": ["Continuum/Materials=mud", "Blocks/Material=granite",
                                                           "Blocks/Belt material=mud"]}, residual=0.001),
    "penalty": Wanted({"40": [], "1.04": ["Blocks/Penalty ratio=1.04"], "40000": ["Blocks/Penalty ratio=40000"]},
                      refusals=[("0.04", ["Blocks/Penalty ratio=0.04"], "Penalty ratio")]),
    "mass_ratio": Wanted({"scene": [], "trapezoidal": ["Time/Scheme=trapezoidal"], "shi": ["Time/Scheme=shi"],
                          "light above": ["Blocks/Material=light", "Blocks/Saturated material=heavy"]},
                         more=heavy_block_is_not_thrown),
    "tips": Wanted({"scene": [], "4 ms": ["Time/Time step=0.004"], "friction": ["Materials/rock/Friction angle=30"],
                    "equilibrium": ["Gravity/Static stage=equilibrium"]}, more=pushes_or_rides),
    "slivers": Wanted({"scene": [], "2 ms": ["Time/Time step=0.002"]}),
    "impact_50": Wanted({"scene": [], "shi": ["Time/Scheme=shi"], "0.1 ms": ["Time/Time step=0.0001"]},
                        more=rebound_is_slower),
    "large_step": Wanted({"20 ms": [], "2 ms": ["Time/Time step=0.002", "Time/End time=1"]}),
    "all_joints_fail": Wanted({"scene": [], "thrown": ["Blocks/Initial velocities=mass: -5, 5, -5, 9, 0, 2, 1.5", "Time/End time=0.8"]},
                              more=most_joints_fail, full_size={
        "6 x 8": ["Mesh/Numbers=Width = 6; Height = 8; Base beyond = 40; Resolution/h = 1"]}),
    "hinge": Wanted(residual=0.001, more=gapes),
    "crushed": Wanted(residual=0.001, penetration=0.05, more=falls_apart),
    "dead_load": Wanted({"scene": [], "trapezoidal": ["Time/Scheme=trapezoidal"]}, residual=0.001, penetration=0.05, more=falls_apart,
                        full_speed=128.0, full_penetration=0.08,  # corners hit the base as much faster: 5 % x 128 / 81
                        full_size={"10 x 20": [
                            "Mesh/Numbers=Width = 10; Height = 20; Base beyond = 150; Resolution/h = 1", "Time/End time=2",
                            "Edge loads/Tractions=top: -100, 100, 19.99, 20.01, 0, -450e3",
                            "Gravity/Static stage=equilibrium or move"]}),
    "bin": Wanted(more=lies_in_the_bin, full_speed=55.0, full_size={
        "1000": ["Mesh/Polygons file=%s" % (HARD / "bin_1000.csv"), "Mesh/Surface file=%s" % (HARD / "bin_1000_surface.csv"),
                 "Time/End time=8"]}),
    "majiagou_1g": Wanted(more=falls_apart, full_size={
        "h = 2 m, 2 ms": ["Mesh/Numbers=Resolution/h = 2", "Time/End time=10", "Motion/Duration=12", "Time/Time step=0.002"],
        "h = 4 m, 2 ms": ["Mesh/Numbers=Resolution/h = 4", "Time/End time=10", "Motion/Duration=12", "Time/Time step=0.002"]}),
    "wedge": Wanted(),
    "poisson_0499": Wanted(residual=0.001, refusals=[("40", ["Blocks/Penalty ratio=40"], "times as large would do")]),
    "quiet": Wanted(residual=0.001, full_size={"scene": ["Time/End time=1000"]}, more=rests(1e-6)),
    "base_end": Wanted({"scene": [], "right end": ["Mesh/Surface file=" + str(HARD / "ends_right.csv")],
                        "left end": ["Mesh/Surface file=" + str(HARD / "ends_left.csv"), "Mesh/Polygons file=" + str(HARD / "slab_at_left_end.csv"),
                                     "Blocks/Initial velocities=slab: -2, 4, 0, 1, -2.5, 0, 0"],
                        "square": ["Mesh/Surface file=" + str(HARD / "ends_right.csv"), "Mesh/Polygons file=" + str(HARD / "tilted_at_end.csv"),
                                   "Blocks/Initial velocities="]}, more=tips_over_the_end),
    "leaves_model": Wanted(more=falls_freely),
    "coincident": Wanted(),
    "record_offset": Wanted(more=ends_at_rest),
    "unit_squares": Wanted({"%s, %g ms" % (name, dt): ["Mesh/Numbers=" + numbers, "Time/Time step=%g" % (dt * 1e-3)]
                            for name, numbers in (("1", "Angle = 20"), ("1x2", "Angle = 20; Rows = 2"))
                            for dt in (0.1, 1, 2)}, residual=0.001, more=rests(1e-6)),
    "second_block": Wanted({"scene": [], "alone": ["Mesh/Polygons file=" + str(HARD / "sliding_alone.csv")]}, more=same_as_alone),
    "ledge": Wanted({"scene": [], "4 ms": ["Time/Time step=0.004"],
                     "bench": ["Mesh/Polygons file=" + str(HARD / "plane_and_bench.csv"), "Materials/joint/Friction angle=25",
                               "Gravity/Horizontal coefficient=0", "Time/End time=2.5"]}, more=moved_until_it_touched),
    "shatter": Wanted({"scene": [], "2 ms": ["Time/Time step=0.002"], "4 ms": ["Time/Time step=0.004", "Materials/rock/Young modulus=5e9"],
                       "strong": ["Materials/rock/Tensile strength=5e6", "Materials/rock/Cohesion=5e6"],
                       "pair": ["Mesh/Polygons file=" + str(HARD / "two_squares.csv"), "Gravity/Acceleration=0",
                                "Blocks/Initial velocities=first: 0, 1, 0, 1, 1, 0, 0", "Time/Time step=0.002", "Time/End time=0.1",
                                "Time/Scheme=dissipative"]},
                      more=gives_nothing_back),
    "cracked_spin": Wanted(more=gains_nothing_in_the_air),
    "turning_bonds": Wanted({"scene": [], "1 MPa": ["Materials/rock/Tensile strength=1e6", "Materials/rock/Cohesion=2e6"],
                             "8 ms": ["Materials/rock/Tensile strength=1e6", "Blocks/Fracture energy=100", "Time/Time step=0.008"],
                             "spin": ["Mesh/Polygons file=" + str(HARD / "two_squares.csv"), "Mesh/Surface file=" + str(HARD / "far_base.csv"),
                                      "Gravity/Acceleration=0", "Blocks/Initial velocities=pair: -9, 9, -9, 9, 0, 0, 2",
                                      "Materials/rock/Tensile strength=1.5e6"]},
                            more=holds_together),
    "stairs": Wanted({"scene": [], "mud": ["Blocks/Material=mud"], "dropped": ["Gravity/Static stage=none"]},
                     residual=0.001, more=stands_on_its_tread),
    "pebble": Wanted({"scene": [], "8 ms": ["Time/Time step=0.008"],
                      "presses": ["Mesh/Polygons file=" + str(HARD / "square_and_grain.csv"), "Time/Time step=0.0002"],
                      "soft": ["Mesh/Polygons file=" + str(HARD / "soft_square_and_pebble.csv"), "Materials/rock/Young modulus=1e7",
                               "Gravity/Static stage=equilibrium", "Time/End time=1"],
                      "row": ["Mesh/Polygons file=" + str(HARD / "slab_on_row.csv"), "Materials/rock/Friction angle=20", "Gravity/Static stage=held",
                              "Blocks/Initial velocities=slab: 0, 5, 1.3, 3, 6, 0, 0", "Time/End time=1.5", "Time/Time step=0.0005"],
                      "meets": ["Mesh/Polygons file=" + str(HARD / "square_meets_pebbles.csv"), "Mesh/Surface file=" + str(HARD / "far_base.csv"),
                                "Gravity/Acceleration=0", "Blocks/Initial velocities=square: -20, 0, -10, 10, 20, 0, 0",
                                "Time/Time step=0.008", "Time/End time=0.32"]}, more=lands_or_pushes),
    "light_and_heavy_far": Wanted({"scene": [], "alone": ["Mesh/Polygons file=" + str(HARD / "pebble_alone.csv")],
                                   "slope": ["Mesh/Polygons file=" + str(HARD / "pebble_on_slope.csv"), "Motion/Type=none", "Time/End time=1",
                                             "Mesh/Surface file=" + str(HARD / "level_and_slope.csv"), "Gravity/Static stage=equilibrium or move"]},
                                  more=light_as_alone),
    "soft_base": Wanted(residual=0.001),
    "friction_10": Wanted(),
    "slope_blocks": Wanted(full_speed=1.7, full_size={"600": ["Mesh/Numbers=Angle = 20; Columns = 120; Rows = 5; Base above = 150"]},
                           more=slides_uncut),
    "tiny_block": Wanted(residual=0.001, more=slides_uncut),
    "stiff_slab": Wanted({"%s GPa" % modulus: ["Materials/rock/Young modulus=%se9" % modulus] for modulus in ("50", "5", "0.5")},
                         residual=0.001, more=needs_no_cut),
    "wall": Wanted(residual=0.001, more=rests(1e-6), full_size={
        "50x40": ["Mesh/Numbers=Columns = 50; Rows = 40; Block width = 2; Base above = 150", "Time/End time=5"]}),
    "column_50": Wanted(residual=0.001, more=rests(1e-6)),
}
