# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid report: a page that says what happened in a run, or in several."""
