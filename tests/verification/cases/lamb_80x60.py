# SPDX-License-Identifier: GPL-3.0-or-later
"""Lamb's problem on 80 x 60 cells of degree 4: five distances."""

import lamb
from lamb import draw  # noqa: F401 (verify.py calls it)


def check(case):
    lamb.check(case, (200, 400, 600, 800, 1000))
