# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what hybrid has written, with numpy.

    from hybrid_run import Run
    run = Run("output/badong")
    crest = run.monitors["S8"]
    print(abs(crest.displacement[:, 0]).max(), run.summary["energy_residual"])
    frequency, ratio = crest.spectral_ratio()

Units are SI (m, s, Pa; forces and energies per metre of thickness). A pair is [x, y]: x horizontal, y up.
"""

from . import convergence
from .column import Layer, column_under, motion_in_column, transfer_function
from .errors import MissingData, NotInScene, UserError
from .line import Line
from .monitor import Monitor
from .parameters import read_parameters
from .response_spectrum import pseudo_acceleration
from .run import Run
from .spectra import fourier_amplitude, has_energy, konno_ohmachi, spectral_ratio

__all__ = ["Layer", "Line", "MissingData", "Monitor", "NotInScene", "Run", "UserError", "column_under", "convergence", "fourier_amplitude",
           "has_energy", "konno_ohmachi", "motion_in_column", "pseudo_acceleration", "read_parameters", "spectral_ratio", "transfer_function"]
