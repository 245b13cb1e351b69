import os
from typing import Any, Callable, Dict, List, Literal, Optional, Tuple, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import examples as examples

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Report = Dict[str, Any]
Progress = Optional[Callable[[str], Any]]
Field = Union[ArrayLike, str, "os.PathLike[str]", None]

__version__: str

class Error(ValueError):
    status: str
    reason: str
    place: Optional[str]
    remedy: Optional[str]
    report: Optional[Report]
    def __init__(self, reason: str, remedy: Optional[str] = ..., place: Optional[str] = ...,
                 status: str = ..., report: Optional[Report] = ...) -> None: ...

class Layout:
    nodes: Floats
    node_kinds: List[str]
    node_vertices: Integers
    node_faces: Integers
    node_weights: Floats
    arcs: Integers
    arc_lengths: Floats
    arc_is_constrained: NDArray[np.bool_]
    arc_patches: Integers
    arc_paths: List[Floats]
    patch_corners: Integers
    patch_sizes: Floats
    patch_is_cut: NDArray[np.bool_]
    patch_half_arcs: List[Integers]
    message: str

class Curve:
    faces: Integers
    weights: Floats
    direction: int
    end: str
    def points(self, V: ArrayLike, F: ArrayLike) -> Floats: ...

def sharp_edges(V: Any, F: Optional[ArrayLike] = ..., angle: float = ..., *,
                minimum_length: float = ..., weld: Optional[bool] = ...) -> Integers: ...
def read_field(path: Union[str, "os.PathLike[str]"]) -> Floats: ...
@overload
def parametrize(V: Any, F: Optional[ArrayLike] = ..., *, features: Optional[ArrayLike] = ...,
                align_border: bool = ..., curvature: float = ..., field: Field = ...,
                weld: Optional[bool] = ..., progress: Progress = ...,
                report: Literal[False] = ...) -> Floats: ...
@overload
def parametrize(V: Any, F: Optional[ArrayLike] = ..., *, features: Optional[ArrayLike] = ...,
                align_border: bool = ..., curvature: float = ..., field: Field = ...,
                weld: Optional[bool] = ..., progress: Progress = ...,
                report: Literal[True]) -> Tuple[Floats, Report]: ...
@overload
def snap(F: ArrayLike, uv: ArrayLike, *, V: Optional[ArrayLike] = ...,
         features: Optional[ArrayLike] = ..., align_border: bool = ..., tolerance: float = ...,
         repair_flips: bool = ..., weld: bool = ..., out: Optional[Floats] = ...,
         progress: Progress = ..., report: Literal[False] = ...) -> Floats: ...
@overload
def snap(F: ArrayLike, uv: ArrayLike, *, V: Optional[ArrayLike] = ...,
         features: Optional[ArrayLike] = ..., align_border: bool = ..., tolerance: float = ...,
         repair_flips: bool = ..., weld: bool = ..., out: Optional[Floats] = ...,
         progress: Progress = ..., report: Literal[True]) -> Tuple[Floats, Report]: ...
def measure(F: ArrayLike, uv: ArrayLike, *, V: Optional[ArrayLike] = ...,
            features: Optional[ArrayLike] = ..., align_border: bool = ...,
            weld: bool = ...) -> Report: ...
@overload
def quad_remesh(V: Any, F: Optional[ArrayLike] = ..., quads: Optional[int] = ..., *,
                edge_length: Optional[float] = ..., coarsest: bool = ..., maximum: Optional[int] = ...,
                features: Optional[ArrayLike] = ..., feature_loss: float = ..., field: Field = ...,
                sizes: Optional[ArrayLike] = ..., curvature: Optional[float] = ...,
                adaptivity: float = ..., border_tolerance: Optional[float] = ..., area_threshold: Optional[float] = ...,
                symmetry: Union[str, ArrayLike, None] = ..., weld: Optional[bool] = ...,
                progress: Progress = ...,
                report: Literal[False] = ...) -> Tuple[Floats, Integers]: ...
