# SPDX-License-Identifier: GPL-3.0-or-later
"""The coarser runs that a run is compared with: the same scene with a coarser mesh, or with longer steps."""

import os
import re
import subprocess
from dataclasses import dataclass

from hybrid_run import UserError
from hybrid_run.parameters import parameters_of_run
from hybrid_tools.study import program
from hybrid_tools.study.run_directory import read_json, reason_of, write_json

LEAST_GAIN = 0.4  # of blocks or unknowns that twice the size may leave
NUMBER = r"[-+0-9.eE]+"
QUIET = ["Output/Picture interval=0", "Time/Error target=none", *program.ONE_RUN]  # nobody looks at them


@dataclass
class Coarser:
    """One of them. factor: its step or mesh over that of the run. overrides: -s of it."""

    kind: str  # "mesh" or "step"
    factor: int
    overrides: list

    @property
    def name(self):
        return "%s_%d" % (self.kind, self.factor)


def sizes_in(geometry):
    """{name: default} of the numbers Resolution/... that a .geo file defines."""
    found = {}
    for default, rest in re.findall(r"=\s*\{\s*(%s)([^{}]*)\}" % NUMBER, geometry):
        name = re.search(r'Name\s+"(Resolution/[^"]+)"', rest)
        if name:
            found[name[1]] = float(default)
    return found


def mesh_sizes(parameters):
    """{name: value} of the Resolution/... of a run's mesh, and the other numbers that it was given as they are written."""
    path = parameters["Mesh/File"]
    sizes, others = {}, []
    if path.endswith(".geo"):
        with open(path, encoding="utf-8", errors="replace") as file:
            sizes = sizes_in(file.read())
    for pair in filter(None, (pair.strip() for pair in parameters.get("Mesh/Numbers", "").split(";"))):
        name, _, value = (word.strip() for word in pair.partition("="))
        if name in sizes:
            sizes[name] = float(value)
        else:
            others.append(pair)
    return sizes, others


def coarser_mesh(parameters, factor):
    """With sizes `factor` times as large; None if the mesh has none that could be."""
    sizes, others = mesh_sizes(parameters)
    if not sizes:
        return None
    numbers = others + ["%s = %.12g" % (name, factor * size) for name, size in sizes.items()]
    return Coarser("mesh", factor, ["Mesh/Numbers=" + "; ".join(numbers)])


def longer_steps(parameters, factor):
    return Coarser("step", factor, ["Time/Time step=%.12g" % (factor * float(parameters["Time/Time step"]))])


def parameters(directory):
    """Of a run that has finished. @raises UserError"""
    if not os.path.isfile(os.path.join(directory, "summary.json")):
        raise UserError("'%s' is no directory of a run that has ended: there is no summary.json in it" % directory)
    if not read_json(os.path.join(directory, "summary.json")).get("finished"):
        raise UserError("the run in '%s' has not finished; hybrid --resume %s goes on with it" % (directory, directory))
    return parameters_of_run(directory)


def changed_files(directory, scene):
    """Files of a run's scene that are younger than the run."""
    begun = os.path.getmtime(os.path.join(directory, "params.used.prm"))
    names = [value for path, value in scene.items() if path.split("/")[-1].lower().endswith("file") and value]
    return [name for name in names if os.path.isfile(name) and os.path.getmtime(name) > begun]


def counts(directory):
    """{what: how many} of a run's mesh."""
    summary = read_json(os.path.join(directory, "summary.json"))
    found = {"blocks": summary.get("blocks", 0), "unknowns": summary.get("continuum_unknowns", 0)}
    return {name: number for name, number in found.items() if number}


def unchanged(directory, finer):
    """{what: (how many, in the finer run)} of what has not become far fewer in a mesh. Twice the size leaves a quarter."""
    now, before = counts(directory), counts(finer)
    return {name: (now[name], number) for name, number in before.items() if now.get(name, 0) > LEAST_GAIN * number}


def is_coarser(directory, finer):
    """Blocks are the coarsest part of a mesh: where there are some, they count. Else the unknowns of the bedrock do."""
    return next(iter(counts(finer)), "") not in unchanged(directory, finer)


def run_program(words):
    """(exit code, what it said). What ends this tool ends the run, too."""
    with subprocess.Popen([program.path(), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace") as child:
        try:
            out, err = child.communicate()
        except BaseException:
            child.terminate()
            child.wait()
            raise
    return child.returncode, err + out


def compute(directory, coarser):
    """Directory of the coarser run, which is computed unless it is there. @raises UserError with the reason if it fails."""
    path = os.path.join(directory, "accuracy", coarser.name)
    scene, overrides = os.path.join(directory, "params.used.prm"), coarser.overrides + QUIET
    with open(scene, encoding="utf-8") as file:
        made_of = {"scene": file.read(), "overrides": overrides, "program": program.version()}
    if read_json(os.path.join(path, "made_of.json")) == made_of and read_json(os.path.join(path, "summary.json")).get("finished"):
        return path
    code, said = run_program([scene, "--force"] + program.options(overrides + ["Output/Directory=" + path]))
    if code != 0:
        raise UserError(reason_of(said))
    write_json(os.path.join(path, "made_of.json"), made_of)
    return path
