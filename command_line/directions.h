// Files with a direction for each face, by which other programs hand on fields of crosses.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H

#include "Model.h"
#include "Repairs.h"
#include "attributes.h"

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// The directions of faces, as a property map. Without a file, none has one: all are 0.
struct Direction_map
{
  using key_type = Mesh::Face_index;
  using value_type = Kernel::Vector_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  value_type operator[](const key_type f) const
  { return directions ? (*directions)[std::size_t(f)] : value_type(0, 0, 0); }
  friend value_type get(const Direction_map& map, const key_type f) { return map[f]; }

  std::shared_ptr<const std::vector<Kernel::Vector_3> > directions; // per face
};

// Throws `Failure` if it is not the name of a file with directions. An empty name is none.
void check_direction_file(const std::string& filename);

// Reads the directions of the faces, which are those of the file that the model was read from; 0
// without a name; of a length near 1, as products of others might be 0 or infinite. Throws
// `Failure`, also if the faces were repaired. Tells if none has an effect.
Direction_map read_directions(const std::string& filename, const Repairs& repairs,
                              const Mesh& mesh, std::ostream& os);

// By how many degrees quads are turned against the directions of the faces below their middles, in
// the median; nothing where no such face has one.
std::optional<double> median_turn(const Located_quads& quads, const Direction_map& directions,
                                  const Mesh& mesh);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_DIRECTIONS_H
