// Visitors that end the work of a function, at each call that it makes.

#ifndef SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H
#define SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H

#include "checking.h"

#include <CGAL/Linear_snapping/internal/support/Progress.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <set>
#include <string>

namespace interruptions {

using Visitor = std::function<void(const std::string&)>;

struct Interruption
{ };

// Calls run(visitor) with visitors that throw at the first call, at the second, and so on; steps
// become longer where there are many. Nothing is left of such a run, and the last one, without an
// interruption, succeeds. Returns the texts.
// \param run returns whether it succeeded
template <typename Run, typename Is_untouched>
std::set<std::string> test(const std::string& name, const Run& run,
                           const Is_untouched& is_untouched)
{
  using CGAL::Linear_snapping::internal::Progress;
  const auto usual = Progress::interval;
  Progress::interval = decltype(usual)(0); // all that may be told
  std::set<std::string> texts;
  for(std::size_t last = 1, is_done = 0; is_done == 0; last += 1 + last / 3) {
    std::size_t calls = 0;
    const auto visitor = [&](const std::string& text) {
      texts.insert(text);
      Progress::tell([] { return "not to be told"; });
      if(++calls == last)
        throw Interruption();
    };
    try {
      CHECK_IN(name, run(visitor));
      CHECK_IN(name, calls < last && calls > 1);
      is_done = 1;
    } catch(const Interruption&) {
      CHECK_IN(name + ", call " + std::to_string(last), calls == last && is_untouched());
    }
    Progress::tell([&] { return texts.insert("nobody listens"), std::string(); });
  }
  Progress::interval = usual;
  CHECK_IN(name, texts.count("") + texts.count("nobody listens") +
                   texts.count("not to be told") == 0);
  return texts;
}

} // namespace interruptions

#endif // SEAMLESS_SNAPPING_TEST_INTERRUPTIONS_H
