#include "Progress.h"

#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace {

bool is_error_stream_a_terminal()
{
#if __has_include(<unistd.h>)
  return isatty(STDERR_FILENO) != 0;
#else
  return false;
#endif
}

} // namespace

// Writes one line, which it brings up to date each second.
class Progress::Clock
{
public:
  explicit Clock(const std::string& step)
    : m_step(step), m_start(std::chrono::steady_clock::now()), m_thread([this] { run(); })
  { }

  ~Clock()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_is_done = true;
    }
    m_done.notify_one();
    m_thread.join();
  }

private:
  void run()
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    long seconds = 0;
    while(!m_done.wait_until(lock, m_start + std::chrono::seconds(seconds + 1),
                             [this] { return m_is_done; }))
      std::cerr << "\r" + m_step + ": " + std::to_string(++seconds) + " s" << std::flush;
    if(seconds > 0)
      std::cerr << "\n" << std::flush;
  }

  const std::string m_step;
  const std::chrono::steady_clock::time_point m_start;
  std::mutex m_mutex;
  std::condition_variable m_done;
  bool m_is_done = false;
  std::thread m_thread; // last, as it uses the others
};

Progress::Progress(const std::string& step, const bool verbose)
{
  if(verbose)
    std::cerr << step << std::endl;
  else if(is_error_stream_a_terminal())
    m_clock = std::make_unique<Clock>(step);
}

Progress::~Progress() = default;
