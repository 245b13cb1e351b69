// Numbers of things in words.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <CGAL/Linear_snapping/internal/support/counted.h>

#include <cstddef>

using CGAL::Seamless_snapping::internal::counted;

// The verb after it.
inline std::string is_or_are(const std::size_t n) { return n == 1 ? " is " : " are "; }

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
