#include "plain_meshes.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/boost/graph/IO/OFF.h>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

void check_quad_file(const std::string& filename)
{
  const std::string suffix = suffix_of(filename);
  if(!is_special_file(filename) && suffix != "obj" && suffix != "off" && suffix != "ply")
    throw Failure(USAGE, "'" + filename + "': quads are written to .obj, .off, and .ply files");
}

namespace {

// \param why what is wrong with them
void write_bad_quads(std::ostream& os, const std::size_t number,
                     const std::vector<std::size_t>& first, const std::string& filename,
                     const std::string& why)
{
  if(number == 0)
    return;
  os << "warning: " << counted(number, "quad") << (number == 1 ? " is " : " are ") << why
     << (number == 1 ? "It is face" : number == first.size() ? "They are faces"
                                                             : "The first are faces");
  const std::string suffix = suffix_of(filename);
  const std::size_t first_number = suffix == "off" || suffix == "ply" ? 0 : 1;
  for(const std::size_t f : first)
    os << (f == first.front() ? " " : ", ") << f + first_number;
  os << " of " << filename << "\n";
}

// Throws `Failure` if there are such quads.
// \param how they are, with a remedy
void check_bad_quads(const std::size_t number, const std::string& filename, const std::string& how)
{
  if(number > 0)
    throw Failure(STILL_FLIPPED, filename + ": written, but " + counted(number, "quad") +
                                   (number == 1 ? " stays " : " stay ") + how);
}

} // namespace

void write_inverted_quads(std::ostream& os, const std::size_t number,
                          const std::vector<std::size_t>& first, const std::string& filename)
{
  write_bad_quads(os, number, first, filename,
                  "inverted: at a corner, the sides turn the other way than the quad as a whole "
                  "does, or a side has no length. ");
}

void write_folded_quads(std::ostream& os, const std::size_t number,
                        const std::vector<std::size_t>& first, const std::string& filename)
{
  write_bad_quads(os, number, first, filename,
                  "folded: the surface below faces the other way, or does not turn back as the quad "
                  "and one beside it do. ");
}

void check_inverted_quads(const std::size_t number, const std::string& filename,
                          const std::string& remedy)
{
  check_bad_quads(number, filename, "inverted" + remedy);
}

void check_folded_quads(const std::size_t number, const std::string& filename)
{
  check_bad_quads(number, filename, "folded");
}

void write_displacement(std::ostream& os, const std::size_t number, const double largest)
{
  if(number > 0)
    os << "moved off the surface or off a feature, because quads would be inverted or folded: "
       << counted(number, "vertex") << ", each at most " << largest
       << " from where it lay\n";
}

namespace {

template <typename... Quads>
std::string text(const std::string& filename, const Quads&... quads)
{
  std::ostringstream os;
  const auto precision = CGAL::parameters::stream_precision(17);
  const std::string suffix = suffix_of(filename);
  if(!(suffix == "off"   ? CGAL::IO::write_OFF(os, quads..., precision)
       : suffix == "ply" ? CGAL::IO::write_PLY(os, quads..., precision)
                         : CGAL::IO::write_OBJ(os, quads..., precision)))
    throw Failure(UNWRITABLE, "cannot write '" + filename + "'");
  return os.str();
}

} // namespace

std::string lines_of_features(const Mesh& quads, const Edge_bool_map& is_feature)
{
  std::vector<std::size_t> numbers(quads.num_vertices());
  std::size_t number = 0;
  for(const auto v : quads.vertices())
    numbers[std::size_t(v)] = ++number;
  std::string result;
  for(const Edge e : quads.edges())
    if(is_feature[e] && !quads.is_border(e))
      result += "l " + std::to_string(numbers[std::size_t(quads.vertex(e, 0))]) + " " +
                std::to_string(numbers[std::size_t(quads.vertex(e, 1))]) + "\n";
  return result;
}

std::string text_of_quads(const Mesh& quads, const Edge_bool_map& is_feature,
                          const std::string& filename)
{
  const std::string result = text(filename, quads), suffix = suffix_of(filename);
  return suffix == "off" || suffix == "ply" ? result
                                            : result + lines_of_features(quads, is_feature);
}

std::string text_of_quads(const Quad_soup& quads, const std::string& filename)
{
  return text(filename, quads.points, quads.polygons);
}
