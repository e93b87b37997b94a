# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid condition: what a motion leaves at first, and after it has come until little is added."""
