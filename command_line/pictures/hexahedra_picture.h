// A picture of a mesh of hexahedra, cut open: the hexahedra of the rear half, colored by their shapes
// where the cut shows them.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_HEXAHEDRA_PICTURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_HEXAHEDRA_PICTURE_H

#include <CGAL/Hexahedral_meshing/types/Hexahedral_mesh.h>

#include <string>

// As SVG.
std::string hexahedra_picture(const CGAL::Hexahedral_meshing::Hexahedral_mesh& mesh);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_HEXAHEDRA_PICTURE_H
