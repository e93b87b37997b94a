# SPDX-License-Identifier: GPL-3.0-or-later
"""The SV packets of oblique_waves.prm, by themselves to keep each case short."""

import oblique_waves


def check(case):
    case.scene = case.scene.with_name("oblique_waves.prm")
    oblique_waves.check(case, waves=("SV",))
