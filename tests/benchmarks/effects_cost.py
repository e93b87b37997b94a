#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each effect costs: the table of doc/effects.md.

    effects_cost.py HYBRID WORK_DIR [--write]     prints the table; --write puts it into doc/effects.md
    effects_cost.py HYBRID WORK_DIR --only TEXT[|TEXT...]   rows with one of these in their title, and what they are compared with;
                                                  with --write the table has their costs beside the bases that it has

The Majiagou section with h = 8 m and a sine burst runs without an effect and with it, 400 steps of 1 ms and none, each
five times in turn. Processor time (not wall time: other work on the machine counts little) per step is the difference of the least
of each over the steps; preparation is that of the run without steps; memory is the largest resident.
"""
import json
import os
import pathlib
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "parameters/majiagou/badong_long_periods.prm"
HERE = pathlib.Path(__file__).resolve().parent
PAGE = ROOT / "doc/effects.md"
STEPS, REPETITIONS = 400, 5
BEGIN, END = "<!-- table by tests/benchmarks/effects_cost.py -->", "<!-- end of the table -->"

PLANES = "Bedding planes/Names=bedding_1, bedding_2, bedding_3, bedding_4"
BARE = ["Mesh/Numbers=Resolution/h = 8", "Continuum/Sides=viscous", "Bedding planes/Names=", "Blocks/Damping ratio=0",
        "Water/Level=none", "Motion/Type=sine", "Motion/Frequency=4", "Motion/Taper=1", "Motion/Peak=0.24",
        "Output/Picture interval=0"]
SITE = BARE + ["Model/Blocks=none", "Monitors/Names=D1, B1", "Boreholes/Lines=", "Boreholes/Measured=", "Gravity/Acceleration=0"]
STRONG = BARE + ["Motion/Peak=30"]
WATER = ["Water/Level=175", "Materials/body_saturated/Density=2320"]
SURFACE = "Edge loads/Tractions=fill: 500, 600, 0, 1000, 0, -20e3"

# (title, base or None, overrides). A base stands before the effects that are compared with it.
ROWS = [
    ("**bedrock alone**, viscous sides", None, SITE),
    ("free-field sides", SITE, ["Continuum/Sides=free field"]),
    ("boundary springs", SITE, ["Continuum/Boundary springs=true"]),
    ("elastic bedding planes", SITE, [PLANES]),
    ("bedding planes that slip", SITE, [PLANES, "Bedding planes/Strength=Mohr-Coulomb", "Bedding planes/Friction angle=20",
                                        "Bedding planes/Initial normal stress=1e5"]),
    ("Rayleigh damping", SITE, ["Continuum/Rayleigh mass=0.1", "Continuum/Rayleigh stiffness=1e-4"]),
    ("Maxwell damping of the bedrock", SITE, ["Maxwell damping/Bedrock ratio=0.02"]),
    ("point load", SITE, ["Point loads/Forces=a: 700, 0, 0, 1e6"]),
    ("gravity", SITE, ["Gravity/Acceleration=9.81"]),
    ("**bedrock and blocks**, gravity", None, BARE),
    ("water, `paper`", BARE, ["Water/Level=175", "Water/Method=paper", "Materials/body_saturated/Density=1320"]),
    ("water, `submerged`", BARE, WATER + ["Water/Method=submerged"]),
    ("water, `pressures`", BARE, WATER + ["Water/Method=pressures"]),
    ("water, `submerged`, with a phreatic line", BARE, WATER + ["Water/Method=submerged",
                                                                 "Water/Line file=%s" % (HERE / "majiagou_water_line.csv")]),
    ("water, `pressures`, with a level in time", BARE, WATER[1:] + ["Water/Level=none", "Water/Method=pressures",
                                                             "Water/Level file=%s" % (HERE / "majiagou_water_level.csv")]),
    ("heterogeneity", BARE, ["Heterogeneity/Modulus shape=8", "Heterogeneity/Strength shape=8"]),
    ("block damping", BARE, ["Blocks/Damping ratio=0.05"]),
    ("Maxwell damping of blocks", BARE, ["Maxwell damping/Block ratio=0.05"]),
    ("friction of the belt at its rate", BARE, ["Materials/%s/Friction rate coefficient=0.02" % m for m in ("belt", "belt_saturated")]),
    ("residual strength of the belt", BARE, ["Materials/%s=%s" % pair for pair in (
        ("belt/Residual friction angle", 25), ("belt/Residual cohesion", 30e3),
        ("belt_saturated/Residual friction angle", 12), ("belt_saturated/Residual cohesion", 10e3))]),
    ("initial stress, `1 - sin phi`", BARE, ["Gravity/Initial stress=1 - sin phi"]),
    ("ten lifts", BARE, ["Gravity/Initial stress=staged"]),
    ("dynamic coefficient", BARE, ["Time/Dynamic coefficient=0.999"]),
    ("edge load", BARE, [SURFACE]),
    ("no peak fields (they are on)", BARE, ["Monitors/Peak fields=false"]),
    ("lines, a row every 5 ms: ground, sliding surface", BARE, ["Monitors/Lines=ground; sliding_surface"]),
    ("**the same**, shaken with 30 m/s2", None, STRONG),
    ("strengths that nothing reaches", STRONG, ["Materials/%s/%s=1e9" % (m, s) for m in ("body", "body_saturated", "belt", "belt_saturated")
                                                   for s in ("Cohesion", "Tensile strength")]),
    ("**blocks on a rigid base** (pure DDA)", None, BARE + ["Model/Bedrock=rigid", "Monitors/Names=S1, S2, S3, B1"]),
    ("**bedrock of layers**", None, BARE + [PLANES, "Model/Bedrock=layers"]),
    ("**bedrock of triangles**", None, BARE + [PLANES, "Model/Bedrock=triangles"]),
]


def measure(binary, work, overrides, steps):
    """Processor time [s] and the summary of one run."""
    words = [binary, str(SCENE), "--force", "-s", "Output/Directory=%s" % work, "-s", "Time/Time step=0.001",
             "-s", "Time/End time=%g" % (1e-3 * steps), "-s", "Time/Error estimate=one run", "-s", "Mesh/Error estimate=one run"]
    for override in overrides:
        words += ["-s", override]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True, env=dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1"))
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit("error: %s ended with code %d\n%s" % (" ".join(words), done.returncode, done.stderr[-1000:]))
    summary = json.loads((pathlib.Path(work) / "summary.json").read_text(encoding="utf-8"))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, summary


def chosen_rows():
    """All, or those that --only names with their bases."""
    if "--only" not in sys.argv:
        return ROWS
    texts = sys.argv[sys.argv.index("--only") + 1].split("|")

    def named(title):
        return any(text in title for text in texts)

    bases = [base for title, base, _ in ROWS if named(title)]
    return [row for row in ROWS if named(row[0]) or (row[1] is None and row[2] in bases)]


def main():
    binary, work = sys.argv[1], sys.argv[2]
    rows = chosen_rows()
    best = [[float("inf"), float("inf")] for _ in rows]
    summaries = [None] * len(rows)
    for _ in range(REPETITIONS):
        for i, (_, base, overrides) in enumerate(rows):
            for k, steps in enumerate((0, STEPS)):
                seconds, summaries[i] = measure(binary, work, (base or []) + overrides, steps)
                best[i][k] = min(best[i][k], seconds)
    lines = ["| scene or effect | ms per step | more by | iterations per step | preparation [s] | memory [MB] | more by |",
             "|---|---|---|---|---|---|---|"]
    for i, (title, base, _) in enumerate(rows):
        step = (best[i][1] - best[i][0]) / STEPS * 1e3
        memory = summaries[i]["peak_memory_mb"]
        if base is None:
            base_step, base_memory = step, memory
        failed = sum(summaries[i]["joints"][kind] for kind in ("tensile", "shear"))
        title += ": %d joints fail" % failed if failed else ""
        lines.append("| %s | %.2f | %s | %.1f | %.1f | %.0f | %s |" % (
            title, step, "" if base is None else "%+.0f %%" % (100 * (step / base_step - 1)),
            summaries[i]["iterations"] / summaries[i]["steps"], best[i][0], memory,
            "" if base is None else "%+.0f" % (memory - base_memory)))
    print("\n".join(lines))
    if "--write" in sys.argv:
        text = PAGE.read_text(encoding="utf-8")
        head, tail = text[: text.index(BEGIN) + len(BEGIN)], text[text.index(END):]
        if "--only" in sys.argv:
            lines = merged(text[len(head):-len(tail)].strip().split("\n"), [line for line, row in zip(lines[2:], rows) if row[1] is not None])
        PAGE.write_text(head + "\n" + "\n".join(lines) + "\n" + tail, encoding="utf-8")


def merged(old, new):
    """The lines of a table with those that are new, in the order of ROWS."""
    def title(line):
        return line.split("|")[1].split(":")[0].strip()  # without what fails

    found = {title(line): line for line in old[2:] + new}
    unknown = set(found) - {row[0] for row in ROWS}
    if unknown:
        sys.exit("error: the table has rows that are none of ROWS: %s" % ", ".join(sorted(unknown)))
    return old[:2] + [found[row[0]] for row in ROWS if row[0] in found]


if __name__ == "__main__":
    main()
