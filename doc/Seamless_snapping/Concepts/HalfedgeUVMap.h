/*!
\ingroup PkgSeamlessSnappingConcepts
\cgalConcept

The concept `HalfedgeUVMap` describes the coordinates of a parametrization of a triangle mesh. Each
corner has its own coordinates, so that they may differ on the two sides of an edge. The corner of a
face `f` at a vertex `v` belongs to the halfedge `h` with `face(h) == f` and `target(h) == v`. Values of
border halfedges are neither read nor written.

Functions that write coordinates also require a model of `WritablePropertyMap` or
`ReadWritePropertyMap`. Corners at one vertex may share a place in memory if no cut runs between them; all
other corners need their own. For `convert_to_lattice_coordinates()`, which changes each corner by itself, and for
`approximate_seamless_parametrization()` of `Quad_remeshing`, which chooses the cuts, each corner needs its own
place. A map with one value for each vertex cannot represent a parametrization
with cuts.

\cgalRefines{ReadablePropertyMap}

\cgalHasModel a property map that `CGAL::Surface_mesh` adds to its halfedges, or
`boost::get(CGAL::dynamic_halfedge_property_t<Point_2>(), tmesh)` for any mesh
*/
class HalfedgeUVMap
{
public:
  /// `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`, or a type that it converts to
  typedef unspecified_type key_type;

  /// a two-dimensional point with coordinates `x()` and `y()` of type `double` or `float`, which can
  /// be constructed from two of them; for example the `%Point_2` of a kernel with this number type
  typedef unspecified_type value_type;
};
