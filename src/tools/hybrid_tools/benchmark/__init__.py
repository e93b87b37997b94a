# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid benchmark: how fast the program is on scenes that are known to be hard."""
