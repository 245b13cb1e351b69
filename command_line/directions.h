// Files with a direction for each face, by which other programs hand on fields of crosses.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H

#include "Model.h"
#include "Repairs.h"
#include "attributes.h"

#include <iosfwd>
#include <optional>
#include <string>

using Direction_map = Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3>;

// Throws `Failure` if it is not the name of a file with directions. An empty name is none.
void check_direction_file(const std::string& filename);

// Reads the directions of the faces, which are those of the file that the model was read from; 0
// without a name; of a length near 1, as products of others might be 0 or infinite. Throws
// `Failure`, also if the faces were repaired. Tells if none has an effect.
Direction_map read_directions(const std::string& filename, const Repairs& repairs, Mesh& mesh,
                              std::ostream& os);

// By how many degrees quads are turned against the directions of the faces below their middles, in
// the median; nothing where no such face has one.
std::optional<double> median_turn(const Located_quads& quads, const Direction_map& directions,
                                  const Mesh& mesh);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H
