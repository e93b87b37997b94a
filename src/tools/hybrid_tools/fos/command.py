# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos SCENE: factor of safety by strength reduction, yield acceleration, and displacements by Newmark's method.

Each trial is a static stage with the scene's own program, model and strengths, divided by a factor; it fails if it finds no equilibrium.
"""

import json
import os

import numpy as np

from hybrid_run import UserError
from hybrid_tools import style
from hybrid_tools.arguments import Arguments
from hybrid_tools.fos import figure, flanks, sliding
from hybrid_tools.fos.kinks import holding_kink, kink_of_blocks
from hybrid_tools.fos.other_equilibrium import warn_of_other_equilibrium
from hybrid_tools.fos.search import FailsAtLowerEnd, factor_of_safety, yield_coefficient
from hybrid_tools.fos.trial import Trials
from hybrid_tools.fos.water import Water
from hybrid_tools.results_place import default_directory, refuse_other_scene
from hybrid_tools.study import program

FACTOR = "Materials/Strength reduction factor"
JUMP = 3.0  # of the largest displacement between the trial that stands and the one that fails, at least
APART = 0.1  # of the largest motion: blocks of the mass slide on each other
COEFFICIENT = "Gravity/Horizontal coefficient"
EXAMPLES = """  hybrid fos my.prm                      # factor of safety
  hybrid fos my.prm -s "Gravity/Horizontal coefficient=-0.1"     # the same, pseudo-static
  hybrid fos my.prm --time 20            # with the level that Water/Level file has at 20 s
  hybrid fos my.prm --yield              # horizontal coefficient at which it fails
  hybrid fos output/slope --newmark      # displacements of that run's motion by simpler methods
"""


def read_words(words):
    arguments = Arguments("fos", "Factor of safety by strength reduction: cohesion, tensile strength and tan(friction angle)\n"
                          "of all materials and bedding planes are divided by a factor until no equilibrium is found.", EXAMPLES)
    arguments.add_argument("scene", metavar="SCENE", help="parameter file, or output directory of a run")
    arguments.add_argument("-s", dest="overrides", metavar='"Section/Name=value"', action="append", default=[],
                           help="override one parameter")
    arguments.add_argument("--yield", dest="coefficient", action="store_true",
                           help="yield acceleration: the horizontal coefficient, pushing downhill, at which the slope fails")
    arguments.add_argument("--newmark", action="store_true",
                           help="of a run's directory: yield acceleration, then Newmark's rigid block and the decoupled displacement")
    arguments.add_argument("--time", type=float, help="time of the level of the water, where Water/Level file moves it [s] (default: 0)")
    arguments.add_argument("--tolerance", type=float, default=0.005,
                           help="width of the bracket over the factor; a tenth of it for the coefficient (default 0.005)")
    arguments.add_argument("--range", nargs=2, type=float, metavar=("LOW", "HIGH"), help="factors (coefficients) between which to look")
    arguments.add_argument("--output", metavar="DIR", help="where results go (default: output/SCENE_fos)")
    arguments.add_argument("--force", action="store_true", help="replace results of another scene in that directory")
    found = arguments.read(words)
    if not 1e-6 <= found.tolerance < 0.5:
        raise UserError("--tolerance is %g: between 1e-6 and 0.5 is allowed" % found.tolerance)
    if found.time is not None and not 0 <= found.time <= 1e9:
        raise UserError("--time is %g: 0 to 1e9 s are allowed" % found.time)
    if found.range and not 0 < found.range[0] < found.range[1]:
        raise UserError("--range is %g %g: two rising factors above 0 are allowed" % tuple(found.range))
    return found


def scene_of(words):
    """(parameter file, where results go)."""
    if os.path.isdir(words.scene):
        file = os.path.join(words.scene, "params.used.prm")
        if not os.path.exists(file):
            raise UserError("'%s' holds no params.used.prm; give a parameter file or the output directory of a run" % words.scene)
        return file, words.output or os.path.normpath(words.scene) + "_fos"
    if words.newmark:
        raise UserError("--newmark needs the output directory of a run, not '%s': its motion and its slip are compared" % words.scene)
    if not os.path.exists(words.scene):
        raise UserError("'%s' is no parameter file and no output directory of a run" % words.scene)
    return words.scene, words.output or default_directory(words.scene, "_fos")


def find_factor(trials, words):
    low, high = words.range or (None, None)
    return factor_of_safety(lambda factor: trials("factor_%.6g" % factor, factor, {FACTOR: factor}), words.tolerance, low, high)


def find_yield(trials, words):
    """Downhill; where nothing says which way that is, or slides face each other, both ways, and the smaller one counts."""
    at_rest = trials("ky_0", 0.0, {COEFFICIENT: 0.0})
    if at_rest.is_planes_alone:
        raise UserError("a scene without blocks has no sliding mass to push: of its bedding planes hybrid fos tells the factor of safety")
    run = at_rest.run()

    def pushed(sign):
        def judge(k):
            name = "ky_%.6g" % k if sign == run.downhill else "ky_back_%.6g" % k
            return at_rest if k == 0 else trials(name, k, {COEFFICIENT: sign * k})

        bracket = yield_coefficient(judge, 0.1 * words.tolerance, *(words.range or ()))
        bracket.towards = sign
        return bracket

    if not run.is_level:
        return pushed(run.downhill)
    found, back, n_there = either(pushed, run.downhill, trials)
    ways = ["%s towards %s" % ("it stands" if bracket is None else "it fails at %.4f" % bracket.value, flanks.name_of(sign))
            for bracket, sign in ((found, 1), (back, -1))]
    why = "slides lie on both flanks" if run.is_on_both_flanks else "the surface is level"
    print("%s: pushed both ways, %s and %s; the smaller coefficient counts" % (why, *ways))
    is_back = found is None or (back is not None and back.value < found.value)
    trials.done = trials.done[:1] + trials.done[n_there:] if is_back else trials.done[:n_there]
    chosen, other = (back, found) if is_back else (found, back)
    chosen.other_way = other and other.value
    return chosen


def either(pushed, sign, trials):
    """(bracket one way, bracket the other way, number of trials before the latter); None: it stands however hard it is pushed."""
    brackets = []
    for way in (sign, -sign):
        n_before = len(trials.done)
        try:
            brackets.append(pushed(way))
        except FailsAtLowerEnd:
            raise
        except UserError:
            if way != sign and brackets[0] is None:
                raise
            brackets.append(None)
    return brackets[0], brackets[1], n_before


def changes_of(name, bracket, value):
    """{parameter: value} of a trial beside the bracket's."""
    return {FACTOR: value} if name == "fos" else {COEFFICIENT: bracket.towards * value}


