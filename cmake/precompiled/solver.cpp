// The solver, compiled for all programs that use the precompiled headers.

#include <CGAL/Seamless_snapping/instantiate_solver.h>
