// Numbers of things in words, and the program's words in place of the library's.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <CGAL/Linear_snapping/internal/support/counted.h>

#include <cstddef>
#include <string>

using CGAL::Seamless_snapping::internal::counted;

// The verb after it.
inline std::string is_or_are(const std::size_t n) { return n == 1 ? " is " : " are "; }

// \param words pairs of what the library says and what stands for it
template <std::size_t N>
std::string with_words(std::string message, const char* const (&words)[N][2])
{
  for(const auto& [theirs, ours] : words)
    if(const std::size_t i = message.find(theirs); i != message.npos)
      message.replace(i, std::string(theirs).size(), ours);
  return message;
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
