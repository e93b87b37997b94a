# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of which a tool writes a part, between two marks: comments of Markdown, which a reader does not see."""

from hybrid_run import UserError


def around(path, begin, end):
    """What stands before and after the part, with the marks. @raises UserError without them."""
    try:
        with open(path, encoding="utf-8") as file:
            page = file.read()
        first = page.index(begin) + len(begin)
        return page[:first], page[page.index(end, first):]
    except (OSError, ValueError) as error:
        raise UserError("'%s' is no page with the marks '%s' and '%s'" % (path, begin, end)) from error


def put(path, begin, end, text):
    """Replace the part by `text`, which ends its last line."""
    head, tail = around(path, begin, end)
    with open(path, "w", encoding="utf-8") as file:
        file.write(head + "\n" + text + tail)