def table_of(trials):
    return [{"value": t.value, "stands": t.stands, "planes_hold": t.planes_hold, "largest_displacement_m": t.displacement,
             "residual": t.residual, "iterations": t.iterations} for t in sorted(trials.done, key=lambda t: t.value)]


def write_results(directory, name, results, trials):
    rows = table_of(trials)
    with open(os.path.join(directory, name + ".json"), "w", encoding="utf-8") as file:
        json.dump(dict(results, trials=rows), file, indent=2)
        file.write("\n")
    with open(os.path.join(directory, name + ".csv"), "w", encoding="utf-8") as file:
        file.write(",".join(rows[0]) + "\n")
        for row in rows:
            file.write(",".join("%.9g" % value for value in row.values()) + "\n")


def tell_bracket(label, bracket):
    way = "" if bracket.towards is None else ", pushed towards " + flanks.name_of(bracket.towards)
    print("%s %.4f  (stands at %.4f, fails at %.4f%s)" % (label, bracket.value, bracket.stands.value, bracket.fails.value, way))


def is_bonded(bracket):
    return bracket.fails.run().parameters.get("Model/Blocks") == "bonded"


def warn_of_edges(bracket, results):
    """A bonded mass that shears through itself does so along the edges that its mesh happens to have; loose blocks have joints there."""
    results["parting_within_mass"] = part = figure.parting(bracket)
    results["blocks_yield"] = figure.plastic_strain(bracket) is not None
    if part > APART and not results["blocks_yield"] and is_bonded(bracket):
        print("warning: the mass fails through itself, along the edges of its blocks (they part by %.0f %% of the largest motion):\n"
              "  this is too strong, for a homogeneous slope by a fifth to a third; give it a sliding surface (one that bends less, if it\n"
              "  has one), or let its blocks yield (Blocks/Yielding=true)" % (100 * part))


def resting(run, polygons, towards):
    """The blocks of the mass that may slide towards this sign of x."""
    if not run.is_on_both_flanks:
        return polygons
    return [polygons[k] for k in sorted({block for block, _ in flanks.sole_edges(run, flanks.falls(run, towards))})]


