// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Quad_remeshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_QUAD_REMESHING_MEASURE_QUAD_SHAPES_H
#define CGAL_QUAD_REMESHING_MEASURE_QUAD_SHAPES_H

#include <CGAL/license/Quad_remeshing.h>

// Measures how well the quads of any mesh are shaped.

#include <CGAL/Linear_snapping/types/parameters.h>
#include <CGAL/Quad_remeshing/internal/cells/inverted_quads.h>
#include <CGAL/Quad_remeshing/internal/packages_below.h>
#include <CGAL/Quad_remeshing/internal/remeshing/Shape_counter.h>
#include <CGAL/Quad_remeshing/types/Quad_shapes.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Quad_remeshing {

/*!
\ingroup PkgQuadRemeshingRemeshing

measures the shapes of the quads of any mesh. Faces that are no quads are left out.

\tparam QuadMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the mesh
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a point in
                   space as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the measurements; `Quad_shapes()` if no face is a quad

\par Complexity
Linear in the size of the mesh.

\sa `quad_remesh()`
*/
template <typename QuadMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Quad_shapes measure_quad_shapes(const QuadMesh& mesh,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr auto read = internal::named<CGAL::internal_np::vertex_point>;
  const auto points = internal::chosen(internal::strip(np, read), CGAL::internal_np::vertex_point,
                                       CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  internal::Shape_counter counter;
  std::size_t number = 0;
  for(const auto f : faces(mesh)) {
    internal::Quad_in_space quad;
    std::size_t corners = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) {
      if(corners < 4) {
        const auto& p = get(points, v);
        quad[corners] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
      }
      ++corners;
    }
    if(corners == 4)
      counter.add(number, quad);
    ++number;
  }
  return counter.shapes();
}

} // namespace Quad_remeshing
} // namespace CGAL

#endif // CGAL_QUAD_REMESHING_MEASURE_QUAD_SHAPES_H
