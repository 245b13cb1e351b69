"""Calls of compiled functions: what they refuse, what they report, and how they are interrupted."""

import atexit
import os
import sys
import warnings

from . import _checks, _core
from ._errors import checked, refused


def call(function, *arguments):
    """Call a compiled function; what it refuses is an `Error`."""
    try:
        return function(*arguments)
    except _core.Refused as error:
        raise refused(error) from None


def make(function, *arguments, progress, report):
    """Call a compiled function whose last result is a report; return the report only if asked to."""
    wants_report = _checks.flag(report, "report")
    *results, figures = call(function, *arguments, _checks.progress(progress))
    figures = checked(figures)
    for words in _concerns(figures):
        warnings.warn(words, stacklevel=3)
    if wants_report:
        results.append(figures)
    return results[0] if len(results) == 1 else tuple(results)


def _concerns(figures):
    """For which reasons a caller may not want to go on with a result."""
    if figures["status"] == "exact, but flips remain":
        yield f"flips remain: {figures['message']}"
    if figures.get("number_of_parts_left_out", 0) > 0 and not figures["has_area_threshold"]:
        yield (f"{figures['number_of_parts_left_out']} small closed parts were left out; pass "
               "area_threshold=0 to keep all")
    if figures.get("has_too_many_quads"):
        yield (f"{figures['number_of_quads']} quads are more than twice as many as wanted; pass fewer "
               "features, or ask for more quads")
    if figures.get("number_of_inverted_quads", 0) > 0:
        yield (f"{figures['number_of_inverted_quads']} quads are inverted; ask for more quads, or pass "
               "fewer features")
    if figures.get("nonpositive_hexahedra"):
        yield (f"{len(figures['nonpositive_hexahedra'])} hexahedra have a corner that is not positive, "
               f"the first is row {figures['nonpositive_hexahedra'][0]}; ask for more hexahedra")


@atexit.register
def _wait():
    """Interrupted calls end soon, and use objects that the interpreter destroys at its end. Whoever
    interrupts once more does not want to wait."""
    try:
        _core.wait_for_interrupted_calls()
    except KeyboardInterrupt:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(130)
