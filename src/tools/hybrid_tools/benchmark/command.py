# SPDX-License-Identifier: GPL-3.0-or-later
"""hybrid benchmark [ROW ...]: times the scenes of parameters/benchmarks, each alone in turn, and compares with an earlier time or program.

Processor time, not wall time: other work on the machine counts less, though it still takes the caches. The least of the repetitions counts.
"""

import json
import os
import sys

from hybrid_run import UserError
from hybrid_tools import marked_page
from hybrid_tools.arguments import Arguments
from hybrid_tools.benchmark import catalogue, machine, measure, results
from hybrid_tools.study import program

ENOUGH = 60.0  # of processor time: a row that took more is not repeated unless --repeat says so [s]
OTHER_LOAD = 0.15  # cores
BEGIN, END = "<!-- tables by hybrid benchmark -->", "<!-- end of the tables -->"
EXAMPLES = """  hybrid benchmark                              # all rows that take less than a minute or so
  hybrid benchmark slide rest --repeat 5        # two families
  hybrid benchmark --against old/benchmark.json # ratio of each row to an earlier measurement
  hybrid benchmark badong_4 --beside ../old/build/release/hybrid     # two programs in turn: best on a shared machine
  hybrid benchmark my.prm -s "Time/End time=0.1"                     # any scene: ms per step
  hybrid benchmark --list
"""


def read_words(words):
    arguments = Arguments("benchmark", "How fast the program is: scenes of parameters/benchmarks, each alone in turn, with processor time.",
                          EXAMPLES)
    arguments.add_argument("rows", metavar="ROW", nargs="*", help="a row, a family of rows, a pattern with *, or a scene's file")
    arguments.add_argument("--long", action="store_true", help="long rows, too (hours)")
    arguments.add_argument("--repeat", type=int, metavar="N", help="repetitions (default 3, or 1 beyond %.0f s)" % ENOUGH)
    arguments.add_argument("--limit", type=float, metavar="SECONDS",
                           help="processor time after which a run is ended; its row says how far it came (default 600, of long rows none)")
    arguments.add_argument("-s", dest="overrides", metavar='"Section/Name=value"', action="append", default=[],
                           help="override one parameter in every scene")
    arguments.add_argument("--against", metavar="FILE", help="benchmark.json of an earlier measurement")
    arguments.add_argument("--beside", metavar="PROGRAM", help="another build of hybrid, which takes turns with this one")
    arguments.add_argument("--output", metavar="DIR", default="output/benchmark", help="where results go (default output/benchmark)")
    arguments.add_argument("--page", metavar="FILE", help="put the tables into this page too, as into doc/performance.md")
    arguments.add_argument("--list", action="store_true", help="the rows, and nothing else")
    found = arguments.read(words)
    if found.repeat is not None and found.repeat < 1:
        raise UserError("--repeat is %d: 1 and more are allowed" % found.repeat)
    if found.limit is not None and not found.limit > 0:
        raise UserError("--limit is %g: more than 0 s are allowed" % found.limit)
    if found.against and found.beside:
        raise UserError("--against and --beside exclude each other: one thing is compared with")
    if found.page:
        marked_page.around(found.page, BEGIN, END)
    if found.beside and not os.access(found.beside, os.X_OK):
        raise UserError("--beside '%s' is no program" % found.beside)
    return found


def limit_of(row, words):
    return words.limit or (None if row.is_long else 600.0)


def once(path, row, directory, words):
    """(value or None where it follows from the summary, summary) of one repetition."""
    if row.kind == catalogue.THREADS:
        return measure.on_threads(path, row, directory, words.overrides, limit_of(row, words))
    return None, measure.run(path, row, directory, words.overrides, limit_of(row, words))


def measure_row(programs, row, words):
    """A result for each program: they take turns, the first of them first."""
    found, failed = [[] for _ in programs], [False] * len(programs)
    repetitions, done = words.repeat or 3, 0
    while done < repetitions:
        for p, path in enumerate(programs):
            directory = os.path.join(words.output, "runs", row.name + ("_beside" if p else ""))
            try:
                found[p].append(once(path, row, directory, words))
            except measure.TookTooLong:
                failed[p] = True
        done += 1
        taken = max((summary["processor_time_s"] for runs in found for _, summary in runs), default=ENOUGH)
        if any(failed) or (words.repeat is None and done * taken >= ENOUGH):
            break
    made = []
    for runs, has_failed in zip(found, failed):
        values = [value for value, _ in runs] if row.kind == catalogue.THREADS else None
        made.append(results.no_result(row, limit_of(row, words)) if has_failed
                    else results.result(row, [summary for _, summary in runs], values))
    return made


