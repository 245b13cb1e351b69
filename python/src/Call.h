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

using Message = CGAL::Linear_snapping::Message;

// The message with rows in place of the numbers of vertices, if they differ.
inline Message with_rows(Message message, const std::vector<std::size_t>& rows)
{
  if(!rows.empty())
    message.renumber(Message::VERTEX,
                     [&](const std::size_t v) { return v < rows.size() ? rows[v] : v; });
  return message;
}

// What was asked for can't be done; Python makes its error of this.
struct Refused
  : public std::runtime_error
{
  // \param rows those of the vertices in the message, if they differ
  Refused(const CGAL::Linear_snapping::Outcome outcome, Message words,
          const std::vector<std::size_t>& rows = {})
    : std::runtime_error(words.str()), status(outcome),
      message(with_rows(std::move(words), rows))
  { }
  CGAL::Linear_snapping::Outcome status;
  Message message;
};

// Parts of messages in words of Python.
inline Message remedy(const std::string& words) { return {Message::REMEDY, words}; }
inline Message row_of(const std::size_t i, const std::string& argument)
{ return Message(Message::ELEMENT, "row", i) + Message(Message::TERM, " of " + argument); }

// Runs `work()` in a thread of its own, while other threads of Python run. It must own all that it
// uses, and use nothing of Python: if the user interrupts, or `progress` raises, then the error
// passes on at once, and the thread ends at the next line that the core tells. Returns the seconds that
// the work has taken.
double run_apart(const py::object& progress, std::function<void()> work);

// Runs `job->run()` so.
template <typename Job>
double run_apart(const py::object& progress, const std::shared_ptr<Job>& job)
{ return run_apart(progress, std::function<void()>([job] { job->run(); })); }

// Waits for the threads that interrupted calls have left behind, unless the user interrupts that, too.
// The interpreter calls it at its end.
void wait_for_interrupted_calls();

#endif // SEAMLESS_SNAPPING_PYTHON_CALL_H
