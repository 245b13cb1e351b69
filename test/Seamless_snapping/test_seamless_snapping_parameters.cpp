// Tests the named parameters: names of the package and of CGAL's in any order, plain chains of
// CGAL's, which value counts if a name occurs twice, and what is handed on to CGAL.

#include <CGAL/Linear_snapping/types/parameters.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include "checking.h"
#include "floating_point_traps.h"

#include <functional>
#include <type_traits>
#include <vector>

namespace internal_np = CGAL::internal_np;
namespace parameters = CGAL::Linear_snapping::parameters;
namespace internal = CGAL::Linear_snapping::internal;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// What a public function of the package does: strips, then reads.
template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
double read_tolerance(const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto& plain = internal::strip(np);
  return CGAL::parameters::choose_parameter(
           CGAL::parameters::get_parameter(plain, internal_np::tolerance), -1.);
}

template <typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool read_verbose(const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto& plain = internal::strip(np);
  return CGAL::parameters::choose_parameter(
           CGAL::parameters::get_parameter(plain, internal_np::verbose), false);
}

template <typename Tag, typename NamedParameters>
constexpr bool has(const NamedParameters&, Tag)
{
  using Plain = std::decay_t<decltype(internal::strip(std::declval<NamedParameters>()))>;
  return !CGAL::parameters::is_default_parameter<Plain, Tag>::value;
}

void test_any_order()
{
  CHECK_EQUAL(read_tolerance(), -1.);
  CHECK_EQUAL(read_tolerance(parameters::default_values()), -1.);
  CHECK_EQUAL(read_tolerance(parameters::tolerance(2.)), 2.);
  CHECK_EQUAL(read_tolerance(parameters::default_values().tolerance(2.)), 2.);

  const auto ours_first = parameters::tolerance(3.).verbose(true).align_border(true);
  CHECK_EQUAL(read_tolerance(ours_first), 3.);
  CHECK(read_verbose(ours_first));
  CHECK(has(ours_first, internal_np::align_border));
  CHECK(!has(ours_first, internal_np::edge_is_cut));

  const auto cgal_first = parameters::verbose(true).random_seed(5u).tolerance(4.);
  CHECK_EQUAL(read_tolerance(cgal_first), 4.);
  CHECK(read_verbose(cgal_first));
  CHECK(has(cgal_first, internal_np::random_seed));
}

void test_plain_chains_of_cgal()
{
  CHECK_EQUAL(read_tolerance(CGAL::parameters::default_values()), -1.);
  CHECK_EQUAL(read_tolerance(CGAL::parameters::verbose(true)), -1.);
  CHECK(read_verbose(CGAL::parameters::verbose(true)));
  CHECK(read_verbose(CGAL::parameters::geom_traits(Kernel()).verbose(true)));
}

void test_last_one_counts()
{
  CHECK_EQUAL(read_tolerance(parameters::tolerance(1.).tolerance(2.)), 2.);
  CHECK_EQUAL(read_tolerance(parameters::tolerance(1.).verbose(true).tolerance(2.)), 2.);
  CHECK(!read_verbose(parameters::verbose(true).tolerance(2.).verbose(false)));
}

void test_references()
{
  std::vector<double> weights(3, 1.);
  const auto np = parameters::value_weights(std::ref(weights)).verbose(false);
  std::vector<double> none;
  const std::vector<double>& read = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter_reference(internal::strip(np), internal_np::value_weights),
      none);
  CHECK(&read == &weights);
}

// Every name of the two lists starts a sequence, and continues one; its value arrives.
void test_all_names()
{
#define CGAL_SEAMLESS_SNAPPING_TEST(Tag_type, tag, function)                                       \
  {                                                                                                \
    const auto first = parameters::function(17);                                                   \
    CHECK_EQUAL(CGAL::parameters::get_parameter(internal::strip(first), internal_np::tag), 17);    \
    const auto last = parameters::verbose(true).tolerance(1.).function(18);                        \
    CHECK_EQUAL(CGAL::parameters::get_parameter(internal::strip(last), internal_np::tag), 18);     \
  }
  CGAL_SEAMLESS_SNAPPING_PARAMETERS(CGAL_SEAMLESS_SNAPPING_TEST)
#undef CGAL_SEAMLESS_SNAPPING_TEST
}

