# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures as SVG inside a page: small, named, with identifiers of their own."""

import io
import re

import matplotlib.pyplot as plt
import numpy as np
from markupsafe import Markup, escape

SIMPLIFIED = {"path.simplify": True, "path.simplify_threshold": 0.25, "svg.fonttype": "none", "svg.hashsalt": "hybrid"}
RASTER_DPI = 160
PIECES = 700  # of a history, two points each: more than a drawing has columns of dots
MOST_PARTS = 2500  # of a collection; denser ones become a picture inside the drawing


def to_svg(figure, name, alt, most=MOST_PARTS):
    """The figure as an <svg> whose identifiers begin with name; alt is what is read aloud; most: parts of a collection that stays lines.
    The figure is closed."""
    for axes in figure.axes:
        for line in axes.lines:
            line.set_data(*thinned(*line.get_data(orig=False)))
        for part in axes.collections:
            if len(part.get_paths()) > most:
                part.set_rasterized(True)
    text = io.StringIO()
    with plt.rc_context(SIMPLIFIED):
        figure.savefig(text, format="svg", facecolor="white", bbox_inches="tight", pad_inches=0.06, dpi=RASTER_DPI,
                       metadata={"Date": None, "Creator": None})
    plt.close(figure)
    return Markup(shrunk(text.getvalue(), name, alt))


def thinned(x, y):
    """The least and the largest of each of many equal pieces of a long history: what is seen of it is the same."""
    x, y = np.asarray(x, float), np.asarray(y, float)
    piece = len(x) // PIECES
    if piece < 4 or (np.diff(x) <= 0).any() or not np.isfinite(y).all():
        return x, y
    n = len(x) // piece * piece
    parts = y[:n].reshape(-1, piece)
    starts = piece * np.arange(len(parts))
    ends = [0], np.arange(n, len(x)), [len(x) - 1]
    kept = np.unique(np.concatenate([starts + parts.argmin(axis=1), starts + parts.argmax(axis=1), *ends]))
    return x[kept], y[kept]


def shrunk(svg, name, alt):
    """Without head, comments, unused identifiers and digits that nobody sees."""
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<!--.*?-->|<metadata>.*?</metadata>", "", svg, flags=re.S)
    used = set(re.findall(r'(?:url\(#|href="#)([^)"]+)', svg))
    svg = re.sub(r' id="([^"]*)"', lambda found: ' id="%s-%s"' % (name, found[1]) if found[1] in used else "", svg)
    svg = re.sub(r'(url\(#|href="#)', r"\g<1>%s-" % name, svg)
    svg = re.sub(r'( d=")([^"]*)', lambda found: found[1] + rounded(found[2], 1).replace("\n", ""), svg)
    svg = re.sub(r'((?:transform|x|y|x1|x2|y1|y2|width|height|style)=")([^"]*)', lambda found: found[1] + rounded(found[2], 2), svg)
    svg = re.sub(r">\s+<", "><", svg)
    head = re.match(r"<svg[^>]*>", svg)[0]
    width, height = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', head).groups()
    new = '<svg viewBox="0 0 %s %s" width="%s" height="%s" role="img" aria-label="%s" xmlns:xlink="http://www.w3.org/1999/xlink">' % (
        width, height, width, height, escape(alt))
    return new + svg[len(head):].strip()


def rounded(text, digits):
    """Numbers with a point: so many digits after it, without zeros at the end."""
    def shorter(found):
        text = ("%.*f" % (digits, float(found[0]))).rstrip("0").rstrip(".")
        return "0" if text in ("", "-0", "-") else text

    return re.sub(r"-?\d+\.\d+", shorter, text)
