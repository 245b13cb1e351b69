// Numbers of things in words.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <cstddef>
#include <string>

// "1 face", "2 faces", "2 boundary vertices"
inline std::string counted(const std::size_t n, const std::string& noun)
{
  const std::string vertex = "vertex";
  const bool is_vertex = noun.size() >= vertex.size() &&
                         noun.compare(noun.size() - vertex.size(), vertex.size(), vertex) == 0;
  const std::string plural = is_vertex ? noun.substr(0, noun.size() - 2) + "ices" : noun + "s";
  return std::to_string(n) + " " + (n == 1 ? noun : plural);
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
