#include "Call.h"

#include <CGAL/Linear_snapping/internal/support/Progress.h>
#include <CGAL/Linear_snapping/types/parameters.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace {

struct Stopped { }; // ends the work of a call that nobody waits for any more

// What the two threads of a call share.
class Shared_state
{
public:
  explicit Shared_state(const bool has_reader) : m_has_reader(has_reader) { }

  // ---- of the thread that works

  void run(std::function<void()>&& work)
  {
    std::exception_ptr error;
    const auto begin = std::chrono::steady_clock::now();
    try {
      const CGAL::Linear_snapping::internal::Progress progress(
        CGAL::Linear_snapping::internal::strip(
          CGAL::Linear_snapping::parameters::visitor(std::ref(*this))));
      work();
    } catch(const CGAL::Linear_snapping::Invalid_input& refusal) { // of functions without a report
      error = std::make_exception_ptr(
        Refused(CGAL::Linear_snapping::Outcome::INVALID_ARGUMENT, refusal.message));
    } catch(...) {
      error = std::current_exception();
    }
    work = nullptr; // what it owns is freed here, unless the calling thread has it, too
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_error = error;
    m_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    m_is_done = true;
    m_change.notify_all();
  }

  // A line of progress: waits until it has been read. Throws `Stopped`.
  void operator()(const std::string& line)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    if(m_has_reader && !m_is_stopped) {
      m_line = line;
      m_has_line = true;
      m_change.notify_all();
      m_change.wait(lock, [&] { return !m_has_line || m_is_stopped; });
    }
    if(m_is_stopped)
      throw Stopped();
  }

  // ---- of the thread that waits

  // Returns after some time, too.
  template <typename Duration>
  void wait(const Duration most)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_change.wait_for(lock, most, [&] { return m_is_done || m_has_line; });
  }

  bool is_done()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_is_done;
  }

  // The line, if there is one; the other thread waits for `go_on()`.
  const std::string* line()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_has_line ? &m_line : nullptr;
  }

  void go_on()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_has_line = false;
    m_change.notify_all();
  }

  void stop()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_stopped = true;
    m_has_line = false;
    m_change.notify_all();
  }

  double seconds_or_error() const
  {
    if(m_error)
      std::rethrow_exception(m_error);
    return m_seconds;
  }

private:
  const bool m_has_reader;
  std::mutex m_mutex;
  std::condition_variable m_change;
  bool m_is_done = false, m_is_stopped = false, m_has_line = false;
  std::string m_line;
  std::exception_ptr m_error;
  double m_seconds = 0;
};

constexpr std::chrono::milliseconds interval(100); // between two looks at signals

struct Thread
{
  std::thread thread;
  std::shared_ptr<Shared_state> state;
};

// Guarded by the lock of the interpreter. Never destroyed: threads may run until its end.
std::vector<Thread>& interrupted_calls()
{
  static auto* const threads = new std::vector<Thread>;
  return *threads;
}

void wait_without_lock(Shared_state& state)
{
  const py::gil_scoped_release others_run;
  state.wait(interval);
}

// Returns whether nothing was raised.
bool call(const py::object& progress, const std::string& line)
{
  PyObject* const result = PyObject_CallFunction(progress.ptr(), "s", line.c_str());
  Py_XDECREF(result);
  return result != nullptr;
}

} // namespace

double run_apart(const py::object& progress, std::function<void()> work)
{
  const auto state = std::make_shared<Shared_state>(!progress.is_none());
  std::thread thread([state, work = std::move(work)]() mutable { state->run(std::move(work)); });
  while(!state->is_done()) {
    wait_without_lock(*state);
    const std::string* const line = state->line();
    if(PyErr_CheckSignals() == 0 && (line == nullptr || call(progress, *line))) {
      if(line != nullptr)
        state->go_on();
      continue;
    }
    py::error_already_set error;
    state->stop();
    wait_without_lock(*state);
    if(state->is_done())
      thread.join();
    else
      interrupted_calls().push_back({std::move(thread), state});
    throw error;
  }
  thread.join();
  return state->seconds_or_error();
}

void wait_for_interrupted_calls()
{
  std::vector<Thread>& threads = interrupted_calls(); // others may be added meanwhile, at the end
  while(!threads.empty()) {
    const std::shared_ptr<Shared_state> state = threads.front().state;
    while(!state->is_done()) {
      wait_without_lock(*state);
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
    }
    threads.front().thread.join();
    threads.erase(threads.begin());
  }
}
