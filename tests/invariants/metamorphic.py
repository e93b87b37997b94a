# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of scenes that must move alike. Each pair is a function that returns sentences: what differs, with the numbers."""

import numpy as np
from run_scene import run_program, run_scene
from scenes import FACTORS, MASS, Scene, friction_angle
from newmark_block import newmark_slip

ROUND_OFF = 1e-6  # of the largest displacement: what the order of sums and the digits of coordinates may change,
STEP_LATER = 9.81 * 0.001**2  # and what a contact that begins to slide one step later changes [m]
MODELS = 0.02  # bedrocks against each other, and against Newmark's block
PICTURES = "Output/Picture interval=0.05"


def options(**chosen):
    """A scene's options: the first value of each factor but for the chosen ones."""
    return {n: chosen.get(n, values[0]) for n, values in FACTORS.items()}


SLIDING = dict(static="held", friction="slides", motion="outcrop")
CLOSELY = {"Blocks/Tolerance": 1e-12,  # else the pairs differ by what the iteration leaves
           "Output/Energy limit": 0}  # both of a pair are asked whether they are alike; the audit is asked in judge.py
BASES = {
    "loose on rock": options(rock="soft", **SLIDING),
    "loose, nodes beside each other": options(nodes="shifted", ratio=3.0, rock="soft", **SLIDING),
    "bonded, belt": options(blocks="bonded", belt="slides", kind="triangles", water="submerged", base="rigid", **SLIDING),
    "bonded, breaks": options(blocks="bonded", strength="weak", belt="slides", kind="triangles", **SLIDING),
    "large, breaks": options(mass="large", blocks="bonded", strength="weak", belt="slides", kind="triangles", **SLIDING),
    "large, loose": options(mass="large", kind="triangles", rock="soft", **SLIDING),
    "rigid": options(bedrock="rigid", base="rigid", **SLIDING),
    "triangles": options(bedrock="triangles", rock="soft", **SLIDING),
    "layers": options(bedrock="layers", base="rigid", bedding="elastic", **SLIDING),
}


class Pairs:
    """binary, directory of the runs; runs of the same scene are done once."""

    def __init__(self, binary, directory):
        self.binary, self.directory, self.done = binary, directory, {}

    def run(self, name, scene, *overrides):
        if name not in self.done:
            code, said, run = run_scene(self.binary, scene, self.directory / name.replace(" ", "_").replace(",", ""),
                                        *(overrides or (PICTURES,)))
            if code != 0:
                raise RuntimeError("%s ends with code %d: %s" % (name, code, " ".join(said.split())[-300:]))
            self.done[name] = run
        return self.done[name]

    def reference(self, base):
        return self.run(base, scene_of(base))


def scene_of(base, factor=1.0, **changed):
    scene = Scene(dict(BASES[base], **changed), factor=factor)
    scene.further = dict(CLOSELY)
    if scene.options["mass"] == "large":  # sums over more blocks, and coordinates of 10 km, leave 1e-11
        scene.further["Blocks/Tolerance"] = 1e-10
        scene.further["Blocks/Fracture energy"] = 0.0  # a step of bonds that soften may have two solutions; 332 tear
    return scene


def centroids(run):
    """Displacement of each block of the mass from where it was drawn, at the end, by its place [m]; without mirror and shift."""
    blocks = run.blocks_at(-1)[0][: run.n_mass]
    places = np.array([b.mean(axis=0) for b in run.drawn[: run.n_mass]]) - run.scene.shift
    moved = np.array([(now - then).mean(axis=0) for now, then in zip(blocks, run.drawn)])
    sign = [run.scene.mirror, 1.0]
    places, moved = places * sign, moved * sign
    order = np.lexsort(np.round(places, 5).T)
    return places[order], moved[order]


def differ(one, other, tolerance=ROUND_OFF):
    (places, a), (others, b) = centroids(one), centroids(other)
    if np.abs(places - others).max() > 1e-4:
        yield "blocks are drawn elsewhere"
    error, allowed = np.abs(a - b).max(), tolerance * np.abs(a).max() + (STEP_LATER if tolerance else 0.0)
    if error > allowed:
        yield "displacements of up to %.4g m differ by %.3g m; allowed %.2g m" % (np.abs(a).max(), error, allowed)


def mirrored(pairs, base):
    return differ(pairs.reference(base), pairs.run(base + " mirrored", scene_of(base).mirrored()))


def shifted(pairs, base):
    """By 10 km: coordinates lose four digits."""
    return differ(pairs.reference(base), pairs.run(base + " shifted", scene_of(base).shifted((10e3, 1e3))))


def renumbered(pairs, base):
    return differ(pairs.reference(base), pairs.run(base + " renumbered", scene_of(base).renumbered(7)))


def heavier(pairs, base):
    """Density, moduli, strengths and fracture energy all times 1000."""
    return differ(pairs.reference(base), pairs.run(base + " heavier", scene_of(base, factor=1000.0)))


def threads(pairs, base):
    return differ(pairs.reference(base), pairs.run(base + " threads", scene_of(base, threads=2)), 0.0)


def solved_otherwise(pairs, base):
    """The bedrock with a band of the surface's stiffness, and without a matrix."""
    for solver in FACTORS["rock solver"][1:]:
        yield from differ(pairs.reference(base), pairs.run("%s by %s" % (base, solver), scene_of(base, **{"rock solver": solver})))


