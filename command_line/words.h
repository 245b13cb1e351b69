// Numbers of things in words.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <cstddef>
#include <string>

// "1 face", "2 faces", "2 boundary vertices", "2 branches"
inline std::string counted(const std::size_t n, const std::string& noun)
{
  const auto ends_in = [&](const std::string& end) {
    return noun.size() >= end.size() &&
           noun.compare(noun.size() - end.size(), end.size(), end) == 0;
  };
  const std::string plural = ends_in("vertex") ? noun.substr(0, noun.size() - 2) + "ices"
                                               : noun + (ends_in("ch") ? "es" : "s");
  return std::to_string(n) + " " + (n == 1 ? noun : plural);
}

// The verb after it.
inline std::string is_or_are(const std::size_t n) { return n == 1 ? " is " : " are "; }

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
