// A program of a project that uses the package: it compiles, links and runs.

#include <CGAL/Seamless_snapping/parameters.h>

#include <cstdlib>

int main()
{
  const auto np = CGAL::Seamless_snapping::parameters::tolerance(1e-6).verbose(false);
  const double tolerance = CGAL::parameters::get_parameter(
    CGAL::Seamless_snapping::internal::strip(np), CGAL::internal_np::tolerance);
  return tolerance == 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
