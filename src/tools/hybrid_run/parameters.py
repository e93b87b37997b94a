# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameter files of deal.II: params.used.prm of a run."""

import os
import re


def read_parameters(path):
    """{"Section/Name": "value"} of a parameter file, in its order; comments are left out.

    A name that a scene gives several times (numbered subsections apart) has its last value.
    """
    with open(path, encoding="utf-8") as lines:
        return parse_parameters(lines)


def parse_parameters(lines):
    """The same of the lines of such a file."""
    values, sections = {}, []
    for line in joined(lines):
        words = line.split("#")[0].strip()
        if words.startswith("subsection "):
            sections.append(words[len("subsection "):].strip())
        elif words == "end":
            sections.pop()
        elif words.startswith("set "):
            name, _, value = words[len("set "):].partition("=")
            values["/".join(sections + [" ".join(name.split())])] = re.sub(r"\s+", " ", value).strip()
    return values


def changed_parameters(path):
    """{"Section/Name": (value, default)} of what params.used.prm says is not at its default."""
    values, found, sections = read_parameters(path), {}, []
    with open(path, encoding="utf-8") as lines:
        for line in joined(lines):
            words = line.strip()
            if words.startswith("subsection "):
                sections.append(words[len("subsection "):].strip())
            elif words == "end":
                sections.pop()
            elif words.startswith("set ") and "# default:" in words:
                name = "/".join(sections + [" ".join(words[len("set "):].partition("=")[0].split())])
                found[name] = values[name], words.partition("# default:")[2].strip()
    return found


def units(path):
    """{"Section/Name": unit} of a file that says what is allowed for its parameters, as params.used.prm does."""
    found, sections, comment = {}, [], ""
    with open(path, encoding="utf-8") as lines:
        for line in joined(lines):
            words = line.strip()
            if words.startswith("#"):
                comment += " " + words.strip("# ")
                continue
            if words.startswith("subsection "):
                sections.append(words[len("subsection "):].strip())
            elif words == "end":
                sections.pop()
            elif words.startswith("set "):
                unit = re.search(r"Allowed: .*\[([^\]]+)\]", comment)
                if unit:
                    found["/".join(sections + [" ".join(words[len("set "):].partition("=")[0].split())])] = unit[1]
            comment = ""
    return found


def joined(lines):
    """Lines that end with a backslash go on in the next one."""
    text = ""
    for line in lines:
        text += line.rstrip("\n")
        if text.endswith("\\"):
            text = text[:-1]
            continue
        yield text
        text = ""
    if text:
        yield text


def parameters_of_run(directory):
    """Every parameter of a run, also those left at their defaults."""
    return read_parameters(os.path.join(directory, "params.used.prm"))
