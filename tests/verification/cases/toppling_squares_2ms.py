# SPDX-License-Identifier: GPL-3.0-or-later
"""toppling_squares.prm at 2 ms, by itself to keep each case short."""

from toppling_squares import compare


def check(case):
    case.scene = case.scene.with_name("toppling_squares.prm")
    compare(case, case.run("coarse", "Time/Time step=0.002"), 2e-3)
