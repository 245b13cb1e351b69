"""Exactly seamless parametrizations of surfaces and volumes, layouts, quads, and hexahedra.

Points are float64 arrays ``(n, 3)``, triangles integer arrays ``(m, 3)`` of rows from 0. Other layouts
and types of numbers are converted. Your arrays never change. A call that fails raises `Error`, a
`ValueError` that tells the place and the remedy.
"""

from . import _core, examples
from ._errors import Error
from ._fields import read_field
from ._layouts import Curve, Layout, extract_quads, layout, trace
from ._linear import snap_linear
from ._surfaces import measure, parametrize, quad_remesh, sharp_edges, snap
from ._volumes import hexahedra, measure_hexahedra, measure_volume, snap_volume

__version__ = _core.__version__
__all__ = ["Curve", "Error", "Layout", "examples", "extract_quads", "hexahedra", "layout", "measure",
           "measure_hexahedra", "measure_volume", "parametrize", "quad_remesh", "read_field",
           "sharp_edges", "snap", "snap_linear", "snap_volume", "trace"]
