// The types of surfaces and of their maps, in the program and in the Python module.

#ifndef SEAMLESS_SNAPPING_MAPS_SURFACE_TYPES_H
#define SEAMLESS_SNAPPING_MAPS_SURFACE_TYPES_H

#include <CGAL/Linear_snapping/types/Message.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Uv_map = Mesh::Property_map<Halfedge, Kernel::Point_2>;
using Edge_bool_map = Mesh::Property_map<Edge, bool>;
using Message = CGAL::Linear_snapping::Message;

#endif // SEAMLESS_SNAPPING_MAPS_SURFACE_TYPES_H
