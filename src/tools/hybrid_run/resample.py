# SPDX-License-Identifier: GPL-3.0-or-later
"""Histories of several runs on one time axis: cut to the shortest, sampled as the coarsest, without aliases where these matter."""

import numpy as np

SAME = 1e-6  # of a step: times closer than this are the same
PASS = 0.8  # anti-aliasing: corner over half of the new sampling rate
ORDER = 8  # of the Butterworth filter, forwards and backwards: 1 % at half of that corner's frequency is 1e-5


def usual_step(time):
    """Step that most of a history has [s]: cut steps are shorter."""
    return float(np.median(np.diff(time)))


def common_axis(times):
    """Equal steps that all these time axes [s] cover: from the latest first to the earliest last sample, as wide as the widest usual step.

    times: arrays of at least two increasing times each. @return the axis [s]; empty if they have no two steps in common.
    """
    step = max(usual_step(time) for time in times)
    start, end = max(time[0] for time in times), min(time[-1] for time in times)
    if end < start:
        return np.zeros(0)
    same = next((time for time in times if is_equal(time, start, step)), None)
    if same is not None:  # its own times: it is not resampled, and equal runs stay equal to the bit
        return same[same <= end + SAME * step]
    return start + step * np.arange(int((end - start) / step + SAME) + 1)


def is_equal(time, start, step):
    """Whether a time axis begins there with equal steps of this size."""
    return abs(time[0] - start) <= SAME * step and bool(np.all(np.abs(np.diff(time) - step) <= SAME * step))


def resample(time, values, axis, has_aliases=True):
    """Histories (a column each) at the times of a common axis [s].

    Rows are taken as they are where the times are those of the axis. Else cubic splines are laid through them. has_aliases: a history
    with finer steps passes a zero-phase low-pass below half of the axis' sampling rate first, as it must before a spectrum, a filter or
    a peak of accelerations; displacements are smooth, their values at these times need none. A column that is not finite somewhere is NaN.
    """
    time, values = np.asarray(time, float), np.asarray(values, float)
    first = int(np.argmin(np.abs(time - axis[0])))
    own = time[first : first + len(axis)]
    if len(own) == len(axis) and np.allclose(own, axis, rtol=0, atol=SAME * usual_step(axis)):
        return values[first : first + len(axis)]
    columns = values.reshape(len(values), -1)
    result = np.full((len(axis), columns.shape[1]), np.nan)
    finite = np.isfinite(columns).all(axis=0)
    if finite.any():
        result[:, finite] = _interpolate(time, columns[:, finite], axis, has_aliases)
    return result.reshape((len(axis),) + values.shape[1:])


def _interpolate(time, values, axis, has_aliases):
    from scipy import interpolate, signal  # half a second, which few need

    spline = interpolate.CubicSpline(time, values)
    step = usual_step(axis)
    parts = round(step / usual_step(time))  # of a step of the axis
    if parts < 2 or not has_aliases:
        return spline(axis)
    before = int(parts * (axis[0] - time[0]) / step + SAME)  # samples before the axis begins
    fine = axis[0] + step / parts * np.arange(-before, (len(axis) - 1) * parts + 1)
    smooth = signal.butter(ORDER, PASS / parts, output="sos")
    padding = min(len(fine) - 1, 10 * parts)
    return signal.sosfiltfilt(smooth, spline(np.clip(fine, time[0], time[-1])), axis=0, padlen=padding)[before::parts]
