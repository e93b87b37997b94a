# SPDX-License-Identifier: GPL-3.0-or-later
"""How every tool reads its command line: as argparse does, with the words of hybrid itself."""

import argparse
import difflib

from hybrid_run import UserError


class Arguments(argparse.ArgumentParser):
    """hybrid NAME: mistakes are one line, `error: ...`, with the option that was meant."""

    def __init__(self, name, about, examples):
        self.tool = "hybrid " + name
        super().__init__(prog=self.tool, description=about, epilog="Examples:\n" + examples,
                         formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)

    def read(self, words):
        """What the words say. @raises UserError for what they say wrongly."""
        found, more = self.parse_known_args(words)
        for word in more:
            if word.startswith("-"):
                raise UserError("unknown option '%s' of %s%s; %s --help lists the options" % (
                    word, self.tool, self.suggestion(word.split("=")[0]), self.tool))
            raise UserError("'%s' is one word too many; see %s --help" % (word, self.tool))
        return found

    def suggestion(self, word):
        names = [name for action in self._actions for name in action.option_strings if name.startswith("--")]
        near = difflib.get_close_matches(word, names, 1)
        return " (did you mean '%s'?)" % near[0] if near else ""

    def format_usage(self):
        return super().format_usage().replace("usage: ", "Usage: ", 1)

    def format_help(self):
        return super().format_help().replace("usage: ", "Usage: ", 1)

    def error(self, message):
        raise UserError("%s: %s; see %s --help" % (self.tool, message, self.tool))
