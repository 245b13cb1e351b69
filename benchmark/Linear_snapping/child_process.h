// Runs a function in a process of its own (POSIX): it can be stopped when its time is up, and
// neither its memory nor a crash affects the caller.

#ifndef SEAMLESS_SNAPPING_BENCHMARK_CHILD_PROCESS_H
#define SEAMLESS_SNAPPING_BENCHMARK_CHILD_PROCESS_H

#include "benchmark_tools.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <limits>
#include <new>
#include <string>

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace benchmark {

enum class Child_end { FINISHED, TIME_IS_UP, OUT_OF_MEMORY, FAILED };

struct Child_limits
{
  double seconds = std::numeric_limits<double>::infinity();
  std::size_t megabytes = 0; // 0: no limit
};

namespace internal {

template <typename Function>
[[noreturn]] void run_child(const Function& f, const Child_limits& limits, int pipe_end)
{
  if(limits.megabytes > 0) {
    const rlim_t bytes = rlim_t(limits.megabytes) << 20;
    const rlimit limit = { bytes, bytes };
    setrlimit(RLIMIT_AS, &limit);
  }
  int status = 1;
  try {
    const std::string text = f();
    status = write(pipe_end, text.data(), text.size()) == ssize_t(text.size()) ? 0 : 1;
  } catch(const std::bad_alloc&) {
    status = 2;
  } catch(const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  _exit(status);
}

// Until the other end is closed; false if the time is up before.
inline bool read_until(double deadline, int pipe_end, std::string& text)
{
  for(;;) {
    const double rest = 1000 * (std::min)(deadline - seconds_now(), 1000.);
    pollfd readable = { pipe_end, POLLIN, 0 };
    if(rest <= 0)
      return false;
    if(poll(&readable, 1, int(rest) + 1) <= 0)
      continue;
    char buffer[4096];
    const ssize_t size = read(pipe_end, buffer, sizeof(buffer));
    if(size <= 0)
      return true;
    text.append(buffer, std::size_t(size));
  }
}

} // namespace internal

// f() returns a std::string, which comes back in `text`.
template <typename Function>
Child_end run_in_child(const Function& f, const Child_limits& limits, std::string& text)
{
  text.clear();
  std::fflush(stdout);
  int ends[2];
  if(pipe(ends) != 0)
    return Child_end::FAILED;
  const double deadline = seconds_now() + limits.seconds;
  const pid_t child = fork();
  if(child < 0) {
    close(ends[0]);
    close(ends[1]);
    return Child_end::FAILED;
  }
  if(child == 0) {
    close(ends[0]);
    internal::run_child(f, limits, ends[1]);
  }
  close(ends[1]);
  const bool is_in_time = internal::read_until(deadline, ends[0], text);
  close(ends[0]);
  if(!is_in_time)
    kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if(!is_in_time)
    return Child_end::TIME_IS_UP;
  if(status == 0)
    return Child_end::FINISHED;
  return WIFEXITED(status) && WEXITSTATUS(status) == 2 ? Child_end::OUT_OF_MEMORY
                                                       : Child_end::FAILED;
}

} // namespace benchmark

#endif // SEAMLESS_SNAPPING_BENCHMARK_CHILD_PROCESS_H
