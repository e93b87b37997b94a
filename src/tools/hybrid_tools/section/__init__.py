# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid section: what a scene looks like before it is run."""
