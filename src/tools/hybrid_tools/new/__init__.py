# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid new: geometry, scene and monitors of a slope that is given as polylines."""
