# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot: the figures of a run."""
