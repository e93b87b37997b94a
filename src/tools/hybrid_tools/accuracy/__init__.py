# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid accuracy: how far a run is off, by coarser ones."""