def warn_of_kink(bracket, results):
    """Loose blocks are rigid where they meet a kink; a bonded mass that fails through itself is warned of by its edges. A block whose outline
    has the kink holds bonded ones as well."""
    run = bracket.stands.run()
    points, _, offsets = figure.moved(bracket.stands)
    polygons = np.split(points, offsets[1:-1])[run.blocks.mass]
    ways = (1.0, -1.0) if run.is_on_both_flanks and bracket.towards is None else (bracket.towards or run.downhill,)
    on_surface = [] if is_bonded(bracket) or not run.has("section/surface") else [
        holding_kink(line, resting(run, polygons, towards), towards) for line in run.surface for towards in ways]
    found = [("the sliding surface", kink) for kink in on_surface] + [("the outline of a block", kink_of_blocks(polygons, way)) for way in (1, -1)]
    found = [(what, kink) for what, kink in found if kink]
    if found:
        what, ((x, y), bend) = max(found, key=lambda of: of[1][1])
        results["kink"] = {"point_m": [x, y], "bend_degrees": bend}
        print("warning: %s flattens by %.0f degrees in kinks, the sharpest at (%.6g, %.6g) m, where corners of other blocks hold it\n"
              "  whatever its strength: this may be far too strong (4 %% by 3 degrees, twice and more by 40); cut corners in kinks off by a few percent"
              " of the block" % (what, bend, x, y))


def warn_of_no_jump(bracket, trials, results):
    """The static stage gives up where a joint has slipped by a tenth of its length, also if it would come to rest farther on; and a kink
    of the sliding surface may hold what would slide on it.

    A mass of blocks that yield settles more and more before it fails: what it moved where it stood most firmly is compared."""
    stands = bracket.stands.displacement
    if results["blocks_yield"]:
        stands = min(trial.displacement for trial in trials.done if trial.stands)
    results["jump_of_displacement"] = jump = bracket.fails.displacement / max(stands, 1e-300)
    if jump < JUMP and bracket.fails.planes_hold:
        reason = ("a joint slipped by a tenth of its length,\n"
                  "  which may be elastic (stiffer blocks, longer edges) or on a bent surface that locks (shorter edges): vary both")
        if not is_bonded(bracket):
            reason = ("blocks may be locked by a kink of\n"
                      "  the surface that they slide on: cut their corner there, or give the surface shorter edges")
        if any("its foot cannot leave" in warning for warning in trials.warnings):
            reason = "its foot is held by the ground before\n  it (the warning above)"
        print("warning: displacement does not jump at failure (%.3g times as large): %s" % (jump, reason))


def main(words):
    found = read_words(words)
    scene, directory = scene_of(found)
    name = "yield" if found.coefficient or found.newmark else "fos"
    if not found.force:
        refuse_other_scene(directory, name, scene)
    water = Water(program.parameters(scene, found.overrides), found.time)
    os.makedirs(directory, exist_ok=True)
    trials = Trials(scene, found.overrides + water.overrides(), directory, lambda line: print(line, flush=True))
    if water.words():
        print("water    " + water.words(), flush=True)
    style.apply()
    bracket = find_yield(trials, found) if name == "yield" else find_factor(trials, found)
    results = {"scene": os.path.abspath(scene), "overrides": found.overrides,
               name: bracket.value, "stands": bracket.stands.value, "fails": bracket.fails.value, **water.results()}
    if bracket.towards is not None:
        results["towards"] = flanks.name_of(bracket.towards)
    if hasattr(bracket, "other_way"):
        results["other_way"] = bracket.other_way
    tell_bracket("yield coefficient" if name == "yield" else "factor of safety", bracket)
    if bracket.fails.is_planes_alone:
        write_results(directory, name, results, trials)
        print("files    %s: fos.json, fos.csv" % directory)
        return 0
    warn_of_edges(bracket, results)
    warn_of_kink(bracket, results)
    warn_of_no_jump(bracket, trials, results)
    warn_of_other_equilibrium(name, bracket, trials, lambda value: changes_of(name, bracket, value), results)
    write_results(directory, name, results, trials)
    figure.draw(bracket, trials.done, directory, name)
    if found.newmark:
        sliding.compare(found, trials, bracket, directory)
    more = ", newmark.json, newmark.png" if found.newmark else ""
    print("files    %s: %s.json, %s.csv, %s.png%s" % (directory, name, name, name, more))
    return 0
