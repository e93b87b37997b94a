# SPDX-License-Identifier: GPL-3.0-or-later
"""A Snakemake workflow of a study: one job per run, then the tables; any profile of a scheduler takes it."""

import json
import os
import shlex

from hybrid_tools.study import program

TEXT = '''# Written by hybrid study. To compute the study:
#     snakemake --snakefile {path} --cores all --resources mem_mb={memory}
# or with a profile of a scheduler: snakemake --snakefile ... --profile PROFILE
# A job that is killed goes on from its checkpoint when it is tried again (--retries). A run that fails by itself is a row of the tables.
STUDY = {directory}
HYBRID = {program}
RUNS = {runs}


rule all:
    input:
        STUDY + "/tables/runs.csv"


rule run:
    output:
        touch(STUDY + "/ended/{{name}}")
    threads: lambda wildcards: RUNS[wildcards.name]["threads"]
    resources:
        mem_mb=lambda wildcards: RUNS[wildcards.name]["mem_mb"]
    params:
        study=STUDY
    shell:
        "{{HYBRID}} study {{params.study:q}} --only {{wildcards.name:q}}"


rule tables:
    input:
        expand(STUDY + "/ended/{{name}}", name=RUNS)
    output:
        STUDY + "/tables/runs.csv"
    params:
        study=STUDY
    shell:
        "{{HYBRID}} study {{params.study:q}} --collect"
'''


def write(study, runs):
    """Snakefile in the study's directory. @return its path."""
    path = os.path.join(study.directory, "Snakefile")
    of_runs = {os.path.basename(run.path): {"threads": run.manifest["threads"], "mem_mb": max(1, round(1.5 * run.manifest["memory_mb"]))}
               for run in runs}
    memory = round(sum(entry["mem_mb"] for entry in of_runs.values()))
    with open(path, "w", encoding="utf-8") as file:
        file.write(TEXT.format(path=shlex.quote(path), directory=json.dumps(study.directory), program=json.dumps(shlex.quote(program.path())),
                               runs=json.dumps(of_runs, indent=4), memory=memory))
    return path
