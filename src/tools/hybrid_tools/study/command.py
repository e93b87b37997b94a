# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid study: runs a scene with varied parameters and says what accuracy costs in time. See doc/study.md."""

import itertools
import os
import sys

from hybrid_run import UserError
from hybrid_run.parameters import parse_parameters
from hybrid_tools.arguments import Arguments
from hybrid_tools.results_place import default_directory
from hybrid_tools.study import axes, page, plan, program, runner, stated, study_file, workflow
from hybrid_tools.study.run_directory import RunDirectory, read_json, write_json

AUTOMATIC_SEEDS = 3

EXAMPLES = """\
  hybrid study slope.prm --vary "Time/Time step=4e-3,2e-3,1e-3" --tolerance 2%
  hybrid study slope.prm --vary "Mesh/Numbers=Resolution/h = 8|4|2" --vary "Time/Time step=2e-3,1e-3" --jobs 2
  hybrid study slope.prm --effect "Continuum/Sides=viscous" --effect "Blocks/Damping ratio=0"
  hybrid study slope.toml                        # a study file
  hybrid study output/slope-study                # go on with an interrupted study
  hybrid study output/slope-study --collect      # tables of what there is
"""


ABOUT = "What accuracy costs in time: a scene with varied parameters. Repeat the command to go on; nothing is computed twice."
SETTING = '"Section/Name=value"'


def arguments():
    found = Arguments("study", ABOUT, EXAMPLES)
    add = found.add_argument
    add("what", metavar="SCENE.prm|STUDY.toml|DIRECTORY", help="a scene, a study file, or the directory of a study")
    add("--vary", action="append", default=[], metavar='"Section/Name=a,b"',
        help="values of one parameter, with | instead of commas where values have commas; several parameters make a grid")
    add("--effect", action="append", default=[], metavar=SETTING,
        help="one more run of the finest setting with this; \"NAME: A=a | B=b\" for several parameters")
    add("-s", dest="set", action="append", default=[], metavar=SETTING, help="of every run")
    add("--finest", action="append", default=[], metavar=SETTING,
        help="the value that the others are compared with, where the tool cannot know")
    add("--closed-form", action="append", default=[], metavar='"monitor/quantity=value"',
        help="true value in SI units, or a CSV file of a history: time, x, y")
    add("--quantities", metavar="PATTERNS", help="what the error counts, such as \"crest/*,slip/*\"; default: everything that converges")
    add("--tolerance", metavar="2%", help="ask for the cheapest setting with a smaller error")
    add("--seeds", type=int, metavar="N",
        help="the finest run N times more with Young's moduli larger by millionths; default: %d if something does not converge"
        % AUTOMATIC_SEEDS)
    add("--jobs", type=int, default=1, metavar="N",
        help="runs side by side, as far as cores and memory allow; default 1: times are taken alone")
    add("--repeat", type=int, default=1, metavar="N", help="run everything N times and take the least time of each; default 1")
    add("--pictures", action="store_true", help="runs write pictures for ParaView, which their times then include")
    add("--directory", "--output", metavar="DIRECTORY", help="of the study; default output/NAME-study")
    add("--retry", action="store_true", help="compute runs that failed again")
    add("--plan", action="store_true", help="list the runs with the memory that they take; compute nothing")
    add("--collect", action="store_true", help="tables and figures of what there is; compute nothing")
    add("--page", metavar="FILE", help="put what the study says into this page too, as into doc/accuracy-vs-time.md")
    add("--snakemake", action="store_true", help="write a Snakemake workflow of the study; compute nothing")
    add("--only", metavar="NAME", help="compute one run (the workflow calls this)")
    return found


def split(text, option):
    """Name and value of NAME=value."""
    name, equals, value = text.partition("=")
    if not equals or not name.strip() or not value.strip():
        raise UserError("%s needs \"name=value\", not '%s'" % (option, text))
    return name.strip(), value.strip()


def content_of_words(words):
    """What the command line says, as a study file would."""
    content = {"set": words.set, "vary": [axes.parse_axis(text) for text in words.vary], "closed_form": {}, "effects": {},
               "finest": dict(split(text, "--finest") for text in words.finest)}
    for text in words.effect:
        name, colon, overrides = text.partition(": ")
        overrides = [override.strip() for override in (overrides if colon and "=" not in name else text).split("|")]
        content["effects"][name if colon and "=" not in name else ", ".join(overrides)] = overrides
    for text in words.closed_form:
        name, value = split(text, "--closed-form")
        content["closed_form"][name] = axes.number(value) if axes.number(value) is not None else os.path.abspath(value)
    return content


