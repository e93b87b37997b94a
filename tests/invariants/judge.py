# SPDX-License-Identifier: GPL-3.0-or-later
"""What must hold in any scene. Each invariant is a function that returns sentences: what is wrong, with the numbers."""

import numpy as np
import overlap
from newmark_block import newmark_slip
from scenes import GRAVITY, MASS, PENALTY, WATER, friction_angle, rock_young

OVERLAP = 0.01  # of a block
IMBALANCE = 0.01  # of the energies in play
MOMENTUM = 1e-5, 3e-3  # of what the weight gives in the whole run: contacts alone; with joints, whose weights are the scheme's
MARGIN = 4.0  # of the elastic settlement over that of a column
CREEP = 0.05  # of the elastic settlement: what is at rest stays where it is
SLIP = 0.02  # of Newmark's block
SPREADS = 0.1  # loose triangles spread while they slide, so that some slide less and some more
ON_LINES = 1.0  # how much farther: what lies on hypotenuses in one line slides on them, too
SCHEME = ("blocks_integration_loss", "bedrock_integration_loss", "spring_replacement_loss")


def judge(run):
    """Sentences about everything that is wrong with a finished run."""
    found = []
    for invariant in (finishes, stays_finite, does_not_overlap, stands, slides_as_newmark, energy_closes, momentum_balances):
        found += ["%s: %s" % (invariant.__name__, sentence) for sentence in invariant(run)]
    return found


def finishes(run):
    if not run.data.summary.get("finished"):
        yield "the run did not finish"


def stays_finite(run):
    names = []
    run.data.file.visititems(lambda name, item: names.append(name) if getattr(item, "dtype", np.dtype("S1")).kind == "f"
                             and name != "joints/failure_time" and not np.isfinite(item[()]).all() else None)
    if names:
        yield "not finite: " + ", ".join(names)


def does_not_overlap(run):
    """Neither blocks nor corners of the ground in each other by more than 1 % of a block, in any picture."""
    worst = (0.0, "")
    for time, frame in run.frames(21):
        blocks, _ = run.blocks_at(frame)
        depth, i, j = overlap.between(blocks[: run.n_mass], blocks[run.n_mass :])
        what = "blocks %d and %d" % (i, j) if j < run.n_mass else "block %d and block %d of the bedrock" % (i, j)
        worst = max(worst, (depth, "%s at %.3g s" % (what, time)))
        if run.has_continuum or run.options["bedrock"] == "rigid":
            line = run.surface + run.surface_moved(time)
            depth, i, j = overlap.into_ground(blocks[: run.n_mass], line)
            what = "block %d is below the surface" if j == -1 else "the surface is inside block %d"
            worst = max(worst, (depth, "%s at %.3g s" % (what % i, time)))
    if worst[0] > OVERLAP:
        yield "%.3g %% of a block: %s" % (100 * worst[0], worst[1])


def elastic_settlement(run):
    """More than an elastic mass on its penalty springs settles under its weight [m]."""
    height = run.scene.geometry["rows"] * run.scene.geometry["height"]
    pressure = MASS["density"] * GRAVITY * height
    size = max(run.scene.geometry["width"], run.scene.geometry["height"])
    return MARGIN * pressure * (height + 2 * run.scene.geometry["rows"] * size / PENALTY) / MASS["young"]


def elastic_bedrock(run):
    """More than the bedrock gives way under the weight of the mass [m]."""
    return 0.0 if run.options["bedrock"] == "rigid" else elastic_settlement(run) * MASS["young"] / rock_young(run.options)


def can_stand(run):
    return run.options["friction"] == "holds" and (run.options["blocks"] == "loose" or run.options["strength"] == "strong"
                                                   or run.options["angle"] == 0)


