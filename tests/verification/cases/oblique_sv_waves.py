# SPDX-License-Identifier: GPL-3.0-or-later
"""SV packets of oblique_waves.prm at three of its angles, to keep the case short."""

import oblique_waves


def check(case):
    case.scene = case.scene.with_name("oblique_waves.prm")
    oblique_waves.check(case, waves=("SV",), angles=(0, 30, 60))