def make_study(words):
    """The study that the words ask for. @raises UserError for what is wrong with it."""
    if not os.path.exists(words.what):
        raise UserError("there is no '%s': give a scene, a study file or the directory of a study" % words.what)
    own = content_of_words(words)
    content = study_file.read(words.what) if words.what.endswith(".toml") else {"scene": words.what}
    varied = [axes.make_axis(key, values) for key, values in content.get("vary", {}).items()] + own["vary"]
    effects = dict(content.get("effects", {}), **own["effects"])
    if not varied and not effects and not (words.seeds or content.get("seeds")):
        raise UserError("nothing is varied: give --vary, --effect or --seeds")
    names = [axis.name for axis in varied]
    for name in names:
        if names.count(name) > 1:
            raise UserError("%s is varied twice" % name)
    finest = dict(content.get("finest", {}), **own["finest"])
    for name, value in finest.items():
        if name not in names:
            raise UserError("--finest %s: the parameter is not varied" % name)
    for axis in varied:
        axes.sort_levels(axis, str(finest[axis.name]) if axis.name in finest else None)
    scene = os.path.abspath(content["scene"])
    common = content.get("set", []) + own["set"]
    if any(text.startswith("Output/Directory") for text in common):
        raise UserError("-s Output/Directory: each run of a study has a directory of its own; --directory names that of the study")
    if not words.pictures and not any(text.startswith("Output/Picture interval") for text in common):
        common.append(plan.PICTURES_OFF)
    directory = os.path.abspath(words.directory or content.get("directory") or default_directory(words.what, "-study"))
    given = dict(content.get("closed_form", {}), **own["closed_form"])
    study = plan.Study(scene, directory, common, varied, effects, dict(stated_closed_forms(scene, varied, common), **given), seeds=content.get("seeds"),
                       quantities=content.get("quantities", []),
                       tolerance=plan.parse_tolerance(content["tolerance"]) if "tolerance" in content else None)
    refuse_other_scene(study)
    check(study)
    return study


def stated_closed_forms(scene, varied, common):
    """Those of the scene, unless the study is of another problem."""
    found = stated.read(scene) if os.path.isfile(scene) else {}
    other = stated.other_problem(varied, common) if found else ""
    if other:
        print("note      the closed form that the scene states is left out: %s makes it another problem" % other)
    return {} if other else found


def check(study):
    """Ask the program about every level, one of each parameter at a time, and every effect. @raises UserError with what it refuses."""
    study.text = program.parameters_text(study.scene, study.common)
    study.base = parse_parameters(study.text.splitlines())
    for levels in itertools.zip_longest(*(range(len(axis.labels)) for axis in study.axes)):
        overrides = [axis.override(level, study.base) for axis, level in zip(study.axes, levels) if level is not None]
        program.parameters(study.scene, study.common + overrides)
    for axis in study.axes:
        if axis.entry:  # names of numbers of the mesh are known when it is made: of the coarsest, it takes least
            program.ask("--check", study.scene, *program.options(study.common + [axis.override(0, study.base), "Output/Directory=none"]))
    for overrides in study.effects.values():
        program.parameters(study.scene, study.common + overrides)
    for name in study.closed_forms:
        if name.count("/") != 1:
            raise UserError("closed form '%s': the name is \"monitor/quantity\", such as \"crest/final displacement\"" % name)


def read_study(words):
    """A study that is there, or a new plan; --tolerance, --quantities and --seeds may change."""
    if os.path.isdir(words.what):
        content = read_json(os.path.join(words.what, "plan.json"))
        if not content:
            raise UserError("'%s' holds no plan.json; give a scene, a study file or the directory of a study" % words.what)
        if words.vary or words.effect or words.set or words.finest or words.closed_form or words.directory or words.pictures:
            raise UserError("'%s' is a study: --vary, --effect, -s, --finest, --closed-form, --pictures and --directory go with a scene or "
                            "a study file" % words.what)
        study = plan.from_json(dict(content, directory=os.path.abspath(words.what)))
    else:
        study = make_study(words)
        if study.seeds is None:  # those that an earlier run of the command found necessary
            study.seeds = read_json(os.path.join(study.directory, "plan.json")).get("seeds")
    if words.tolerance:
        study.tolerance = plan.parse_tolerance(words.tolerance)
    if words.quantities:
        study.quantities = [pattern.strip() for pattern in words.quantities.split(",")]
    if words.seeds is not None:
        study.seeds = words.seeds
    if (study.seeds or 0) < 0 or words.jobs < 1 or words.repeat < 1:
        raise UserError("--seeds is at least 0, --jobs and --repeat at least 1")
    return study


