# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scenes of a comparison have in common and in what they differ, in words."""

from hybrid_run import MissingData
from hybrid_run.parameter_differences import differences, main_difference, same_value

GROUPS = {"Mesh": "mesh", "Model": "model", "Materials": "materials", "Continuum": "bedrock", "Bedding planes": "bedding planes",
          "Blocks": "blocks", "Gravity": "gravity", "Water": "water", "Monitors": "monitors"}


class Scenes:
    """parameters of each run ({} where params.used.prm is missing), differences, the main one of them, what is the same."""

    def __init__(self, runs):
        self.parameters = [parameters_of(run) for run in runs]
        self.is_known = all(self.parameters)
        self.differences = differences(self.parameters) if self.is_known else []
        self.main = main_difference(self.differences)

    def same(self):
        """Words on what no parameter differs in."""
        if not self.is_known:
            return []
        changed = {difference.name.split("/")[0] for difference in self.differences}
        words = [words for group, words in GROUPS.items() if group not in changed]
        if "Motion" not in changed:
            words.insert(3, self.motion())
        return words + self.time()

    def motion(self):
        p = self.parameters[0]
        kind = p.get("Motion/Type", "none")
        peak = p.get("Motion/Peak", "as recorded")
        unit = " m/s2" if peak.replace(".", "", 1).isdigit() else ""  # a bare number
        return "no motion" if kind == "none" else "motion (%s, %s %s%s)" % (kind, p.get("Motion/Meaning", ""), peak, unit)

    def time(self):
        words = []
        for name, text in (("Time/Scheme", "scheme"), ("Time/Time step", "step %s s")):
            values = [p.get(name, "") for p in self.parameters]
            if all(same_value(values[0], value) for value in values):
                words.append(text % values[0] if "%" in text else text)
        return words

    def differing(self):
        """(name, values, remark) of every parameter that differs, the main one first."""
        ordered = sorted(self.differences, key=lambda d: (d is not self.main, not d.has_effect))
        return [(d.name, ["-" if value is None else value or "(empty)" for value in d.values], self.remark(d)) for d in ordered]

    def remark(self, difference):
        if not difference.has_effect:
            return "changes no result"
        return "" if difference is self.main else "<- differs besides " + self.main.name.split("/")[-1]


def parameters_of(run):
    try:
        return run.parameters
    except MissingData:
        return {}