def stands(run):
    """What can stand stands where it was drawn, and stays there unless it is shaken."""
    if not can_stand(run):
        return
    limit = elastic_settlement(run)
    if run.options["static"] != "none":
        first = run.blocks_at(0)[0]
        moved = max(np.linalg.norm(now - then, axis=1).max() for now, then in zip(first[: run.n_mass], run.drawn))
        if moved > limit:
            yield "a block is %.3g m from where it was drawn after the static stage, elastic %.3g m" % (moved, limit)
        limit *= CREEP
    else:
        limit += elastic_bedrock(run)
    if run.options["motion"] == "none":
        slip = run.slip()
        if abs(slip) > limit:
            yield "slips %.3g m at rest, allowed %.3g m" % (slip, limit)


def slides_as_newmark(run):
    """A body that slides or would slide moves as Newmark's block on the ground as it moves."""
    o = run.options
    whole = o["blocks"] == "loose" or o["strength"] == "strong"
    follows = o["belt"] != "never fails" and not (rock_young(o) < 1e8 and (o["motion"] != "none" or o["static"] == "none"))
    rocks = o["kind"] == "columns" and o["motion"] != "none"
    if not whole or not follows or rocks or o["surface"] != "plane" or (o["friction"] == "holds" and o["motion"] == "none"):
        return
    buoyancy = WATER / MASS["density"] if o["water"] != "none" else 0.0
    moved = run.ground_history()
    expected = newmark_slip(run.time, moved @ run.along(), moved @ normal(run), np.radians(o["angle"]),
                            np.radians(friction_angle(o)), GRAVITY * (1 - buoyancy), o["belt rate"])
    found = run.slip()
    less, more = (SPREADS, ON_LINES) if o["kind"] == "triangles" and o["blocks"] == "loose" else (SLIP, SLIP)
    beyond = (found - expected) * np.sign(expected)  # how much farther it slid
    give = elastic_settlement(run) + elastic_bedrock(run)
    if not -less * abs(expected) - give <= beyond <= more * abs(expected) + give:
        yield "slip %.4g m, Newmark's block %.4g m" % (found, expected)


def normal(run):
    along = run.along()
    return np.array([-along[1], along[0]]) * run.scene.mirror


def energy_closes(run):
    """The audit closes, and the scheme gives no energy that physics does not."""
    energy = run.data.file["energy"]
    terms = {n: energy[n][:] for n in energy if n not in ("time", "residual")}
    stored = sum(energy[n].attrs["start"][0] for n in ("blocks_strain", "joints_and_contacts"))
    floor = max(stored, 0.5 * abs(run.weight()[1]) * elastic_settlement(run) / MARGIN)  # what the mass stores at rest
    physical = sum(np.abs(v) for n, v in terms.items() if n not in SCHEME)
    in_play = np.maximum.accumulate(np.maximum(physical, floor))
    imbalance = np.abs(sum(terms.values())) / in_play
    if imbalance.max() > IMBALANCE:
        yield "imbalance %.3g %% of the energies in play (%.3g J/m) at %.3g s" % worst_of(imbalance, in_play, energy["time"])
    for name in SCHEME:
        if name in terms:
            gained = -terms[name] / in_play
            if gained.max() > IMBALANCE:
                yield "%s creates %.3g %% of the energies in play (%.3g J/m) at %.3g s" % (
                    (name,) + worst_of(gained, in_play, energy["time"]))


def worst_of(ratio, in_play, time):
    k = int(np.argmax(ratio))
    return 100 * ratio[k], in_play[k], time[k]


def momentum_balances(run):
    """Momentum of the mass is the impulse of its weight, the water and what the bedrock feels, with the other sign."""
    if run.options["bedrock"] not in ("continuum", "rigid"):
        return  # a bedrock of blocks does not tell what the mass does to it
    change = run.momentum(len(run.block_frames) - 1) - run.momentum(0)
    weight = run.weight() * run.time[-1]
    errors = [np.abs(change - weight + impulse).max() for impulse in run.interface_impulses()]
    if min(errors) > MOMENTUM[run.options["belt"] in ("slides", "never fails")] * abs(weight[1]):
        yield "%.3g %% of the weight's impulse is missing (%.3g of %.3g N s/m)" % (
            100 * min(errors) / abs(weight[1]), min(errors), abs(weight[1]))
