"""Calls of compiled functions: what they refuse, what they report, and how they are interrupted."""

import atexit
import os
import sys
import warnings

from . import _checks, _core, _words
from ._errors import Error


def call(function, *arguments):
    """Call a compiled function; what it refuses is an `Error`."""
    try:
        return function(*arguments)
    except _core.Refused as error:
        raise _error(*error.args, function.__name__) from None


def make(function, *arguments, progress, report):
    """Call a compiled function whose last result is a report; return the report only if asked to."""
    wants_report = _checks.flag(report, "report")
    *results, figures = call(function, *arguments, _checks.progress(progress))
    message, succeeded = figures["message"], figures.pop("success")
    for key, value in figures.items():
        if isinstance(value, _core.Message):
            figures[key] = _words.sentence(value, function.__name__)
    if not succeeded:
        raise _error(figures["status"], message, function.__name__, figures)
    for words in _concerns(figures):
        warnings.warn(words, stacklevel=3)
    if wants_report:
        results.append(figures)
    return results[0] if len(results) == 1 else tuple(results)


def _error(status, message, function, report=None):
    """The error for what a compiled function says."""
    reason, remedy, place = _words.told(message, function)
    if not reason:
        reason = status
    elif status != "invalid argument":
        reason = f"{status}: {reason}"
    if report and "number_of_misfits" in report:
        reason += f"; {report['number_of_misfits']} of {report['number_of_cut_edges']} cut edges don't fit"
        if report["looks_like_atlas"]:
            reason += (": this looks like a texture atlas, whose charts are laid out independently, and "
                       "a larger tolerance does not help")
            remedy = "pass the mesh to parametrize(), which computes coordinates that fit"
    return Error(reason, remedy, place, status, report)


def _concerns(figures):
    """For which reasons a caller may not want to go on with a result."""
    if figures["status"] == "exact, but flips remain":
        yield f"flips remain: {figures['message']}"
    if figures.get("number_of_parts_left_out", 0) > 0 and not figures["has_area_threshold"]:
        yield (f"{figures['number_of_parts_left_out']} small closed parts were left out; pass "
               "area_threshold=0 to keep all")
    parts = [p for p in figures.get("parts_of_other_size", ()) if p["has_too_many_quads"]]
    if parts and parts[0]["number_of_quads"] < figures["number_of_quads"]:
        yield (f"the part with triangle {parts[0]['triangle']} has {parts[0]['number_of_quads']} quads, more "
               "than twice as many as wanted")
    elif figures.get("has_too_many_quads"):
        yield (f"{figures['number_of_quads']} quads are more than twice as many as wanted; pass fewer "
               "features, or ask for more quads")
    for flaw in ("inverted", "folded"):
        if number := figures.get(f"number_of_{flaw}_quads"):
            yield f"{number} quads are {flaw}; ask for more quads, or pass fewer features"
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
