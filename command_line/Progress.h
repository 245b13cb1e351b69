// Tells on the error stream what goes on: on a terminal, once a step takes longer than a second; of
// each step, if asked to.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_PROGRESS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_PROGRESS_H

#include <memory>
#include <string>

// Of one step, from the construction of the object to its end.
class Progress
{
public:
  explicit Progress(const std::string& step, bool verbose = false);
  ~Progress();

private:
  class Clock;
  std::unique_ptr<Clock> m_clock; // none where nothing is told
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_PROGRESS_H
