# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid study: what accuracy costs in time."""
