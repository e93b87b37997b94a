# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid new DIRECTORY: geometry, scene and monitors of a slope from polylines; checked, ready to run."""

import os
import re
import shutil
import subprocess
import tempfile

from hybrid_run import UserError
from hybrid_tools.arguments import Arguments
from hybrid_tools.study import program

from . import sizes
from .geometry_file import geometry_text
from .materials import Slices, rounded
from .polylines import read_planes, read_profile, read_slip
from .record import Ricker, read_record
from .scene_file import scene_text
from .section import Section

ABOUT = """Make a slope that runs from polylines: DIRECTORY/section.geo (for gmsh), DIRECTORY/scene.prm and a copy of the record.
Tables have columns x, y [m]: commas, semicolons, tabs or blanks between them, a header or none."""
EXAMPLES = """  hybrid new --profile ground.csv my-slope                       waves alone, a Ricker wavelet
  hybrid new --profile ground.csv --slip slip.csv --planes planes.csv --record r.at2 my-slope
  hybrid my-slope/scene.prm
Materials are typical values, marked <- in scene.prm: replace them."""


ATTEMPTS = 3  # to resolve the motion, and to make the mass stand
TRIED_BLOCKS = 3000  # largest mass whose static stage is tried: some seconds


def arguments():
    found = Arguments("new", ABOUT, EXAMPLES)
    found.add_argument("directory", metavar="DIRECTORY", help="of the new slope")
    found.add_argument("--profile", required=True, metavar="FILE", help="the ground: x, y [m]")
    found.add_argument("--slip", metavar="FILE", help="sliding surface: x, y [m], cut or extended to the ground; without: no mass, waves alone")
    found.add_argument("--planes", metavar="FILE", help="bedding planes: name, x, y [m], or x, y with an empty line between two planes")
    found.add_argument("--record", metavar="FILE", help="PEER record (.at2), or time [s] and acceleration; without: a Ricker wavelet")
    found.add_argument("--unit", choices=("g", "m/s2", "cm/s2", "gal"), help="of the accelerations in a record of two columns")
    found.add_argument("--peak", metavar="VALUE", help="peak acceleration with its unit, as '0.3 g'; default: as recorded")
    found.add_argument("--frequency", type=float, default=2.0, metavar="HZ", help="of the Ricker wavelet; default 2")
    found.add_argument("--size", type=float, metavar="M", help="edge length of the blocks, or of all elements without a mass; default: by wavelength")
    found.add_argument("--title", help="default: the name of the directory")
    found.add_argument("--force", action="store_true", help="replace section.geo, scene.prm and the record in a directory that is there")
    return found


def check_options(options):
    if options.size is not None and not options.size > 0:
        raise UserError("--size is %g m; it must be positive" % options.size)
    if not options.frequency > 0:
        raise UserError("--frequency is %g Hz; it must be positive" % options.frequency)
    directory = options.directory
    if os.path.exists(directory) and not os.path.isdir(directory):
        raise UserError("'%s' is a file; give a directory" % directory)
    if os.path.isdir(directory) and os.listdir(directory) and not options.force:
        raise UserError("'%s' is not empty; give another directory, or --force to replace section.geo, scene.prm and the record in it" % (
            directory))


def read(options):
    """make(finer, notes): the section of what the files say."""
    record = read_record(options.record) if options.record else Ricker(options.frequency)
    if record.kind == "text" and not options.unit:
        raise UserError("%s: give the unit of its accelerations, --unit g, m/s2, cm/s2 or gal" % options.record)
    first = []
    profile = read_profile(options.profile, first)
    slip = read_slip(options.slip, first) if options.slip else None
    planes = read_planes(options.planes) if options.planes else []

    def make(finer):
        notes = list(first)
        return Section(profile, slip, planes, record, options.size, notes, finer)

    return make


def times(section):
    """(End time, Time step) [s]; after a wavelet the time that waves take to the side and back."""
    record = section.record
    end = record.duration
    if record.kind == "ricker":
        end += 2 * (section.right - section.left) / section.rock.s_wave_speed
    return sizes.rounded_up(end) if record.kind == "ricker" else round(end, 6), sizes.time_step(record)


def write(section, options, place):
    """The files of the slope, in a directory where they are checked first."""
    title = options.title or os.path.basename(os.path.abspath(options.directory))
    options.pictures = sizes.rounded_up(times(section)[0] / 100)
    with open(os.path.join(place, "section.geo"), "w", encoding="utf-8") as text:
        text.write(geometry_text(section, title))
    with open(os.path.join(place, "scene.prm"), "w", encoding="utf-8") as text:
        text.write(scene_text(section, title, options.directory, options))
    if section.record.path:
        shutil.copyfile(section.record.path, os.path.join(place, os.path.basename(section.record.path)))


def hand_over(place, directory):
    """What the program has found good."""
    os.makedirs(directory, exist_ok=True)
    for name in os.listdir(place):
        shutil.copyfile(os.path.join(place, name), os.path.join(directory, name))