def in_two_halves(pairs, base):
    """Stopped at half the time and resumed: the same bits."""
    scene = scene_of(base)
    half = pairs.run(base + " halves", scene, PICTURES, "Time/End time=%g" % (scene.end_time / 2), "Checkpoint/Step interval=1000000")
    half.data.file.close()
    code, said = run_program(pairs.binary, ["--resume", half.directory, "-s", "Time/End time=%g" % scene.end_time])
    if code != 0:
        return ["resuming ends with code %d: %s" % (code, said[-300:])]
    return differ(pairs.reference(base), type(half)(scene, half.directory), 0.0)


RELATIONS = (mirrored, shifted, renumbered, heavier, threads, solved_otherwise, in_two_halves)
OF_SIZE = (mirrored, renumbered, threads, in_two_halves)  # every day of a large mass, too: what the number of blocks may change


def slab(bedrock, **chosen):
    """One slab on a stiff slope that holds at rest and slides in the earthquake."""
    layers = bedrock == "layers"
    scene = Scene(options(bedrock=bedrock, base="rigid", bedding="elastic" if layers else "off", static="held",
                          **dict({"motion": "outcrop"}, **chosen)))
    scene.end_time = 1.2
    scene.further = {"Motion/Peak": 4.0 if chosen.get("motion") == "incident" else 8.0, "Motion/Frequency": 2.5,
                     "Materials/mass/Young modulus": 2e9, "Materials/rock/Young modulus": 1e12}
    if layers:
        scene.further.update({"Bedding planes/Normal stiffness": 1e13, "Bedding planes/Shear stiffness": 1e13})
    return scene


def models_agree(pairs, **chosen):
    """Rigid against stiff finite elements, triangles and layers, and against Newmark's block."""
    slips = {}
    for bedrock in FACTORS["bedrock"]:
        name = "slab on %s %s" % (bedrock, " ".join(map(str, chosen.values())))
        run = pairs.run(name.strip(), slab(bedrock, **chosen), PICTURES)
        slips[bedrock] = run.slip()
        if bedrock == "rigid":
            along, ground = run.along(), run.data.get("input/displacement")  # of the outcrop
            slips["Newmark's block"] = newmark_slip(
                run.time, ground @ along, ground @ [-along[1], along[0]], np.radians(run.options["angle"]),
                np.radians(friction_angle(run.options)), 9.81)
    expected = slips["Newmark's block"]
    for name, slip in slips.items():
        if abs(slip - expected) > MODELS * abs(expected):
            yield "on %s the slab slips %.5g m, Newmark's block %.5g m" % (name, slip, expected)


def bonded_as_loose(pairs, bedrock):
    """A bonded mass that cannot fail moves as a loose one that does not slide: both follow the ground."""
    shared = dict(bedrock=bedrock, base="rigid", motion="outcrop", friction="holds", static="held", angle=10.0,
                  bedding="elastic" if bedrock == "layers" else "off")
    weak = "Motion/Peak=1"  # m/s2: nothing slides
    loose = pairs.run("loose on %s" % bedrock, Scene(options(**shared)), PICTURES, weak)
    bonded = pairs.run("bonded on %s" % bedrock, Scene(options(blocks="bonded", belt="never fails", **shared)), PICTURES, weak)
    peak = max(np.abs(u).max() for u in (loose.ground_history(), bonded.ground_history()))
    (_, a), (_, b) = centroids(loose), centroids(bonded)
    limit = MODELS * peak + 2e-5 * MASS["density"] * 9.81 * 2 / 4e4  # and what elastic springs differ by
    if np.abs(a - b).max() > limit:
        yield "bonded and loose blocks differ by %.3g m, allowed %.3g m of %.3g m" % (np.abs(a - b).max(), limit, peak)


SLABS = ({}, {"motion": "incident"}, {"blocks": "bonded"}, {"blocks": "bonded", "kind": "triangles", "damping": "blocks"},
         {"blocks": "bonded", "belt": "slides", "kind": "triangles", "damping": "blocks"}, {"nodes": "own", "ratio": 3.0, "kind": "plate"},
         {"nodes": "shifted", "ratio": 3.0})
SHORT = ("loose on rock", "bonded, belt", "large, breaks", "triangles")


def relations(everything):
    """(name, function of Pairs) of all pairs, or of those for every day."""
    for chosen in SLABS if everything else SLABS[:2] + SLABS[3:4]:
        yield "models agree %s" % " ".join(map(str, chosen.values())), lambda pairs, c=chosen: models_agree(pairs, **c)
    for bedrock in FACTORS["bedrock"][:None if everything else 2]:
        yield "bonded as loose on %s" % bedrock, lambda pairs, b=bedrock: bonded_as_loose(pairs, b)
    for base in BASES if everything else SHORT:
        for relation in RELATIONS:
            if relation is solved_otherwise and BASES[base]["bedrock"] != "continuum":
                continue
            if not everything and BASES[base]["mass"] == "large" and relation not in OF_SIZE:
                continue
            yield "%s: %s" % (base, relation.__name__), lambda pairs, r=relation, b=base: r(pairs, b)