def refuse_other_scene(study):
    """@raises UserError if the directory holds the study of another scene."""
    earlier = read_json(os.path.join(study.directory, "plan.json")).get("scene", study.scene)
    if earlier != study.scene:
        raise UserError("'%s' holds the study of '%s'; give another --directory" % (os.path.relpath(study.directory), os.path.relpath(earlier)))


def save(study):
    """plan.json, and the scene with every parameter: what the runs are computed from, whatever becomes of its file.

    @raises UserError if the directory holds the study of another scene.
    """
    os.makedirs(study.directory, exist_ok=True)
    refuse_other_scene(study)
    if study.text:
        with open(scene_of(study), "w", encoding="utf-8") as file:
            file.write(study.text)
    write_json(os.path.join(study.directory, "plan.json"), study.to_json())


def scene_of(study):
    return os.path.join(study.directory, "scene.prm")


def compute(study, settings, words):
    """Compute what is missing. @return whether it was not interrupted."""
    runs = runner.plan_runs(study, settings)
    missing = [run for run in runs if run.is_to_run(words.retry, words.repeat)]
    if words.jobs > 1:
        runner.estimate(missing, scene_of(study))
    if len(missing) < len(runs):
        print("%d of %d runs are there already" % (len(runs) - len(missing), len(runs)))
    return runner.Runner(scene_of(study), words.jobs, repeats=words.repeat, tell=lambda text: print(text, flush=True)).compute(missing)


def compute_only(study, name):
    """One run, for a workflow: it has come to an end if the exit code is 0, be it a failure."""
    run = RunDirectory(study.directory, name)
    if not run.manifest:
        raise UserError("the study in '%s' has no run '%s'" % (study.directory, name))
    if run.is_to_run():
        runner.Runner(scene_of(study), taken="by a scheduler").compute([run])
    return 0 if run.state == "done" or (run.state == "failed" and not run.is_to_run()) else 1


def show_plan(study, runs):
    runner.estimate(runs, scene_of(study))
    for run in runs:
        print("%-8s %6.0f MB  %s" % (run.state, run.manifest["memory_mb"], runner.title(run.manifest)))
    print("%d runs in %s" % (len(runs), os.path.relpath(study.directory)))
    return 0


def needs_seeds(study, settings):
    """Whether copies of the finest run would tell what its levels cannot."""
    from hybrid_tools.study import collection  # only now: it draws

    return collection.needs_seeds(study, settings)


def show(study, settings, words):
    """Tables, figures and words of what there is. @return the analysis."""
    from hybrid_tools.study import collection  # only now: it draws

    analysis = collection.collect(study, settings)
    if words.page:
        page.put(words.page, analysis)
    return analysis


def main(words):
    runner.die_with_parent()
    words = arguments().read(words)
    study = read_study(words)
    if words.only:
        return compute_only(study, words.only)
    if words.page:
        page.check(words.page, study)
    locked = None if words.collect else runner.lock(study.directory)
    save(study)
    settings = study.settings(study.seeds or 0)
    if words.plan:
        return show_plan(study, runner.plan_runs(study, settings))
    if words.snakemake:
        runs = runner.plan_runs(study, settings)
        runner.estimate(runs, scene_of(study))
        print("wrote %s, %d runs" % (os.path.relpath(workflow.write(study, runs)), len(runs)))
        return 0
    if words.collect:
        show(study, settings, words)
        return 0
    is_whole = compute(study, settings, words)
    if is_whole and study.seeds is None and needs_seeds(study, settings):
        print("something does not converge, or to and fro: %d seeds of the finest run" % AUTOMATIC_SEEDS)
        study.seeds = AUTOMATIC_SEEDS
        save(study)
        settings = study.settings(study.seeds)
        is_whole = compute(study, settings, words)
    analysis = show(study, settings, words)
    os.close(locked)
    if not is_whole:
        print("interrupted; to go on: hybrid study %s" % os.path.relpath(study.directory), file=sys.stderr)
        return 130
    return 1 if any(result.run.state == "failed" for result in analysis.results.values()) else 0
