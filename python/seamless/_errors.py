"""The error of the module, and the words of its messages."""

import re

# What the library says of its own parameters and functions, and what stands for it here. The first
# entry that fits a place counts, so that longer ones come first.
_WORDS = (
    (r"; CGAL::Polygon_mesh_processing::orient_polygon_soup\(\) cuts it", ""),
    (r"; raise it to at least this distance, or scale the map up by grid_scale",
     "; raise it to at least this distance, scale the map up by grid_scale, or pass a number of quads"),
    (r"snap_(?:volume_)?to_seamless\(\) with repair_flips\((?:true|Flip_repair::UNTANGLE)\)",
     "snap_volume() or snap() with repair_flips=True"),
    (r"snap_volume_to_seamless\(\)", "snap_volume()"),
    (r"; Flip_repair::UNTANGLE changes more of the map", ""),
    (r"by Flip_repair::UNTANGLE without integer_grid", "by repair_flips=True without integer_grid"),
    (r"; the search for repairs ended at number_of_untangling_iterations: raise it",
     "; the search for repairs has come to its bound"),
    (r"set target_edge_length to about the length of an edge", "scale the mesh to about the size 1"),
    (r"and at most maximum_number; see target_number_of_quads and target_edge_length",
     "and at most 'maximum'; see 'quads' and 'edge_length'"),
    (r"or call extract_quad_soup\(\)", "or have the mesh remeshed by quad_remesh()"),
    (r"(?:raise maximum_number, or )?let curves end where they meet others", "leave out base_complex=True"),
    (r"(align_border|align_boundary|integer_grid|needs_face_graph)\((true|false)\)",
     lambda m: f"{m.group(1)}={m.group(2).capitalize()}"),
    (r"; quantize\(\) makes one", ""),
    (r"or with needs_face_graph=True", "or remesh it by quad_remesh()"),
    (r"CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices\(\)",
     "copies of such vertices"),
    (r"minimize_number_of_quads\(true\)", "coarsest=True"),
    (r"vertex_sizing_map and curvature_adaptivity", "'sizes' and 'adaptivity'"),
    (r"snap_to_seamless\(\)", "snap()"),
    (r"extract_quad_mesh\(\)", "extract_quads()"),
    (r"approximate_seamless_parametrization\(\)", "parametrize()"),
    (r"maximum_feature_loss", "'feature_loss'"),
    (r"maximum_number", "'maximum'"),
    (r"target_number_of_quads", "'quads'"),
    (r"target_edge_length", "'edge_length'"),
    (r"area_threshold", "'area_threshold'"),
    (r"symmetry_plane", "'symmetry'"),
    (r"curvature_alignment", "'curvature'"),
    (r"curvature_adaptivity", "'adaptivity'"),
    (r"vertex_sizing_map", "'sizes'"),
    (r"face_direction_map", "'field'"),
    (r"(?:the )?rounding_tolerance", "'rounding'"),
    (r"grid_scale", "'grid_scale'"),
    (r"number_of_untangling_iterations", "the number of iterations"),
    (r"CGAL::|std::", ""),
)

_PLACE = re.compile(
    r"\b(?:row \d+ of \w+|(?:face|triangle|cell|vertex|facet|corner|row|equation) \d+"
    r"|edge \d+ \d+|edge of the vertices \d+ and \d+|vertices \d+ and \d+"
    r"|faces \d+(?:, \d+| and \d+)*)")


class Error(ValueError):
    """A call has failed; your arrays are as before.

    Attributes
    ----------
    status : str
        The kind of failure, such as ``'not seamless'`` or ``'invalid argument'``.
    place : str or None
        The place, such as ``'face 12'``, ``'edge 3 7'``, or ``'row 5 of F'``. Numbers are those of
        rows, from 0.
    remedy : str or None
        What to do about it.
    report : dict or None
        The figures of the steps that were made, as functions return them with ``report=True``.
    """

    def __init__(self, message, status="invalid argument", report=None):
        super().__init__(message)
        self.status = status
        self.report = report
        found = _PLACE.search(message)
        self.place = found.group() if found else None
        self.remedy = message.rsplit("; ", 1)[1] if "; " in message else None

    def __reduce__(self):
        return (Error, (self.args[0], self.status, self.report))


def in_words(message, rows=None):
    """Return a message of the library in words of Python; `rows` are those of the vertices."""
    for pattern, words in _WORDS:
        message = re.sub(pattern, words, message)
    if rows:
        message = _with_rows(message, rows)
    return message


def _with_rows(message, rows):
    def renamed(match):
        return re.sub(r"\d+", lambda m: str(rows[int(m.group())])
                      if int(m.group()) < len(rows) else m.group(), match.group())

    return re.sub(r"\b(?:vertex \d+|vertices \d+(?:,? (?:and )?\d+)*|edge \d+ \d+)", renamed, message)


def checked(report):
    """Return a report in words of Python; raise `Error` if it tells of a failure."""
    report = dict(report)
    message = in_words(report["message"], report.pop("rows", None))
    report["message"] = message
    if not report.pop("success"):
        status = report["status"]
        raise Error(f"{status}: {message}" if message else status, status, report)
    return report


def refused(error):
    """Return the `Error` for what the compiled part has refused."""
    status, message, rows = error.args
    message = in_words(message, rows)
    return Error(message if message.startswith("row ") else f"{status}: {message}", status)