// A name that CGAL defines, too, would be ambiguous here, and this would not compile.
namespace own_names {

#define CGAL_SEAMLESS_SNAPPING_TEST(Tag_type, tag, function)                                       \
  template <typename T>                                                                            \
  int function(const T&) { return 17; }
CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS(CGAL_SEAMLESS_SNAPPING_TEST)
#undef CGAL_SEAMLESS_SNAPPING_TEST

} // namespace own_names

void test_names_are_not_those_of_cgal()
{
  using namespace CGAL::parameters;
  using namespace own_names;
#define CGAL_SEAMLESS_SNAPPING_TEST(Tag_type, tag, name) CHECK_EQUAL(name(0), 17);
  CGAL_SEAMLESS_SNAPPING_OWN_PARAMETERS(CGAL_SEAMLESS_SNAPPING_TEST)
#undef CGAL_SEAMLESS_SNAPPING_TEST
}

// The lists above pair names and tags; these are the pairs that functions of the package rely on.
void test_tags()
{
  CHECK(has(parameters::align_border(true), internal_np::align_border));
  CHECK(has(parameters::edge_is_constrained_map(0), internal_np::edge_is_constrained));
  CHECK(has(parameters::edge_is_cut_map(0), internal_np::edge_is_cut));
  CHECK(has(parameters::halfedge_rotation_map(0), internal_np::halfedge_rotation));
  CHECK(has(parameters::tolerance(0), internal_np::tolerance));
  CHECK(has(parameters::value_weights(0), internal_np::value_weights));
  CHECK(!has(parameters::value_weights(0), internal_np::tolerance));
}

// CGAL's overloads take nothing but its own type for a chain: the wrapper has to be gone.
void test_stripping()
{
  const auto np = parameters::tolerance(1.).random_seed(5u);
  using Plain = std::decay_t<decltype(internal::strip(np))>;
  using Expected = CGAL::Named_function_parameters<
                     unsigned int, internal_np::random_seed_t,
                     CGAL::Named_function_parameters<double, internal_np::tolerance_t> >;
  static_assert(std::is_same<Plain, Expected>::value, "a plain chain of CGAL's");

  const auto plain = CGAL::parameters::verbose(true);
  CHECK(&internal::strip(plain) == &plain);

  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(2, 0, 0),
                         Kernel::Point_3(0, 2, 0), Kernel::Point_3(0, 0, 2), mesh);
  namespace PMP = CGAL::Polygon_mesh_processing;
  CHECK_EQUAL(PMP::area(mesh, internal::strip(np)), PMP::area(mesh));

  const auto with_map = parameters::tolerance(1.).vertex_point_map(mesh.points());
  using Point_map =
    CGAL::GetVertexPointMap<Mesh, std::decay_t<decltype(internal::strip(with_map))> >::type;
  static_assert(std::is_same<Point_map, Mesh::Property_map<Mesh::Vertex_index,
                                                           Kernel::Point_3> >::value,
                "CGAL's helpers find their parameter");
}

void test_is_named_parameters()
{
  const auto ours = parameters::tolerance(1.);
  const auto plain = CGAL::parameters::verbose(true);
  static_assert(internal::is_named_parameters<decltype(ours)>::value, "ours, const");
  static_assert(internal::is_named_parameters<decltype((ours))>::value, "ours, by reference");
  static_assert(internal::is_named_parameters<decltype(plain)>::value, "CGAL's");
  static_assert(internal::is_named_parameters<CGAL::parameters::Default_named_parameters>::value,
                "the default");
  static_assert(!internal::is_named_parameters<double>::value, "a number");
  static_assert(!internal::is_named_parameters<std::vector<double>&>::value, "a range");
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_any_order();
  test_plain_chains_of_cgal();
  test_last_one_counts();
  test_references();
  test_all_names();
  test_names_are_not_those_of_cgal();
  test_tags();
  test_stripping();
  test_is_named_parameters();
  return report_checks();
}
