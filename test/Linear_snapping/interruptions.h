// Visitors that end the work of a function, at each call that it makes.

#ifndef SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H
#define SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H

#include "checking.h"

#include <CGAL/Linear_snapping/internal/support/Progress.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace interruptions {

using Visitor = std::function<void(const std::string&)>;

struct Interruption
{ };

// Calls run(visitor) with visitors that throw at the first call, at the second, and so on; steps
// become longer where there are many. The last call is among these: behind it, all is written.
// Nothing is left of such a run. At the end is one without an interruption, which succeeds. Returns
// the texts.
// \param run begins with what is there before, and returns whether it succeeded
template <typename Run, typename Is_untouched>
std::set<std::string> test(const std::string& name, const Run& run,
                           const Is_untouched& is_untouched)
{
  using CGAL::Linear_snapping::internal::Progress;
  const auto usual = Progress::interval;
  Progress::interval = decltype(usual)(0); // all that may be told
  std::set<std::string> texts;
  std::size_t calls = 0;
  const auto succeeds = [&](const std::size_t last) { // as there are fewer calls
    calls = 0;
    const auto visitor = [&](const std::string& text) {
      texts.insert(text);
      Progress::tell([] { return "not to be told"; });
      if(++calls == last)
        throw Interruption();
    };
    bool result = true;
    try {
      CHECK_IN(name, run(visitor));
      CHECK_IN(name, calls < last && calls > 1 && !is_untouched());
    } catch(const Interruption&) {
      CHECK_IN(name + ", call " + std::to_string(last), calls == last && is_untouched());
      result = false;
    }
    Progress::tell([&] { return texts.insert("nobody listens"), std::string(); });
    return result;
  };
  std::size_t last = 1;
  while(!succeeds(last))
    last += 1 + last / 3;
  succeeds(calls);
  CHECK_IN(name, succeeds((std::numeric_limits<std::size_t>::max)()));
  Progress::interval = usual;
  CHECK_IN(name, texts.count("") + texts.count("nobody listens") +
                   texts.count("not to be told") == 0);
  return texts;
}

} // namespace interruptions

#endif // SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H
