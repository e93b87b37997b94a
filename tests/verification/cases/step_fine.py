# SPDX-License-Identifier: GPL-3.0-or-later
"""The steps of step.prm and, for each, a finer mesh in a wider box."""

import step


def check(case):
    case.scene = case.scene.with_name("step.prm")
    step.check(case, finer=step.ANGLES)
