# SPDX-License-Identifier: GPL-3.0-or-later
"""How every figure looks: colours, fonts, units."""

import contextlib
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.patheffects as effects
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

HORIZONTAL = "#1f5a94"  # x component
VERTICAL = "#d98b2b"  # y component
TENSILE = "#c8202f"
SHEAR = "#1f4fd8"
TENSILE_PALE = "#f0a5a8"
SHEAR_PALE = "#a5b8f0"
ROCK_EDGE = "#6f6a60"
WATER = "#3a8fc7"
SLIP = "#7a3b10"
TEXT = "#262626"
BEDDING = "#8a5fa8"
JOINTS = "#a03050"  # of the mass, with a material of their own
MATERIALS = ("#f3dfb5", "#dfe6cf", "#cfdcea", "#ead3cf", "#ddd6ea", "#e4e0da", "#cfe6e3", "#f0e6c2")  # areas
CURVES = ("#0072b2", "#d55e00", "#009e73", "#8c5fa8", "#e69f00", "#56b4e9", "#000000", "#7a3b10", "#cc79a7")  # after Okabe and Ito (2008)
BELTS = (SLIP, "#c07a2c", "#4d6b1f", "#8c2f5f")  # lines

LETTER = 0.092  # mean width of a letter of a title [inches]

# Ends before brown, so that red and blue marks of joints stand out on it.
DISPLACEMENT_MAP = ListedColormap(plt.get_cmap("YlOrBr")(np.linspace(0.02, 0.66, 256)))

HALO = [effects.withStroke(linewidth=2.2, foreground="white")]  # of names on a picture

DPI = 130

taker = None  # of figures; None: they are written to files
written = []  # files that save() has written, in order


def apply():
    plt.rcParams.update(
        {
            "figure.dpi": DPI,
            "savefig.dpi": DPI,
            "font.size": 9,
            "font.family": "DejaVu Sans",
            "axes.titlesize": 10,
            "axes.titleweight": "bold",
            "axes.titlelocation": "left",
            "axes.labelsize": 9,
            "axes.labelcolor": TEXT,
            "axes.edgecolor": "#8a8a8a",
            "axes.linewidth": 0.7,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.color": "#e6e6e6",
            "grid.linewidth": 0.6,
            "axes.axisbelow": True,
            "xtick.color": "#5a5a5a",
            "ytick.color": "#5a5a5a",
            "xtick.labelsize": 8,
            "ytick.labelsize": 8,
            "legend.frameon": False,
            "legend.fontsize": 8,
            "lines.linewidth": 1.0,
            "agg.path.chunksize": 20000,
            "axes.formatter.useoffset": False,
            "axes.formatter.limits": (-4, 7),
        }
    )


def use_format(name):
    """How save() writes: png, pdf or svg. Text stays text."""
    plt.rcParams.update({"savefig.format": name, "pdf.fonttype": 42, "svg.fonttype": "none"})


def length_unit(largest):
    """(factor, unit) that shows a length of this size [m] with few digits."""
    if not np.isfinite(largest) or largest < 1.0:
        return 1e3, "mm"
    return 1.0, "m"


def frequency_ticks(low, high):
    """1, 2 and 5 times powers of ten between these frequencies [Hz], and more where these are fewer than three."""
    for factors in ((1, 2, 5), (1, 2, 3, 5, 7), (1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9)):
        ticks = [factor * 10.0**power for power in range(-2, 3) for factor in factors]
        found = [tick for tick in ticks if low <= tick <= high]
        if len(found) >= 3:
            break
    return found


def scaled(values, largest, steps):
    """Pick the (factor, unit) of steps = [(limit, factor, unit), ...] for values up to largest."""
    for limit, factor, unit in steps:
        if largest < limit:
            return values * factor, unit
    return values * steps[-1][1], steps[-1][2]


def title(figure, text, beside=0.0):
    """Title at the upper left, in several lines where it is long; the rest of the figure keeps clear of it.

    beside: width of what stands at its right [inches]. Returns how many lines it takes beyond the first.
    """
    width, height = figure.get_size_inches()
    lines = textwrap.wrap(text, max(20, int((width - beside) / LETTER)))
    figure.suptitle("\n".join(lines), fontweight="bold", x=0.01, y=1 - 0.07 / height, ha="left", va="top", fontsize=11)
    if figure.get_layout_engine() is not None:
        reserved = (0.16 + 0.18 * len(lines)) / height
        figure.get_layout_engine().set(rect=(0, 0, 1, 1 - reserved))
    return len(lines) - 1


@contextlib.contextmanager
def taken(take):
    """Within it, figures go to take(figure, name), not to files."""
    global taker
    before, taker = taker, take
    try:
        yield
    finally:
        taker = before


def save(figure, directory, name, is_measured=False):
    """directory/name in the format that use_format() chose; see also taken(). is_measured: all that is drawn lies within the figure."""
    if taker is not None:
        taker(figure, name)
        plt.close(figure)
        return
    # tight: a long label never ends at the edge of the paper
    edge = {} if is_measured else {"bbox_inches": "tight", "pad_inches": 0.1}
    path = "%s/%s.%s" % (directory, name, plt.rcParams["savefig.format"])
    figure.savefig(path, facecolor="white", **edge)
    written.append(path)
    plt.close(figure)
