# SPDX-License-Identifier: GPL-3.0-or-later
"""Collapse of a column of grains beside a wall: how far the heap runs out and how high it stays, beside what others measured and computed.

Run-out (L - L0)/L0 and height H/L0 of the heap over a = H0/L0 (L0 width and H0 height of the column):

    sand, rice, sugar (Lube et al. 2005)     1.2 a  (a < 1.8),           1.9 a^(2/3)  (a > 2.8)
    discs (Staron & Hinch 2005)              2.5 a  (a < 2),             3.25 a^0.7   (a > 2)
    rods (Nguyen et al. 2015)                3.25 a^0.96  (a < 1.5),     3.80 a^0.73  (a > 1.5),    height 0.70 a^(1/3)  (a > 0.65)
    grit and beads in channels (Balmforth & Kerswell 2005)     height a^0.4 to a^0.5

No constant is the program's to meet: they hang on friction and shape. The heap is what is linked with its largest part by gaps below GAP;
grains that roll away by themselves are not of it. The front is known to a grain.
"""

import pathlib
import sys

import grain_packing
import numpy as np
from run_hybrid import Started
from scene_numbers import Numbers
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from vtu_file import picture_at, pictures

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "stability"))
import overlaps  # noqa: E402 (needs the path above)

GAP = 0.34  # m, half a grain (root of its mean area): closer grains are of one heap
GRAIN = 0.85  # m, mean diameter
TABLES = {12.0: "grain_column_flat.csv", 5.0: "grain_column.csv"}  # settled grains beside the scene, by the width between the walls [m]
RATIO = {12.0: 1.0, 5.0: 6.0}  # a of these columns
BELOW_SAND = 0.75  # lowest run-out allowed over that of sand
DURATION = 3.5  # of a run, in times of fall sqrt(2 H0/g)
RESIDUAL, OVERLAP, AT_REST = 1e-3, 0.01, 0.02  # allowed: energy audit, of a grain, kinetic energy of the heap over the peak of all


def sand(a):
    """Run-out of Lube et al. (2005), on a straight line in logarithms between their laws."""
    a = np.asarray(a, float)
    between = np.exp(np.interp(np.log(a), np.log([1.8, 2.8]), np.log([1.2 * 1.8, 1.9 * 2.8 ** (2 / 3)])))
    return np.where(a < 1.8, 1.2 * a, np.where(a > 2.8, 1.9 * a ** (2 / 3), between))


def discs(a):
    """Run-out of Staron & Hinch (2005)."""
    a = np.asarray(a, float)
    return np.where(a < 2, 2.5 * a, 3.25 * a**0.7)


def rods(a):
    """Run-out of Nguyen et al. (2015)."""
    a = np.asarray(a, float)
    return np.where(a < 1.5, 3.25 * a**0.96, 3.80 * a**0.73)


def heights(a):
    """Lowest and highest of the published laws: 0.70 a^(1/3), and a^0.5 as from a = 1; never above the column."""
    a = np.asarray(a, float)
    return np.minimum(a, 0.70 * a ** (1 / 3)), np.minimum(a, a**0.5)


def linked(grains):
    """Which grains belong to the heap: the largest part that gaps below GAP hold together."""
    low, high = np.array([g.min(axis=0) for g in grains]), np.array([g.max(axis=0) for g in grains])
    reach = np.linalg.norm(high - low, axis=1).max() + GAP
    i, j = cKDTree((low + high) / 2).query_pairs(reach, output_type="ndarray").T
    most = max(len(g) for g in grains)
    padded = np.array([np.vstack([g, np.repeat(g[-1:], most - len(g), axis=0)]) for g in grains])
    gap = -np.fmin(overlaps.least_shadow(padded[i], padded[i], padded[j]), overlaps.least_shadow(padded[j], padded[i], padded[j]))
    near = gap < GAP
    links = coo_matrix((np.ones(near.sum()), (i[near], j[near])), shape=(len(grains),) * 2)
    part = connected_components(links, directed=False)[1]
    return part == np.bincount(part).argmax()


class Collapse:
    """What a run says of its column."""

    def __init__(self, run, width, height):
        self.run, self.width, self.height, self.a = run, width, height, height / width
        grains = run.blocks.final_polygons
        heap = [g for g, of_heap in zip(grains, linked(grains)) if of_heap]
        self.count, self.away = len(grains), len(grains) - len(heap)
        self.run_out = max(g[:, 0].max() for g in heap) / width - 1
        self.top = max(g[:, 1].max() for g in heap) / width
        self.fall = np.sqrt(2 * height / Numbers(run).gravity())  # s
        self.moves = self._kinetic() / run.get("energy/blocks_kinetic").max()

    def _kinetic(self):
        """Kinetic energy of the heap in the last picture [J/m], by the mean velocities of the corners."""
        picture = picture_at(self.run.directory, "blocks", 1e9)[0]  # the last one
        grains, velocity = overlaps.polygons(picture), picture.point_fields["velocity [m/s]"]
        speed = np.array([np.linalg.norm(velocity[corners].mean(axis=0)) for corners in picture.cells])
        mass = Numbers(self.run).material("rock").density * np.array([overlaps.area(g) for g in grains])
        return 0.5 * np.sum((mass * speed**2)[linked(grains)])

    def losses(self):
        """Parts of the energy lost that friction and impacts (time integration and damping of shapes) have taken."""
        last = {name: self.run.get("energy/" + name).ravel()[-1] for name in self.run.names("energy")}
        friction, impacts = last["friction_loss"], last["blocks_integration_loss"] + last["blocks_damping_loss"]
        return friction / (friction + impacts), impacts / (friction + impacts)

    def fronts(self):
        """Times over the time of fall, and the front of the heap over the width, less one, in all pictures."""
        found = [(time, overlaps.polygons(picture)) for time, picture in pictures(self.run.directory, "blocks")]
        front = [max(g[:, 0].max() for g, of_heap in zip(grains, linked(grains)) if of_heap) for _, grains in found]
        return np.array([time for time, _ in found]) / self.fall, np.array(front) / self.width - 1

    def arrival(self):
        """Time over the time of fall from which the front is within a grain of where it stays."""
        times, fronts = self.fronts()
        return times[np.flatnonzero(np.abs(fronts - fronts[-1]) > GRAIN / self.width)[-1] + 1]


