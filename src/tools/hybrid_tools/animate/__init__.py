# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid animate: a film of a run."""
