# SPDX-License-Identifier: GPL-3.0-or-later
"""What each event adds, and the displacement of the monitors through all of them."""

import os

import matplotlib.pyplot as plt
import numpy as np

from hybrid_tools import style

MOST_LINES = 6


def draw(events, done, part, directory):
    figure, (bars, lines) = plt.subplots(1, 2, figsize=(9, 3.6), constrained_layout=True, width_ratios=(1, 1.6))
    numbers = np.array([event.number for event in done])
    sizes = 1e3 * np.array([event.sizes() for event in done])
    bars.bar(numbers - 0.2, sizes[:, 0], 0.4, color=style.HORIZONTAL, label="largest displacement of a monitor")
    if done[0].slip is not None:
        bars.bar(numbers + 0.2, sizes[:, 1], 0.4, color=style.SLIP, label="mean slip")
    bars.axhline(part * sizes[0, 0], color=style.TEXT, linewidth=0.8, linestyle="--")
    bars.set(xlabel="event", ylabel="added [mm]", title="What each event adds", xticks=numbers)
    bars.set_ylim(top=1.3 * max(sizes.max(), 1e-9))
    bars.legend(loc="upper right")
    order = sorted(done[0].points, key=lambda name: -np.linalg.norm(done[0].points[name].left))
    for name in order[:MOST_LINES]:
        lines.plot(events.run.time, 1e3 * events.run.downhill * events.histories[name][:, 0], linewidth=0.8, label=name)
    for number in numbers[:-1]:
        lines.axvline(number * events.period, color="#8a8a8a", linewidth=0.6)
    lines.set(xlabel="time [s]", ylabel="%s displacement [mm]" % events.run.along(), title="Monitors that the first event leaves farthest")
    lines.legend(ncols=2)
    path = os.path.join(directory, "condition.png")
    figure.savefig(path)
    plt.close(figure)
    return path