def collapse(case, name, grains, width, ratio, *settings):
    """Collapse of what lies below ratio * width of the settled grains."""
    height, table, ground = ratio * width, case.work / (name + ".csv"), case.work / (name + "_ground.csv")
    case.work.mkdir(parents=True, exist_ok=True)
    grain_packing.write_grains(table, grain_packing.below(grains, height))
    grain_packing.write_ground(ground, width, height + 4)
    end = DURATION * np.sqrt(2 * height / 9.81)
    run = case.run(name, "Mesh/Polygons file=%s" % table, "Mesh/Surface file=%s" % ground, "Time/End time=%.2f" % end, *settings)
    return Collapse(run, width, height)


def judge(case, name, found, lowest):
    """What is asked of every collapse; lowest: run-out over that of sand."""
    run, most = found.run, max(discs(found.a), rods(found.a))
    case.true("%s: run-out %.2f, sand %.2f, highest published %.2f, a grain is %.2f"
              % (name, found.run_out, sand(found.a), most, GRAIN / found.width), lowest * sand(found.a) <= found.run_out <= most)
    low, high = heights(found.a)
    case.true("%s: height %.2f, published %.2f to %.2f" % (name, found.top, low, high), low - GRAIN / found.width <= found.top <= high + GRAIN / found.width)
    case.below("%s: energy residual" % name, run.summary["energy_residual"], RESIDUAL)
    run.directory_path = pathlib.Path(run.directory)
    depth, when = overlaps.deepest(run)
    case.below("%s: largest overlap, of a grain, at %.3g s" % (name, when), depth, OVERLAP)
    case.below("%s: kinetic energy of the heap at the end over the peak" % name, found.moves, AT_REST)
    print("      %d grains, %d rolled away; friction took %.2f of what was lost, impacts %.2f; the front arrives after %.1f times of fall"
          % (found.count, found.away, *found.losses(), found.arrival()))
    print("      %d steps, %d cuts, %.0f s of processor time" % (run.summary["steps"], run.summary["cuts"], run.summary["processor_time_s"]))


def growth(found, low, high):
    """Power of a with which the run-out grows between two columns."""
    return np.log(found[high] / found[low]) / np.log(high / low)


def check(case):
    """Each column by itself: a heap is one of many that as little as round-off tells apart, so powers of a are asked of means (grain_column_packings.py)."""
    case.program = Started(case.binary)  # a summary has the processor time of its process
    case.found = {}
    for width, a in RATIO.items():
        grains = grain_packing.read_grains(case.scene.with_name(TABLES[width]))
        case.found[a] = collapse(case, "a_%g" % a, grains, width, a)
        judge(case, "a = %g" % a, case.found[a], BELOW_SAND)


def draw(case, figure):
    from matplotlib.collections import PolyCollection

    found, axes = case.found[6.0], figure.subplots()
    all_pictures = list(pictures(found.run.directory, "blocks"))
    for time, origin in ((0.0, (-11.0, 0.0)), (0.7, (0.0, 28.0)), (1.4, (0.0, 13.0)), (DURATION, (0.0, 0.0))):
        at, picture = min(all_pictures, key=lambda e: abs(e[0] / found.fall - time))
        grains = overlaps.polygons(picture)
        axes.add_collection(PolyCollection([g + origin for g in grains], facecolors=np.where(linked(grains), "0.8", "C1"),
                                           edgecolors="0.3", linewidths=0.3))
        end, top = (6, 30) if time == 0 else (60, 12)
        axes.plot(origin[0] + np.array([0, 0, end]), origin[1] + np.array([top, 0, 0]), "k-", linewidth=1)
        axes.text(origin[0] + (0 if time == 0 else 40), origin[1] + (31 if time == 0 else 5), "%.1f s" % at, fontsize=9)
    axes.set(aspect="equal", xlim=(-12, 60), ylim=(-1, 47), xlabel="x [m]", ylabel="y [m]",
             title="a = 6: at first, and after 0.7, 1.4 and %.1f times of fall; coloured: rolled away" % DURATION)
