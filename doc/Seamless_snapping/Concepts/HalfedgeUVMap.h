/*!
\ingroup PkgSeamlessSnappingConcepts
\cgalConcept

The concept `HalfedgeUVMap` describes the coordinates of a parametrization of a triangle mesh: each
corner has its own, so that they may differ on the two sides of an edge. The corner of a face `f` at
a vertex `v` belongs to the halfedge `h` with `face(h) == f` and `target(h) == v`. Values of border
halfedges are neither read nor written.

Functions that write coordinates ask for a model of `WritablePropertyMap` or `ReadWritePropertyMap`
in addition. Its corners may share no place in memory: a map that has one value for a vertex holds no
parametrization with cuts.

\cgalRefines{ReadablePropertyMap}

\cgalHasModel a property map that `CGAL::Surface_mesh` adds to its halfedges, or
`boost::get(CGAL::dynamic_halfedge_property_t<Point_2>(), tmesh)` for any mesh
*/
class HalfedgeUVMap
{
public:
  /// `boost::graph_traits<TriangleMesh>::%halfedge_descriptor`, or what it converts to
  typedef unspecified_type key_type;

  /// a two-dimensional point with coordinates `x()` and `y()` of type `double` or `float`, which can
  /// be constructed from two of them; as a `%Point_2` of a kernel with such a number type
  typedef unspecified_type value_type;
};
