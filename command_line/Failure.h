// The exit statuses of a subcommand. Only `SUCCESS` says that the task is done, and written.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_FAILURE_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_FAILURE_H

#include <stdexcept>
#include <string>

// `STILL_FLIPPED`: the result is exact and written, but flips remain after a repair, or quads are
// inverted or folded, or they are more than twice as many as wanted and nothing forces them.
enum Exit
{
  SUCCESS = 0, NOT_SOLVED = 1, USAGE = 2, UNREADABLE = 3, UNWRITABLE = 4, STILL_FLIPPED = 5
};

inline bool is_written(const Exit status) { return status == SUCCESS || status == STILL_FLIPPED; }

struct Failure : public std::runtime_error
{
  Failure(Exit exit, const std::string& message) : std::runtime_error(message), status(exit) { }
  Exit status;
};

// Runs `work()`; then `tell(status, message)` reports how it ended, and a failure is thrown again.
template <typename Work, typename Tell>
void run_and_tell(const Work& work, const Tell& tell)
{
  Exit status = SUCCESS;
  std::string message;
  try {
    work();
  } catch(const Failure& failure) {
    status = failure.status;
    message = failure.what();
  }
  tell(status, message);
  if(status != SUCCESS)
    throw Failure(status, message);
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_FAILURE_H