def tell(found, old):
    ratio = results.time_ratio(found, old)
    iterations = found.get("iterations_per_step")
    counts = "" if iterations is None else "%.3g iterations/step, %d cuts" % (iterations, found["cuts"])
    print("%-20s %-32s %s%s" % (
        found["row"], results.value_text(found), counts, "" if ratio is None else "   %.3g times as long as before" % ratio), flush=True)


def write(words, facts, rows, before, name):
    """benchmark.json and .md. @return the table."""
    growth = results.growth(rows)
    old = {r["row"]: r for r in before["rows"]} if before else None
    made = results.table(rows, old, name)
    lines = results.growth_text(growth, before.get("growth") if before else None)
    content = dict(facts, overrides=words.overrides, rows=rows, growth=growth)
    if before:
        content["against"] = {"name": name, "program": before.get("program"), "machine": before.get("machine"),
                              "time_ratio": {r["row"]: results.time_ratio(r, old.get(r["row"])) for r in rows}}
        if words.beside:
            content["against"]["rows"] = before["rows"]
    with open(os.path.join(words.output, "benchmark.json"), "w", encoding="utf-8") as file:
        json.dump(content, file, indent=2)
        file.write("\n")
    text = page_text(facts, rows, made, lines)
    with open(os.path.join(words.output, "benchmark.md"), "w", encoding="utf-8") as file:
        file.write("# Benchmark\n\n" + text)
    if words.page:
        marked_page.put(words.page, BEGIN, END, text)
    return made, lines


def page_text(facts, rows, made, lines):
    """Machine, tables and growth in Markdown."""
    kinds = dict.fromkeys(r["kind"] for r in rows)
    said = ["- %s: %s." % (catalogue.UNITS[kind], catalogue.MEANINGS[kind]) for kind in kinds]
    return "\n".join(headline(facts) + ["", made.markdown(), ""] + said + ["- " + line for line in lines] + [
        "", "Where the wall time goes (of the time loop; `static_*`: of the static stage):", "", results.parts_table(rows).markdown(), ""])


def headline(facts):
    m, p = facts["machine"], facts["program"]
    kernels = p.get("OpenBLAS", "?").partition(" MAX_THREADS")[0].split()[-1]
    return ["%s, %d cores, %s GB, load %g at the start.  " % (m["processor"], m["cores"], m["memory_GB"], m["load_at_start"]),
            "%s, commit %s, GCC %s, %s, OpenBLAS for %s." % (p["version"], p["commit"], p.get("compiler", "?"), p.get("flags", "flags unknown"),
                                                             kernels)]


def show_list():
    for row in catalogue.ROWS:
        goal = "" if row.goal is None else "goal %s" % results.number_text(row.goal)
        print("%-20s %-22s %-14s %s" % (row.name, row.unit, goal, "long" if row.is_long else ""))
    return 0


def main(words):
    found = read_words(words)
    if found.list:
        return show_list()
    rows = catalogue.choose(found.rows, found.long)
    before, name = (results.read(found.against), "before") if found.against else (None, "")
    programs = [program.path()] + ([found.beside] if found.beside else [])
    facts = {"machine": machine.machine(), "program": machine.program(programs[0])}
    if found.beside:
        before, name = {"program": machine.program(found.beside), "rows": []}, "beside"
    os.makedirs(found.output, exist_ok=True)
    made, table = [], None
    print("\n".join(headline(facts)).replace("  \n", "\n"), flush=True)
    for row in rows:
        pair = measure_row(programs, row, found)
        made.append(pair[0])
        if found.beside:
            before["rows"].append(pair[1])
            before["growth"] = results.growth(before["rows"])
        old = next((r for r in before["rows"] if r["row"] == row.name), None) if before else None
        tell(pair[0], old)
        table, lines = write(found, facts, made, before, name)  # after each row: Ctrl-C loses little
    print("\n" + "\n".join([table.text(without_repeats=False)] + lines))
    disturbed = [r["row"] for r in made if r.get("other_load", 0) > OTHER_LOAD and r["row"] != "threads_beside_work"]
    if disturbed:
        print("warning: other work took part of the machine during %s: compare counts, or programs in turn (--beside)"
              % ", ".join(disturbed), file=sys.stderr)
    print("files    %s: benchmark.json, benchmark.md, runs/" % found.output)
    return 0
