# SPDX-License-Identifier: GPL-3.0-or-later
"""Facts without which a time means nothing: processor, memory, system, program, compiler and its flags."""

import os
import platform
import subprocess

from hybrid_run import UserError


def first(path, key):
    """Value of "key : value" in a file of /proc, or ""."""
    try:
        with open(path, encoding="utf-8", errors="replace") as lines:
            return next((line.partition(":")[2].strip() for line in lines if line.startswith(key)), "")
    except OSError:
        return ""


def text(path):
    """Of a small file, without the end of its line."""
    with open(path, encoding="ascii") as file:
        return file.read().strip()


def caches():
    """{"L1d": "48K", ...} of the first core, as far as the system tells."""
    found, root = {}, "/sys/devices/system/cpu/cpu0/cache"
    for index in sorted(os.listdir(root)) if os.path.isdir(root) else ():
        try:
            level, kind, size = (text(os.path.join(root, index, name)) for name in ("level", "type", "size"))
        except OSError:
            continue
        found["L" + level + {"Data": "d", "Instruction": "i"}.get(kind, "")] = size
    return found


def machine():
    """What computes."""
    memory = first("/proc/meminfo", "MemTotal").split()
    return {"processor": first("/proc/cpuinfo", "model name") or platform.processor(), "MHz": first("/proc/cpuinfo", "cpu MHz"),
            "cores": len(os.sched_getaffinity(0)), "caches": caches(), "memory_GB": round(int(memory[0]) / 2**20, 1) if memory else None,
            "system": platform.platform(), "load_at_start": round(os.getloadavg()[0], 2)}


def program(path):
    """{"version", "commit", "compiler", "flags", ...}: what a program says of itself. @raises UserError if it does not."""
    try:
        done = subprocess.run([path, "--version"], capture_output=True, text=True, errors="replace", check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise UserError("'%s' does not tell its version: %s" % (path, error)) from error
    lines = done.stdout.splitlines()
    version, _, commit = lines[0].partition(" (commit ")
    facts = {"path": os.path.abspath(path), "version": version, "commit": commit.rstrip(")")}
    for line in lines[1:]:
        name, _, value = line.partition(" ")
        facts[name] = value.strip()
    return facts
