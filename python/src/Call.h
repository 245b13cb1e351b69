// A call of the core, during which other threads of Python run. Lines of progress go to a callable
// of the caller, and each is an occasion to notice that the user interrupts.

#ifndef SEAMLESS_SNAPPING_PYTHON_CALL_H
#define SEAMLESS_SNAPPING_PYTHON_CALL_H

#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/types/Report.h>
#include <CGAL/Linear_snapping/types/parameters.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
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

class Call
{
public:
  // \param progress a callable that takes a line, or None
  explicit Call(py::object progress) : m_progress(std::move(progress)) { }

  // Runs `work()` without the lock of the interpreter. What `progress` raises passes on.
  template <typename Work>
  void run(const Work& work)
  {
    try {
      const py::gil_scoped_release others_run;
      const CGAL::Linear_snapping::internal::Progress progress(
        CGAL::Linear_snapping::internal::strip(
          CGAL::Linear_snapping::parameters::visitor(std::ref(*this))));
      work();
    } catch(const Stopped&) {
      PyErr_Restore(m_type, m_value, m_traceback);
      throw py::error_already_set();
    }
  }

  void operator()(const std::string& line)
  {
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() == 0 && (m_progress.is_none() || call(line)))
      return;
    PyErr_Fetch(&m_type, &m_value, &m_traceback);
    throw Stopped();
  }

private:
  struct Stopped { }; // crosses the core, which must not touch objects of Python

  // Returns whether nothing was raised.
  bool call(const std::string& line)
  {
    PyObject* const result =
      PyObject_CallFunction(m_progress.ptr(), "s", line.c_str());
    Py_XDECREF(result);
    return result != nullptr;
  }

  py::object m_progress;
  PyObject *m_type = nullptr, *m_value = nullptr, *m_traceback = nullptr;
};

#endif // SEAMLESS_SNAPPING_PYTHON_CALL_H
