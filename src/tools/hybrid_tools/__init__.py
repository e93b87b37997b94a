# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid plot, compare, study, ...: what is done with runs. A folder for each, with main(words) in its command.py."""
