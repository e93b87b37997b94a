# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of runs: what a script of a user finds."""
import numpy as np
import pytest
from conftest import ONE_RUN, ROOT

import hybrid_run
from hybrid_run import Run, UserError


@pytest.fixture(scope="module")
def column(hybrid, tmp_path_factory):
    directory = tmp_path_factory.mktemp("column") / "run"
    result = hybrid(ROOT / "parameters/verification/coupled_column.prm", "-s", "Time/End time=0.3", "-s", f"Output/Directory={directory}",
                    *ONE_RUN)
    assert result.returncode == 0, result.stderr
    return Run(directory)


def test_a_run_of_the_program_is_read(column):
    assert len(column.time) == column.summary["steps"]
    assert column.parameters["Time/End time"] == "0.3" and column.parameters["Model/Bedrock"] == "continuum"
    assert len(column.blocks) == column.summary["blocks"] == len(column.blocks.displacement)
    for name, monitor in column.monitors.items():
        assert monitor.displacement.shape == monitor.acceleration.shape == (len(column.time), 2)
        peaks = column.summary["monitors"][name]
        assert np.abs(monitor.peak("acceleration")) == pytest.approx(np.abs(peaks["peak_acceleration_m_s2"]), rel=1e-12)
        if name != column.base:  # the summary's is below the corner of the low-pass
            raw = monitor.peak("displacement")
            assert raw == pytest.approx(np.abs(peaks["peak_displacement_m"]), abs=0.02 * raw.max())
    assert column.blocks.centroids.shape == (len(column.blocks), 2)


def test_a_parameter_file_is_read_as_the_program_reads_it(tmp_path):
    path = tmp_path / "scene.prm"
    path.write_text("set Title = a # b\nsubsection Time\n  set End   time=3\nend\nsubsection Materials\n subsection rock\n"
                    "set Density = 2 \\\n 700 # heavy\n end\nend\n")
    assert hybrid_run.read_parameters(path) == {"Title": "a", "Time/End time": "3", "Materials/rock/Density": "2 700"}


def test_a_constant_spectrum_stays_and_a_peak_keeps_its_place():
    frequency = np.linspace(0, 50, 2001)
    at = np.geomspace(0.5, 40, 60)
    assert hybrid_run.konno_ohmachi(frequency, np.full(2001, 3.0), at) == pytest.approx(3.0)
    peak = np.exp(-((np.log10(np.maximum(frequency, 1e-3) / 10) / 0.01) ** 2))
    smooth = hybrid_run.konno_ohmachi(frequency, peak, at)
    assert at[smooth.argmax()] == pytest.approx(10, rel=0.05)
    # Konno and Ohmachi (1998, eq. 4) by the sum over all frequencies
    b, centre = 20.0, at[30]
    x = b * np.log10(frequency[1:] / centre)
    window = np.where(np.abs(x) < 1e-12, 1.0, (np.sin(x) / np.where(x == 0, 1, x)) ** 4)
    assert hybrid_run.konno_ohmachi(frequency, peak, [centre], b)[0] == pytest.approx((window * peak[1:]).sum() / window.sum(), rel=1e-3)


def test_the_ratio_of_a_history_to_its_half_is_two_and_of_an_oscillator_its_transfer_function():
    dt, n = 0.005, 8192
    t = dt * np.arange(n)
    rng = np.random.default_rng(2)
    reference = rng.standard_normal(n) * np.exp(-t / 4)
    at = np.geomspace(1, 30, 20)
    assert hybrid_run.spectral_ratio(2 * reference, reference, dt, at) == pytest.approx(2.0)
    f = np.fft.rfftfreq(n, dt)
    transfer = 1 / (1 + 2j * 0.3 * f / 8 - (f / 8) ** 2)
    output = np.fft.irfft(np.fft.rfft(reference) * transfer, n)
    expected = np.abs(np.interp(at, f, np.abs(transfer)))
    assert hybrid_run.spectral_ratio(output, reference, dt, at, 80) == pytest.approx(expected, rel=0.08)


def test_an_oscillator_answers_a_sine_as_its_closed_form_and_a_step_by_its_overshoot():
    dt, w, z = 0.002, 2 * np.pi * 4.0, 0.05
    t = dt * np.arange(10000)
    steady = hybrid_run.pseudo_acceleration(np.sin(w * t), dt, [0.5, 4.0, 4.5], z)
    ratio = 4.0 / np.array([0.5, 4.0, 4.5])
    closed = 1 / np.sqrt((1 - ratio**2) ** 2 + (2 * z * ratio) ** 2)
    assert steady[1] == pytest.approx(closed[1], rel=2e-3)  # at resonance the start adds nothing
    step = hybrid_run.pseudo_acceleration(np.full(5000, 3.0), dt, [1.0, 10.0], z)  # the first sample is at t = 0
    assert step == pytest.approx(3.0 * (1 + np.exp(-np.pi * z / np.sqrt(1 - z * z))), rel=5e-3)
    undamped = hybrid_run.pseudo_acceleration(np.full(2000, 1.0), dt, [0.3], 0.0)  # not grown over many small steps
    assert undamped == pytest.approx(2.0, rel=1e-5)


def test_there_is_no_ratio_to_a_motion_without_energy():
    dt = 0.005
    t = dt * np.arange(2000)
    pulse = (1 - 2 * (np.pi * 2 * (t - 1)) ** 2) * np.exp(-((np.pi * 2 * (t - 1)) ** 2))  # Ricker, 2 Hz: f^2 exp(-f^2 / 4)
    at = np.array([0.1, 1.0, 2.0, 4.0, 12.0])
    expected = at**2 * np.exp(-(at**2) / 4) > hybrid_run.spectra.FAINT * 4 / np.e
    assert (hybrid_run.has_energy(pulse, dt, at, 80) == expected).all() and expected.tolist() == [False, True, True, True, False]
    assert not hybrid_run.has_energy(pulse, dt, np.array([10.0, 12.0]), 80).any()  # the peak is not among what is asked for


def test_a_directory_without_a_run_is_told(tmp_path):
    with pytest.raises(UserError, match="holds no run.h5"):
        Run(tmp_path)
    (tmp_path / "run.h5").write_bytes(b"nothing")
    with pytest.raises(UserError, match="cannot read"):
        Run(tmp_path)
