#include "plain_surfaces.h"

#include "Call.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace {

// The exponent by which the largest of some numbers comes near to one.
int exponent_near_one(const double* const numbers, const std::size_t n)
{
  double size = 0;
  for(std::size_t i = 0; i < n; ++i)
    size = (std::max)(size, std::abs(numbers[i]));
  return size > 0 ? -std::ilogb(size) : 0;
}

} // namespace

void check_closed_seams(const Array_surface& surface, const std::optional<bool> weld)
{
  const std::size_t number = surface.number_of_coinciding_border_edges();
  if(weld || number == 0)
    return;
  throw Refused(CGAL::Linear_snapping::Outcome::INVALID_ARGUMENT,
                std::to_string(number) + " border edges lie in the same place as others, as in a "
                "mesh that is cut open along the seams of a texture, or has its own points for each "
                "face" + remedy("pass weld=True to join them, or weld=False if they are to stay open"));
}

void scale_near_one(Mesh& mesh)
{
  std::vector<double> numbers;
  for(const Kernel::Point_3& p : mesh.points())
    numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  const int exponent = exponent_near_one(numbers.data(), numbers.size());
  for(Kernel::Point_3& p : mesh.points())
    p = {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent)};
}

Direction_map direction_map(Mesh& mesh, const std::vector<double>& directions)
{
  const Direction_map result =
    mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction",
                                                              Kernel::Vector_3(0, 0, 0)).first;
  if(!directions.empty())
    for(const Mesh::Face_index f : mesh.faces()) {
      const double* const d = directions.data() + 3 * std::size_t(f);
      const int exponent = exponent_near_one(d, 3);
      result[f] = {std::ldexp(d[0], exponent), std::ldexp(d[1], exponent),
                   std::ldexp(d[2], exponent)};
    }
  return result;
}
