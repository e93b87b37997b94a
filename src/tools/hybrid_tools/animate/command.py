# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid animate RUN: RUN/figures/motion.mp4, or .gif without ffmpeg, from its pictures (blocks.pvd, joints.pvd, continuum.pvd)."""

import os
import shutil
import sys

import numpy as np

from hybrid_run import MissingData, Run, UserError
from hybrid_tools.arguments import Arguments

SHORTEST, LONGEST = 4.0, 15.0  # of a film, unless --speed says otherwise [s]
FASTEST = {"mp4": 25.0, "gif": 10.0}  # frames per second, unless --fps says otherwise
MOST_FRAMES = 5000


def positive(text):
    value = float(text)
    if not 0 < value < np.inf:
        raise ValueError
    return value


positive.__name__ = "number above 0"  # as argparse calls it


def format_of(given):
    """mp4 or gif: as asked for, else by the file's name, else mp4 where ffmpeg is."""
    ending = os.path.splitext(given.output or "")[1][1:].lower()
    if given.output and ending not in FASTEST:
        raise UserError("--output '%s' ends neither with .mp4 nor with .gif" % given.output)
    if given.format and ending and given.format != ending:
        raise UserError("--format %s and --output '%s' do not fit" % (given.format, given.output))
    chosen = given.format or ending or ("mp4" if shutil.which("ffmpeg") else "gif")
    if chosen == "mp4" and not shutil.which("ffmpeg"):
        raise UserError("mp4 needs the program ffmpeg (on Debian: apt-get install ffmpeg); --format gif needs nothing")
    return chosen


def timing(times, speed, fps, fastest):
    """(numbers of the pictures that are frames, frames per second): the picture nearest to each frame, none twice in a row."""
    span = times[-1] - times[0]
    length = span / speed if speed else np.clip(span, SHORTEST, LONGEST)
    if fps is None:
        fps = min(fastest, max(1.0, (len(times) - 1) / length))
    n = int(round(length * fps)) + 1
    if n > MOST_FRAMES:
        raise UserError("--speed and --fps want %d frames, at most %d are drawn" % (n, MOST_FRAMES))
    wanted = np.linspace(times[0], times[-1], max(n, 2))
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    return np.where(wanted - times[after - 1] < times[after] - wanted, after - 1, after), fps


def round_scale(wanted):
    """1, 2 or 5 times a power of ten, not above what is wanted."""
    power = 10.0 ** np.floor(np.log10(wanted))
    return power * max(k for k in (1, 2, 5) if k * power <= wanted * (1 + 1e-9))


def fitting_scale(extent):
    """1 where motions can be seen; else what makes the largest 3 % of the section."""
    size = max(extent.first[1] - extent.first[0])
    return 1.0 if extent.moved > 0.02 * size or extent.moved == 0 else max(1.0, round_scale(0.03 * size / extent.moved))


def writer_of(chosen, fps):
    from matplotlib import animation

    if chosen == "gif":
        return animation.PillowWriter(fps=fps)
    # yuv420p and faststart: what browsers play at once
    return animation.FFMpegWriter(fps=fps, codec="h264", extra_args=["-pix_fmt", "yuv420p", "-crf", "24", "-movflags", "+faststart"])


def progress(frame, n):
    if sys.stderr.isatty():
        print("\rframe %d of %d" % (frame + 1, n), end="\n" if frame + 1 == n else "", file=sys.stderr, flush=True)


def animate(run, given, chosen):
    """@return the file's name."""
    from hybrid_tools import style

    from .film import DPI, Film
    from .motion import Extent, Motion

    style.apply()
    motion = Motion(run)
    if motion.blocks is None:
        raise MissingData("'%s' has no blocks that move; pictures of a continuum alone are for ParaView" % run.directory)
    frames, fps = timing(motion.times, given.speed, given.fps, FASTEST[chosen])
    once = np.unique(frames)
    motion.scale = given.scale or fitting_scale(Extent(motion, given.color, once))
    film = Film(motion, Extent(motion, given.color, once), given.color, given.whole)
    path = given.output or os.path.join(run.directory, "figures", "motion." + chosen)
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    writer = writer_of(chosen, fps)
    with writer.saving(film.figure, path, DPI):
        for number, k in enumerate(frames):
            film.draw(k)
            writer.grab_frame()
            progress(number, len(frames))
    span = motion.times[-1] - motion.times[0]
    print("%s: %d frames, %.3g s for %.3g s, %.1f MB%s" % (path, len(frames), len(frames) / fps, span, os.path.getsize(path) / 1e6,
                                                       "" if motion.scale == 1 else ", displacements times %g" % motion.scale))
    return path


def words_of(words):
    arguments = Arguments("animate", "A film of a run: blocks where they are, joints that fail, the motion of the ground.",
                          "  hybrid animate output/badong\n  hybrid animate output/badong --scale 200 --speed 0.5 --output slide.gif\n")
    arguments.add_argument("run", metavar="RUN", help="output directory of a run, with the pictures of its blocks")
    arguments.add_argument("--output", metavar="FILE", help="where to (default: RUN/figures/motion.mp4 or .gif)")
    arguments.add_argument("--format", choices=("mp4", "gif"), help="default: mp4 if ffmpeg is installed, else gif")
    arguments.add_argument("--fps", type=positive, help="frames per second (default: all pictures, at most 25, gif 10)")
    arguments.add_argument("--speed", type=positive, help="seconds of the run in one of the film (default: 1, so that it lasts 4 to 15 s)")
    arguments.add_argument("--scale", type=positive, help="draw displacements so many times as large, 1 as they are"
                                                          " (default: 1, or what makes small ones visible; the film says it)")
    arguments.add_argument("--color", choices=("displacement", "velocity"), default="displacement",
                           help="what colours mean (default: displacement)")
    arguments.add_argument("--whole", action="store_true", help="show the whole section, not only where blocks are")
    return arguments.read(words)


def film_of(run):
    """The film of a run as it is without options."""
    given = words_of([run.directory])
    return animate(run, given, format_of(given))


def main(words):
    given = words_of(words)
    chosen = format_of(given)
    animate(Run(given.run), given, chosen)
    return 0
