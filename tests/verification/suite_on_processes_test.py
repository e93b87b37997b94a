#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every scene of the verification suite, or every hard case, on 1, 2 and 4 processes. However few blocks there are, they are shared out, and have the bits of one process
in the static stage and the first steps; waves alone go by conjugate gradients, to their end in as many steps, and differ by at most 1e-8 of the peak. Scenes that nothing of can be shared out
are computed by the first process alone.

Usage: suite_on_processes_test.py HYBRID_BINARY PART WORK_DIR [SCENE...]     PART: verification, hard
"""
import re
import sys

import numpy
from processes import ALONE, ROOT, WORK, main, require, require_same_bits, run, two_at_once, words_of
from runs_alike import series

LARGEST = 1e-8  # difference of waves alone, of the peak
LEAST = 1e-9  # displacement by which a wave has arrived [m]
MOST_STEPS = 300
FINER = ("canyon_fine", "lamb_80x60")  # meshes of other scenes
COUNTS = (2, 4)
FEW = "Parallel/Shared blocks=2"
ITERATED = "Continuum/Linear solver=conjugate gradients"


def text_of(file):
    """A scene with what it includes."""
    text = file.read_text()
    found = re.search(r"^include (\S+)$", text, re.MULTILINE)
    return (text_of(file.parent / found.group(1)) if found else "") + text


def last_value(text, name, default):
    return (re.findall(r"set %s *= *(\S+)" % name, text) or [default])[-1]


def overrides_of(file):
    """What makes it short - waves are to arrive, so by longer steps - and shares it out. @return overrides, and whether it is of waves alone."""
    text = text_of(file)
    waves = last_value(text, "Blocks", "bonded") == "none" and last_value(text, "Bedrock", "continuum") == "continuum"
    step, end = float(last_value(text, "Time step", "1e-3")), float(last_value(text, "End time", "1"))
    if waves:
        return [f"Time/Time step={max(step, end / MOST_STEPS):.12g}", "Output/Picture interval=0", ITERATED], waves
    return [f"Time/End time={min(end, MOST_STEPS * step):.12g}", "Output/Picture interval=0", FEW], waves


def require_alike(name, one, other):
    """Histories of the monitors and peaks of all nodes: each kind - displacement, velocity, acceleration - over its peak."""
    for kind in ("displacement", "velocity", "acceleration"):
        names = [n for n in one if n.startswith("monitors/") and n.endswith("/" + kind) or n == "fields/nodes/peak_" + kind]
        peak = max((numpy.abs(one[n]).max(initial=0.) for n in names), default=0.)
        worst = max((numpy.abs(one[n] - other[n]).max(initial=0.) for n in names), default=0.)
        require(peak > LEAST, f"{name}: {kind} of {peak:.2g} is no wave")
        require(worst <= LARGEST * peak, f"{name}: {kind} differs by {worst / peak if peak else worst:.2g} of the peak")


def check_scene(file, shared):
    overrides, waves = overrides_of(file)
    scene = str(file.with_suffix(""))
    directory = WORK / file.parent.name / file.stem
    words = words_of(scene, directory / "1", overrides)
    alone = run(1, words, expect=None)
    if alone.returncode != 0 and waves and "conjugate gradients" in alone.stderr:  # planes that slip want a factor
        overrides.remove(ITERATED)
        alone = run(1, words_of(scene, directory / "1", overrides), expect=None)
    require(alone.returncode == 0, f"{file.stem}: {alone.stderr[-400:]}")
    for count in COUNTS:
        place = directory / str(count)
        result = run(count, words_of(scene, place, overrides), expect=alone.returncode)
        is_shared = ALONE not in result.stdout
        shared.setdefault((waves, is_shared), []).append(file.stem)
        if not (directory / "1/run.h5").exists():
            continue  # the static stage only
        expected = series(directory / "1")
        if waves and is_shared:
            require_alike(f"{file.stem}, {count} processes", expected, series(place))
        else:
            require_same_bits(expected, place, f"{file.stem}, {count} processes")


def check(folder):
    shared = {}
    chosen = sys.argv[4:]
    files = [f for f in sorted((ROOT / "parameters" / folder).glob("*.prm")) if (f.stem in chosen if chosen else f.stem not in FINER)]
    two_at_once(lambda file: check_scene(file, shared), files)
    for (waves, is_shared), names in sorted(shared.items()):
        print("%d runs of %s, %s: %s" % (len(names), "waves alone" if waves else "blocks", "shared out" if is_shared else "by the first process alone",
                                         ", ".join(sorted(set(names)))))
    require(chosen or len(shared.get((False, True), [])) > len(files) / 2, "most scenes of blocks are shared out")


if __name__ == "__main__":
    main({"verification": lambda: check("verification"), "hard": lambda: check("hard")})
