// The module `seamless._core`: what is compiled. The module `seamless` checks what users pass, and
// speaks to them.

#include "Call.h"
#include "functions.h"
#include "reports.h"

#include <CGAL/Linear_snapping/internal/support/Progress.h>

#include <pybind11/stl.h>

#include <chrono>
#include <exception>

PYBIND11_MODULE(_core, module)
{
  // an interrupted call ends at a line of progress
  CGAL::Linear_snapping::internal::Progress::interval = std::chrono::milliseconds(250);
  // never destroyed, because the interpreter ends before static objects do
  static const auto* const refused = new py::exception<Refused>(module, "Refused");
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if(pointer)
        std::rethrow_exception(pointer);
    } catch(const Refused& e) {
      const py::tuple arguments = py::make_tuple(to_string(e.status), e.message);
      PyErr_SetObject(refused->ptr(), arguments.ptr());
    }
  });
  py::class_<Message>(module, "Message").def("parts", parts_of);
  module.attr("__version__") = SEAMLESS_SNAPPING_VERSION;
  module.def("wait_for_interrupted_calls", wait_for_interrupted_calls);
  add_snapping(module);
  add_parametrization(module);
  add_remeshing(module);
  add_extraction(module);
  add_layouts(module);
  add_volumes(module);
  add_hexahedra(module);
  add_linear(module);
}
