// A call of the core, in a thread of its own. The calling thread waits for it, passes lines of
// progress on, and notices that the user interrupts, whatever the core does meanwhile.

#ifndef SEAMLESS_SNAPPING_PYTHON_CALL_H
#define SEAMLESS_SNAPPING_PYTHON_CALL_H

#include <CGAL/Linear_snapping/types/Report.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

// What was asked for can't be done; Python makes its error of this.
struct Refused
  : public std::runtime_error
{
  Refused(const CGAL::Linear_snapping::Outcome outcome, const std::string& message,
          std::vector<std::size_t> rows_of_vertices = {})
    : std::runtime_error(message), status(outcome), rows(std::move(rows_of_vertices)) { }
  CGAL::Linear_snapping::Outcome status;
  std::vector<std::size_t> rows; // of the vertices in the message, if they differ
};

// Runs `work()` in a thread of its own, while other threads of Python run. It must own all that it
// uses, and use nothing of Python: if the user interrupts, or `progress` raises, then the error
// passes on at once, and the thread ends at the next line that the core tells.
void run_apart(const py::object& progress, std::function<void()> work);

// Runs `job->run()` so.
template <typename Job>
void run_apart(const py::object& progress, const std::shared_ptr<Job>& job)
{ run_apart(progress, std::function<void()>([job] { job->run(); })); }

// Waits for the threads that interrupted calls have left behind, unless the user interrupts that, too.
// The interpreter calls it at its end.
void wait_for_interrupted_calls();

#endif // SEAMLESS_SNAPPING_PYTHON_CALL_H
