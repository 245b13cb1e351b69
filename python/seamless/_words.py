"""Messages of the compiled part in words of Python.

A message consists of parts: words that need no translation, names of the library's parameters and
functions (terms), remedies, and elements with their numbers. The table below has the words of Python
for terms and remedies, so that no text is searched.
"""

_SURFACE = ", but this module makes maps exact for rotations by multiples of 90 degrees only"

# What stands for terms and remedies of the library, in all functions or by the name of a compiled
# function, with None for all others. A remedy without words is left out.
_WORDS = {
    # seams and alignments
    ": pass rotational_symmetry(Rotational_symmetry<3>())": _SURFACE,
    ": pass rotational_symmetry(Rotational_symmetry<6>())": _SURFACE,
    ", in which it cannot be exact: apply convert_to_lattice_coordinates(), and pass "
    "rotational_symmetry(Rotational_symmetry<3>())": _SURFACE,
    ", in which it cannot be exact: apply convert_to_lattice_coordinates(), and pass "
    "rotational_symmetry(Rotational_symmetry<6>())": _SURFACE,
    "raise the tolerance": {"extract_quads": "pass the coordinates through snap() with a larger "
                                             "'tolerance' first",
                            None: "raise 'tolerance'"},
    ", or, for facets of the boundary, pass align_boundary(false)":
        {"snap_volume": ", or, for facets of the boundary, pass align_boundary=False", None: ""},
    "call snap_to_seamless() first": "pass the coordinates through snap() first",
    "call snap_to_seamless() with align_border(true)":
        "pass the coordinates through snap() with align_border=True",
    "call snap_to_seamless() with the same edge_is_constrained_map":
        "pass the coordinates through snap() with the same 'features'",
    "snap with align_border(true)": "pass the coordinates through snap() with align_border=True",
    "see CGAL::Polygon_mesh_processing::duplicate_non_manifold_vertices()":
        "give each fan a copy of the vertex",
    "approximate_seamless_parametrization() computes others": "parametrize() computes others",
    "CGAL::Polygon_mesh_processing::orient_polygon_soup() cuts it":
        "give all but two of the triangles copies of its vertices",
    "set target_edge_length to about the length of an edge": "scale the mesh to about the size 1",

    # flips
    "repair them by snap_to_seamless() with repair_flips(true)":
        {"extract_quads": "repair them by repair_flips=True",
         None: "repair them by snap() with repair_flips=True"},
    "repair them by repair_integer_grid(), or leave out the cells around them: allow_holes(true)":
        "try repair_flips=True, or leave out the quads around them by allow_holes=True",
    "the search for repairs ended at number_of_untangling_iterations: raise it":
        "the search for repairs has come to its bound",
    "Flip_repair::UNTANGLE changes more of the map":
        {"hexahedra": "with a number of 'hexahedra', more of the map changes",
         None: "repair_flips=True changes more of the map"},
    "repair these first, by Flip_repair::UNTANGLE without integer_grid":
        {"hexahedra": "repair these first, by snap_volume() with repair_flips=True",
         None: "repair these first, by repair_flips=True without integer_grid"},
    "snap_volume_to_seamless() with repair_flips(Flip_repair::UNTANGLE) makes cells positive if it "
    "can": "snap_volume() with repair_flips=True makes cells positive if it can",

    # integers
    "scale the map up by grid_scale":
        {"hexahedra": "ask for more by 'hexahedra'",
         "extract_quads": "scale the map up by 'grid_scale', or ask for more by 'quads'",
         None: "scale the map up by 'grid_scale'"},
    "the rounding_tolerance is":
        {"hexahedra": "without a number of 'hexahedra' it may move by", None: "'rounding' is"},
    "raise rounding_tolerance to at least this distance, or scale the map up by "
    "grid_scale":
        {"hexahedra": "ask for a number of 'hexahedra', which rounds at any distance",
         "extract_quads": "ask for a number of 'quads', which finds integers for each map without "
                          "flips, or raise 'rounding' to at least the distance",
         None: "raise 'rounding' to at least the distance, or scale the map up by 'grid_scale'"},
    "call snap_to_seamless() with integer_grid(true) first": "ask for a number of 'quads'",
    ", or double the map: grid_scale(2)": ", or double the map by grid_scale=2",
    "snap_to_seamless() with integer_grid(true) and align_border(true) moves it to the grid":
        "align_border=True moves it to the grid",
    "snap_volume_to_seamless() makes the map exactly seamless":
        "snap_volume() makes the map exactly seamless",
    "snap_volume_to_seamless() with integer_grid(true) makes an integer-grid map":
        "snap_volume() with integer_grid=True makes an integer-grid map",
    "snap_volume_to_seamless() aligns it": "snap_volume() aligns it",
    "scale by a power of two, or scale before the map is made exact, by snap_to_seamless() with "
    "grid_scale": "scale by a power of two, or scale before snap()",
    "add twice the largest one to all, and snap the map by snap_to_seamless()":
        "add twice the largest one to all, and pass the coordinates through snap()",
    "pass the map through snap_to_seamless()": "pass the coordinates through snap()",

    # numbers of quads and hexahedra
    "it must be at least 1 and at most 2^28, and at most maximum_number; see target_number_of_quads "
    "and target_edge_length":
        {"extract_quads": "'quads' must be at least 1 and at most 2^28",
         None: "it must be at least 1 and at most 2^28, and at most 'maximum'; see 'quads', "
               "'edge_length', and 'sizes'"},
    "raise maximum_number, or shrink the map by grid_scale":
        "shrink the map by 'grid_scale', or ask for fewer by 'quads'",
    "shrink the map by grid_scale": "shrink the map by 'grid_scale', or ask for fewer by 'quads'",
    "raise maximum_number, or ask for fewer quads":
        {"extract_quads": "ask for fewer 'quads'", None: "raise 'maximum', or ask for fewer 'quads'"},
    "raise maximum_number, or let curves end where they meet others":
        "leave out base_complex=True, so that curves end where they meet others",
    "raise maximum_number": "raise 'maximum'",
    "scale the map down, or raise maximum_number":
        "ask for fewer by 'hexahedra', or raise 'maximum'",
    ". That is more than maximum_number: raise it, or ask for about as many, mark fewer features, or "
    "release some by maximum_feature_loss":
        {"extract_quads": ": ask for about as many 'quads', or mark fewer 'features'",
         None: ". That is more than 'maximum': raise it, or ask for about as many 'quads', mark fewer "
               "'features', or release some by 'feature_loss'"},
    ", which is maximum_number: raise it":
        {"extract_quads": "", None: ", which is 'maximum': raise it"},
    "some features can be released by maximum_feature_loss":
        {"extract_quads": "", None: "some features can be released by 'feature_loss'"},
    "minimize_number_of_quads(true) makes as few as are found":
        "coarsest=True makes as few as are found",
    "let vertex_sizing_map and curvature_adaptivity vary sizes less":
        "let 'sizes' and 'adaptivity' vary sizes less",
    "quantize to more quads, or with needs_face_graph(true)": "ask for more 'quads'",
    "quantize() with needs_face_graph(true), which leaves out its quad, or ":
        "make about as many by 'quads', which leaves out its quad, or ",
    "call extract_quad_soup()": "remesh the surface by quad_remesh()",

    # parameters
    "area_threshold": "'area_threshold'",
    "border_tolerance": "'border_tolerance'",
    "curvature_adaptivity": "'adaptivity'",
    "curvature_alignment": "'curvature'",
    "feature_edges": "'feature_edges'",
    "grid_scale": "'grid_scale'",
    "maximum_feature_loss": "'feature_loss'",
    "symmetry_plane": "'symmetry'",
    "target_edge_length": "'edge_length'",
}

_JOINTS = (" ", " and ", ", ")  # between the elements of a place


def _in_python(words, function):
    ours = _WORDS.get(words, words)
    return ours.get(function, ours[None]) if isinstance(ours, dict) else ours


def told(message, function):
    """Return the reason, the remedy, and the place that a message of a compiled function tells.

    The place is the first element, and the elements and terms that follow it. The remedy and the place
    are None if there is none.
    """
    reason, remedy, place = "", "", ""
    joint = None  # words since the last part of the place; None once the place has ended
    for kind, words, number in message.parts():
        words = _in_python(words, function) if kind in ("term", "remedy") else words
        text = words if number is None else f"{words} {number}".lstrip()
        if kind == "remedy" or remedy:
            remedy += "; " + text if kind == "remedy" and text and remedy else text
            continue
        reason += text
        if kind == "element" and not place:
            place, joint = text, ""
        elif kind != "text" and joint is not None:
            place, joint = place + joint + text, ""
        elif joint is not None:
            joint = joint + text if joint + text in _JOINTS else None
    return reason, remedy or None, place or None


def sentence(message, function):
    """Return a message of a compiled function as a text."""
    reason, remedy, _ = told(message, function)
    return "; ".join(filter(None, (reason, remedy)))