def describe(section):
    """What was made, in lines."""
    print("section    x = %g to %g m, base at %g m: %g m of rock beside the %s, %g m below its lowest point" % (
        section.left, section.right, section.base, section.margin, "slope" if section.mass is None else "mass", round(section.depth_below, 1)))
    if section.mass is not None:
        thickest, x = section.mass.thickest
        print("mass       %.4g m2, up to %.3g m thick at x = %.4g m, falls to the %s; factor of safety at rest %.3g with the typical strengths" % (
            section.mass.polygon.area, thickest, x, "left" if section.mass.falls_left else "right", section.belt.safety))
    for name, number in sorted({(name, number) for name, number, _ in section.planes}, key=lambda p: p[1]):
        print("plane      bedding_%d is %s" % (number, name))
    print("sizes      h = %g m%s; the motion has 95 %% of its energy below %.3g Hz" % (
        section.h, ", far from the %s %g m" % ("slope" if section.mass is None else "mass", section.far) if section.far > section.h else "",
        section.record.highest_frequency))
    for note in section.notes:
        print("note       " + note)


def check(scene):
    """The program's own words on the scene: (exit code, errors, warnings, card)."""
    found = subprocess.run([os.environ["HYBRID_PROGRAM"], "--check", scene], capture_output=True, text=True)
    text = (found.stdout + found.stderr).splitlines()
    errors, warnings = ([line for line in text if line.startswith(word)] for word in ("error", "warning"))
    return found.returncode, errors, warnings, text


def finer_than(finer, warnings):
    """By how much smaller elements would resolve the motion, as the program's warnings say; None if they do."""
    found = list(finer)
    for warning in warnings:
        resolved = re.search(r"warning: the (sliding mass|continuum) resolves ([\d.]+) Hz .* up to ([\d.]+) Hz", warning)
        if resolved:
            found[resolved[1] == "continuum"] *= 0.97 * float(resolved[2]) / float(resolved[3])
    return None if found == list(finer) or min(found) < 0.5 else tuple(found)


def make_and_check(options, place):
    """(section, card, warnings) of what was written; meshed again where the first mesh is a little too coarse for the motion."""
    make, finer = read(options), (1.0, 1.0)
    for _ in range(ATTEMPTS):
        section = make(finer)
        write(section, options, place)
        code, errors, warnings, card = check(os.path.join(place, "scene.prm"))
        if code != 0:
            said = (" ".join(errors)[len("error: "):] or card[-1]).replace(place + os.sep, "")
            raise UserError("nothing was written, as the program refuses the scene%s: %s" % (
                " with elements of %g m (--size)" % options.size if options.size else "", said))
        finer = finer_than(finer, warnings)
        if finer is None or options.size:
            break
    return section, card, [warning.replace(place + os.sep, "") for warning in warnings]


def stands(scene):
    """Whether the program finds the mass at rest under its weight: the static stage alone."""
    with tempfile.TemporaryDirectory() as temporary:
        words = [os.environ["HYBRID_PROGRAM"], scene, "-s", "Time/End time=0", "-s", "Output/Directory=" + os.path.join(temporary, "run")]
        words += program.options(program.ONE_RUN)
        return subprocess.run(words, capture_output=True).returncode == 0


def make_it_stand(section, options, place, blocks):
    """More cohesion until the typical strengths hold the mass; limit equilibrium does not see how it deforms. Too many blocks: not tried."""
    scene = os.path.join(place, "scene.prm")
    if section.mass is None or blocks > TRIED_BLOCKS:
        return
    for _ in range(ATTEMPTS):
        if stands(scene):
            return
        section.belt.cohesion = rounded(1.5 * section.belt.cohesion, 2, up=True)
        section.body.cohesion = max(section.body.cohesion, section.belt.cohesion)
        section.belt.safety = Slices(section.mass, section.body.density).safety(section.belt.friction_angle, section.belt.cohesion)
        write(section, options, place)
    if not stands(scene):
        section.notes.append("the mass does not stand under its weight with the typical strengths: give your own, or set Gravity/Static stage = held")


def main(words):
    options = arguments().read(words)
    check_options(options)
    with tempfile.TemporaryDirectory() as place:
        section, card, warnings = make_and_check(options, place)
        make_it_stand(section, options, place, count(card, "Blocks", "blocks"))
        hand_over(place, options.directory)
    describe(section)
    tell_cost(section, card)
    for warning in warnings:
        print(warning)
    scene = os.path.join(options.directory, "scene.prm")
    print("written    %s; replace the values marked <-, then: hybrid %s" % (scene, scene))
    return 0


def count(card, word, before):
    """The number before a word on the line of the card that begins with `word`."""
    for line in card:
        if line.startswith(word):
            fields = line.split()
            return int(next((fields[k] for k in range(len(fields) - 1) if fields[k + 1].startswith(before)), 0))
    return 0


def tell_cost(section, card):
    blocks, unknowns = count(card, "Blocks", "blocks"), count(card, "Continuum", "unknowns")
    end, step = times(section)
    seconds = sizes.estimated_cost(blocks, unknowns, end / step)
    memory = next((line.split(":")[0].split(maxsplit=1)[1] for line in card if line.startswith("Memory")), "unknown")
    print("cost       %d blocks, %d bedrock unknowns, %d steps: about %s of processor time (within a factor of two, more if joints fail); "
          "the runs that tell its errors take one to two times as long again" % (
              blocks, unknowns, round(end / step), in_words(seconds)))
    print("memory     " + memory)


def in_words(seconds):
    return "%.2g s" % max(seconds, 1) if seconds < 90 else "%.2g min" % (seconds / 60) if seconds < 5400 else "%.2g h" % (seconds / 3600)
