# SPDX-License-Identifier: GPL-3.0-or-later
"""What can go wrong with a run that is read."""


class UserError(Exception):
    """What was given is wrong: the message says what, the value found, what is allowed, and where."""


class MissingData(Exception):
    """The run did not record what is asked for."""


class NotInScene(MissingData):
    """The scene does not have the effect that is asked for: nothing is missing."""
