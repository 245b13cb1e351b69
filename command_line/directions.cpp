#include "directions.h"

#include "Failure.h"
#include "files.h"
#include "words.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

// Throws `Failure` unless these are the two numbers that come first, and those of the faces.
void check_numbers(const std::string& filename, const std::vector<double>& numbers,
                   const bool is_raw, const std::size_t number_of_faces)
{
  const std::string faces = counted(number_of_faces, "face");
  const auto count = [&](const bool raw) { return 2 + (raw ? 12 : 3) * number_of_faces; };
  std::string why;
  if(numbers.size() < 2 || numbers[is_raw ? 0 : 1] != 4 ||
     numbers[is_raw ? 1 : 0] != double(number_of_faces))
    why = is_raw ? "a .rawfield file of this mesh begins with 4 and the number of faces, "
                 : "a .rosy file of this mesh begins with the number of faces and 4, ";
  if(!why.empty())
    why += is_raw ? "4 " + std::to_string(number_of_faces) : std::to_string(number_of_faces) + " 4";
  else if(numbers.size() != count(is_raw))
    why = "after the first two, there are " + counted(numbers.size() - 2, "number") + ", not " +
          (is_raw ? "12" : "3") + " for each of " + faces;
  if(!why.empty())
    throw Failure(UNREADABLE, filename + ": " + why +
                                (numbers.size() == count(!is_raw)
                                   ? std::string("; there are as many numbers as in a .") +
                                       (is_raw ? "rosy" : "rawfield") + " file" : ""));
}

// A direction times a power of two, with coordinates of at most 2, as its length does not count.
Kernel::Vector_3 near_one(const double x, const double y, const double z)
{
  const double size = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  return {std::ldexp(x, -exponent), std::ldexp(y, -exponent), std::ldexp(z, -exponent)};
}

// Whether it has a part along its face that is more than rounding.
bool has_effect(const Kernel::Vector_3& direction, const Mesh::Face_index f, const Mesh& mesh)
{
  constexpr double least_part = 1e-6;
  const Kernel::Vector_3 part = CGAL::cross_product(PMP::compute_face_normal(f, mesh), direction);
  return std::hypot(part.x(), part.y(), part.z()) >
         least_part * std::hypot(direction.x(), direction.y(), direction.z());
}

} // namespace

void check_direction_file(const std::string& filename)
{
  const std::string suffix = suffix_of(filename);
  if(!filename.empty() && suffix != "rosy" && suffix != "rawfield")
    throw Failure(USAGE, "'" + filename + "': directions are read from .rosy and .rawfield files");
}

// A .rosy file has the number of faces, 4, and a direction for each face; a .rawfield file has 4, the
// number of faces, and four directions for each face, of which the first is read.
Direction_map read_directions(const std::string& filename, const Repairs& repairs,
                              const Mesh& mesh, std::ostream& os)
{
  if(filename.empty())
    return {};
  if(repairs.degenerate_faces + repairs.duplicate_faces + repairs.triangulated_faces > 0)
    throw Failure(UNREADABLE, filename + ": the directions belong to other faces, because the mesh "
                              "had to be repaired: " + repairs.in_words());
  const bool is_raw = suffix_of(filename) == "rawfield";
  const std::vector<double> numbers = read_numbers(filename);
  check_numbers(filename, numbers, is_raw, mesh.number_of_faces());
  std::vector<Kernel::Vector_3> directions(mesh.number_of_faces());
  std::size_t i = 2;
  for(Kernel::Vector_3& d : directions) {
    d = near_one(numbers[i], numbers[i + 1], numbers[i + 2]);
    i += is_raw ? 12 : 3;
  }
  const Direction_map result{
    std::make_shared<const std::vector<Kernel::Vector_3> >(std::move(directions))};
  if(std::none_of(mesh.faces_begin(), mesh.faces_end(),
                  [&](const Mesh::Face_index f) { return has_effect(result[f], f, mesh); }))
    os << "note: " << filename << " has no effect: each direction is 0 or normal to its face\n";
  return result;
}

std::optional<double> median_turn(const Located_quads& quads, const Direction_map& directions,
                                  const Mesh& mesh)
{
  std::vector<double> turns;
  for(const Mesh::Face_index f : quads.mesh.faces()) {
    const Mesh::Face_index g = quads.of_face[f].first;
    if(!has_effect(directions[g], g, mesh))
      continue;
    const Kernel::Vector_3 normal = PMP::compute_face_normal(g, mesh);
    const auto in_plane = [&](const Kernel::Vector_3& v) { return v - (v * normal) * normal; };
    const Halfedge h = quads.mesh.halfedge(f);
    const auto along = [&](const Halfedge e) {
      return quads.mesh.point(quads.mesh.target(e)) - quads.mesh.point(quads.mesh.source(e));
    };
    const double angle = CGAL::approximate_angle(
      in_plane(along(h) - along(quads.mesh.next(quads.mesh.next(h)))), in_plane(directions[g]));
    turns.push_back((std::min)(std::fmod(angle, 90), 90 - std::fmod(angle, 90)));
  }
  if(turns.empty())
    return std::nullopt;
  const auto middle = turns.begin() + std::ptrdiff_t(turns.size() / 2);
  std::nth_element(turns.begin(), middle, turns.end());
  return *middle;
}