@overload
def quad_remesh(V: Any, F: Optional[ArrayLike] = ..., quads: Optional[int] = ..., *,
                edge_length: Optional[float] = ..., coarsest: bool = ..., maximum: Optional[int] = ...,
                features: Optional[ArrayLike] = ..., feature_loss: float = ..., field: Field = ...,
                sizes: Optional[ArrayLike] = ..., curvature: Optional[float] = ...,
                adaptivity: float = ..., border_tolerance: Optional[float] = ..., area_threshold: Optional[float] = ...,
                symmetry: Union[str, ArrayLike, None] = ..., weld: Optional[bool] = ...,
                progress: Progress = ...,
                report: Literal[True]) -> Tuple[Floats, Integers, Report]: ...
@overload
def extract_quads(V: ArrayLike, F: ArrayLike, uv: ArrayLike, quads: Optional[int] = ..., *,
                  grid_scale: float = ..., rounding: Optional[float] = ...,
                  features: Optional[ArrayLike] = ..., align_border: bool = ...,
                  repair_flips: bool = ..., allow_holes: bool = ..., weld: bool = ...,
                  progress: Progress = ...,
                  report: Literal[False] = ...) -> Tuple[Floats, Integers]: ...
@overload
def extract_quads(V: ArrayLike, F: ArrayLike, uv: ArrayLike, quads: Optional[int] = ..., *,
                  grid_scale: float = ..., rounding: Optional[float] = ...,
                  features: Optional[ArrayLike] = ..., align_border: bool = ...,
                  repair_flips: bool = ..., allow_holes: bool = ..., weld: bool = ...,
                  progress: Progress = ...,
                  report: Literal[True]) -> Tuple[Floats, Integers, Report]: ...
def layout(V: ArrayLike, F: ArrayLike, uv: ArrayLike, *, features: Optional[ArrayLike] = ...,
           base_complex: bool = ...) -> Layout: ...
def trace(F: ArrayLike, uv: ArrayLike, start: Any = ..., *, maximum_length: Optional[float] = ...,
          progress: Progress = ...) -> List[Curve]: ...
@overload
def snap_volume(T: ArrayLike, uvw: ArrayLike, *, feature_facets: Optional[ArrayLike] = ...,
                feature_edges: Optional[ArrayLike] = ..., align_boundary: bool = ...,
                tolerance: float = ..., repair_flips: bool = ..., integer_grid: bool = ...,
                grid_scale: float = ..., rounding: float = ..., progress: Progress = ...,
                report: Literal[False] = ...) -> Floats: ...
@overload
def snap_volume(T: ArrayLike, uvw: ArrayLike, *, feature_facets: Optional[ArrayLike] = ...,
                feature_edges: Optional[ArrayLike] = ..., align_boundary: bool = ...,
                tolerance: float = ..., repair_flips: bool = ..., integer_grid: bool = ...,
                grid_scale: float = ..., rounding: float = ..., progress: Progress = ...,
                report: Literal[True]) -> Tuple[Floats, Report]: ...
def measure_volume(T: ArrayLike, uvw: ArrayLike, *, feature_facets: Optional[ArrayLike] = ...,
                   feature_edges: Optional[ArrayLike] = ..., align_boundary: bool = ...) -> Report: ...
@overload
def hexahedra(V: ArrayLike, T: ArrayLike, uvw: ArrayLike, hexahedra: Optional[int] = ..., *,
              maximum: Optional[int] = ..., feature_facets: Optional[ArrayLike] = ...,
              feature_edges: Optional[ArrayLike] = ..., tolerance: float = ...,
              moving_rounds: int = ..., progress: Progress = ...,
              report: Literal[False] = ...) -> Tuple[Floats, Integers]: ...
@overload
def hexahedra(V: ArrayLike, T: ArrayLike, uvw: ArrayLike, hexahedra: Optional[int] = ..., *,
              maximum: Optional[int] = ..., feature_facets: Optional[ArrayLike] = ...,
              feature_edges: Optional[ArrayLike] = ..., tolerance: float = ...,
              moving_rounds: int = ..., progress: Progress = ...,
              report: Literal[True]) -> Tuple[Floats, Integers, Report]: ...
def measure_hexahedra(V: ArrayLike, H: ArrayLike) -> Report: ...
@overload
def snap_linear(A: Any, b: Any, x: ArrayLike, *, weights: Optional[ArrayLike] = ...,
                progress: Progress = ..., report: Literal[False] = ...) -> Floats: ...
@overload
def snap_linear(A: Any, b: Any, x: ArrayLike, *, weights: Optional[ArrayLike] = ...,
                progress: Progress = ..., report: Literal[True]) -> Tuple[Floats, Report]: ...
