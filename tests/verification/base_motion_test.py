#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every base moves with the ground motion that the scene gives, whether that is an outcrop's or the incident wave.

A section of stiff rock (20 m, 3 km/s), its top a bonded mass, is shaken at 2 Hz: it is so short beside the wave that all of
it moves like an outcrop, within 1/cos(2 pi f H/c_s) - 1 = 0.4 %, on any base. So all models have to agree with each other and
with the motion, monitors on the base have to have its velocity and acceleration, and `incident` has to double everything.
A record with a vertical component moves all by the sum of what both do alone. Where the base moves as prescribed it gives the rock its kinetic
energy, and the time integration next to none: neither gives nor takes.

Usage: base_motion_test.py HYBRID_BINARY SOURCE_DIR WORK_DIR
"""
import pathlib
import shutil
import sys

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from run_hybrid import run_hybrid  # noqa: E402 (needs the path above)

SCENE = """
set Title = %(title)s
subsection Time
  set End time  = 1.2
  set Time step = 0.001
end
subsection Mesh
  set File    = %(mesh)s
  set Numbers = Width = 20; Resolution/h = 5
end
subsection Model
  set Bedrock = %(bedrock)s
  set Blocks  = %(blocks)s
end
subsection Materials
  set Names = rock
  subsection rock
    set Density          = 2500
    set Young modulus    = 60e9
    set Poisson ratio    = 0.25
    set Friction angle   = 45
    set Cohesion         = 1e12
    set Tensile strength = 1e12
  end
end
subsection Continuum
  set Materials = rock
  set Base      = %(base)s
  set Sides     = %(sides)s
end
subsection Bedding planes
  set Names            = bedding_1
  set Normal stiffness = 1e13
  set Shear stiffness  = 1e13
end
subsection Blocks
  set Material      = rock
  set Belt material = rock
end
subsection Gravity
  set Acceleration = 0
end
subsection Motion
  set Type      = ricker
  set Frequency = 2
  set Peak      = 1
  set Meaning   = %(meaning)s
end
subsection Monitors
  set Points = base: 10, 0; mass: 10.3, 17.2
end
subsection Output
  set Picture interval = 0
end
"""

# bedrock, base, sides; and what the base monitor is: prescribed (the outcrop's motion itself) or free to answer
MODELS = {
    "continuum, compliant": ("continuum", "compliant", "free field"),
    "continuum, rigid": ("continuum", "rigid", "free field"),
    "triangles, compliant": ("triangles", "compliant", "free field"),
    "triangles, rigid": ("triangles", "rigid", "free field"),
    "layers": ("layers", "compliant", "viscous"),
    "rigid": ("rigid", "compliant", "viscous"),
}
# where nothing but the base does work
LED = ("continuum, rigid", "triangles, rigid", "rigid")
QUANTITIES = ("displacement", "velocity", "acceleration")


def run(binary, source, work, model, meaning, *overrides, name=""):
    """Directory of the run."""
    bedrock, base, sides = MODELS[model]
    directory = work / (model.replace(", ", "_") + "_" + (name or meaning))
    scene = directory.with_suffix(".prm")
    # each layer has to be one surface of the mesh: the upper two of three are the blocks then
    mesh, blocks = ("layers.geo", "none") if bedrock == "layers" else ("blocks_on_layers.geo", "bonded")
    scene.write_text(SCENE % {"title": model + ", " + meaning, "mesh": source / "meshes" / mesh,
                              "blocks": blocks, "bedrock": bedrock, "base": base, "sides": sides, "meaning": meaning})
    code, output, errors, command = run_hybrid(binary, scene, directory, overrides)
    if code != 0:
        sys.exit("%s\nexit code %d\n%s%s" % (command, code, output, errors))
    return directory


def peaks_of(directory):
    """{(place, quantity): largest |x component|} of the base, the mass and the outcrop's motion as recorded."""
    peaks = {}
    with h5py.File(directory / "run.h5", "r") as file:
        for place in ("base", "mass", "input"):
            group = file["input" if place == "input" else "monitors/" + place]
            for quantity in QUANTITIES:
                peaks[place, quantity] = numpy.abs(group[quantity][:, 0]).max()
    return peaks


def integration_part(directory):
    """Largest energy that the time integration has taken or given, over the largest kinetic energy."""
    with h5py.File(directory / "run.h5", "r") as file:
        energy = file["energy"]
        kinetic, loss = (sum(energy[name][:] for name in energy if name.endswith(end)) for end in ("kinetic", "integration_loss"))
    return numpy.abs(loss).max() / kinetic.max()


def write_pulse(path, frequency, peak):
    t = numpy.arange(0, 0.8, 0.005)
    x = (numpy.pi * frequency * (t - 0.4)) ** 2
    numpy.savetxt(path, numpy.column_stack([t, peak * (1 - 2 * x) * numpy.exp(-x)]))
    return path


def largest_deviation(binary, source, work, model):
    """Of the motion by both components from the sum of the motions by each, over the largest velocity."""
    along, up = write_pulse(work / "along.txt", 4, 1), write_pulse(work / "up.txt", 6, 0.7)
    text, peak = "Motion/Type=text", "Motion/Peak=2"
    runs = {"along": ["Motion/File=%s" % along, peak], "up": ["Motion/File=%s" % up, "Motion/Peak=1.4", "Motion/Angle=90"],
            "both": ["Motion/File=%s" % along, peak, "Motion/Vertical file=%s" % up, "Motion/Vertical peak=1.4"]}
    velocities = {}
    for name, settings in runs.items():
        directory = run(binary, source, work, model, "outcrop", text, *settings, name=name)
        with h5py.File(directory / "run.h5", "r") as file:
            velocities[name] = numpy.hstack([file[group + "/velocity"][:] for group in ("input", "monitors/base", "monitors/mass")])
    largest = numpy.abs(velocities["both"]).max(axis=0).reshape(3, 2)
    assert (largest > 0.01).all(), "both components move everything"
    return numpy.abs(velocities["both"] - velocities["along"] - velocities["up"]).max() / largest.max()


def main():
    binary, source, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    failed = 0
    for model in MODELS:
        runs = {meaning: run(binary, source, work, model, meaning) for meaning in ("outcrop", "incident")}
        peaks = {meaning: peaks_of(directory) for meaning, directory in runs.items()}
        if model in LED:
            part = integration_part(runs["outcrop"])
            failed += part > 1e-3
            print(f"{model}: {part:.2g} of the kinetic energy by the integration" + ("  WRONG" if part > 1e-3 else ""))
        for meaning, found in peaks.items():
            for place in ("base", "mass"):
                ratios = [found[place, quantity] / found["input", quantity] for quantity in QUANTITIES]
                bad = max(abs(ratio - 1.) for ratio in ratios) > 0.02
                failed += bad
                print(f"{model}, {meaning}: {place} over outcrop " + ", ".join("%.4f" % r for r in ratios) +
                      ("  WRONG" if bad else ""))
        doubled = [peaks["incident"][key] / max(peaks["outcrop"][key], 1e-300) for key in peaks["outcrop"]]
        bad = max(abs(ratio - 2.) for ratio in doubled) > 1e-3
        failed += bad
        deviation = largest_deviation(binary, source, work, model)
        failed += deviation > 1e-6
        print(f"{model}: both components less the sum of each {deviation:.2g}" + ("  WRONG" if deviation > 1e-6 else ""))
        print(f"{model}: incident over outcrop from {min(doubled):.6f} to {max(doubled):.6f}" + ("  WRONG" if bad else ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
