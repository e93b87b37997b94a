# SPDX-License-Identifier: GPL-3.0-or-later
"""The semicircular canyon on a finer mesh in a wider box."""

import canyon
from canyon import draw  # noqa: F401 (verify.py calls it)

LIMITS = {0.5: (0.006, 0.01), 1.0: (0.006, 0.01), 2.0: (0.02, 0.02)}


def check(case):
    canyon.check(case, LIMITS)
