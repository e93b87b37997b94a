# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid fos: factor of safety, yield coefficient, Newmark's displacements."""
