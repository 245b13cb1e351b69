#include "directions.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <cstddef>
#include <locale>
#include <sstream>

namespace {

// The numbers of a text, one after another.
class Numbers
{
public:
  Numbers(const std::string& filename, const std::string& text)
    : m_filename(filename), m_stream(text)
  { m_stream.imbue(std::locale::classic()); }

  double next()
  {
    double result;
    if(!(m_stream >> result))
      refuse("has fewer numbers than it says, or something else than a number");
    return result;
  }

  bool is_at_end() { return (m_stream >> std::ws).eof(); }

  [[noreturn]] void refuse(const std::string& reason) const
  { throw Failure(UNREADABLE, m_filename + ": the file " + reason); }

private:
  std::string m_filename;
  std::istringstream m_stream;
};

} // namespace

void check_direction_file(const std::string& filename)
{
  const std::string suffix = suffix_of(filename);
  if(!filename.empty() && suffix != "rosy" && suffix != "rawfield")
    throw Failure(USAGE, "'" + filename + "': directions are read from .rosy and .rawfield files");
}

// A .rosy file has the number of faces, 4, and a direction for each face; a .rawfield file has 4, the
// number of faces, and four directions for each face, of which the first is read.
Direction_map read_directions(const std::string& filename, const Repairs& repairs, Mesh& mesh)
{
  const Direction_map result =
    mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction",
                                                              Kernel::Vector_3(0, 0, 0)).first;
  if(filename.empty())
    return result;
  if(repairs.degenerate_faces + repairs.duplicate_faces + repairs.triangulated_faces > 0)
    throw Failure(UNREADABLE, filename + ": the directions are those of other faces, as the mesh had "
                              "to be repaired: " + repairs.in_words());
  const bool is_raw = suffix_of(filename) == "rawfield";
  Numbers numbers(filename, read_file(filename));
  const double first = numbers.next(), second = numbers.next();
  const double degree = is_raw ? first : second, number = is_raw ? second : first;
  if(degree != 4)
    numbers.refuse("has no crosses, which are of degree 4");
  if(number != double(mesh.number_of_faces()))
    numbers.refuse("is not for " + counted(mesh.number_of_faces(), "face"));
  for(const Mesh::Face_index f : mesh.faces()) {
    const double x = numbers.next(), y = numbers.next(), z = numbers.next();
    result[f] = Kernel::Vector_3(x, y, z);
    for(int i = 0; i < (is_raw ? 9 : 0); ++i)
      numbers.next();
  }
  if(!numbers.is_at_end())
    numbers.refuse("has more numbers than it says");
  return result;
}
