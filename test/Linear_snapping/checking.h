// The checking macros of all test programs: they work in Release builds, print the values that
// differ, and count, so that a program can close with the number of checks it made, and of tests
// that it had to leave out. A program that has checked nothing has failed.

#ifndef SEAMLESS_SNAPPING_TEST_CHECKING_H
#define SEAMLESS_SNAPPING_TEST_CHECKING_H

#include <boost/config.hpp>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

namespace checking {

struct Counts
{
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::size_t skipped = 0;
};

inline Counts& counts()
{
  static Counts instance;
  return instance;
}

// Returns whether the check passed, so that callers can add context of their own. These functions
// are called, not copied to each of hundreds of checks.
BOOST_NOINLINE inline bool record(bool passed, const char* expression, const char* file, int line)
{
  if(passed) {
    ++counts().passed;
  } else {
    ++counts().failed;
    std::cerr << file << ":" << line << ": check failed: " << expression << std::endl;
  }
  return passed;
}

template <typename A, typename B>
BOOST_NOINLINE bool record_equal(const A& a, const B& b, const char* expression, const char* file,
                                 int line)
{
  const bool equal = (a == b);
  record(equal, expression, file, line);
  if(!equal)
    std::cerr << "    left: " << a << "\n   right: " << b << std::endl;
  return equal;
}

BOOST_NOINLINE inline void tell_where(const std::string& context)
{
  std::cerr << "    in " << context << std::endl;
}

inline void skip(const std::string& what)
{
  ++counts().skipped;
  std::cout << "skipped: " << what << std::endl;
}

} // namespace checking

#define CHECK(condition) checking::record(bool(condition), #condition, __FILE__, __LINE__)
#define CHECK_EQUAL(a, b) checking::record_equal((a), (b), #a " == " #b, __FILE__, __LINE__)

// The same, telling where, as test programs go through many inputs.
#define CHECK_IN(context, condition)                                                               \
  do {                                                                                             \
    if(!CHECK(condition))                                                                          \
      checking::tell_where(context);                                                               \
  } while(false)

inline int report_checks()
{
  const checking::Counts& counts = checking::counts();
  std::cout << counts.passed << " passed, " << counts.failed << " failed, " << counts.skipped
            << " skipped" << std::endl;
  return counts.failed == 0 && counts.passed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif // SEAMLESS_SNAPPING_TEST_CHECKING_H
