// Numbers of things in words, and the program's words in place of the library's.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <cstddef>
#include <string>

// "1 face", "2 faces", "2 border vertices", "2 branches"
inline std::string counted(const std::size_t n, std::string noun)
{
  if(n != 1 && noun.back() == 'x')
    noun.replace(noun.size() - 2, 2, "ices");
  else if(n != 1)
    noun += noun.back() == 'h' ? "es" : "s";
  return std::to_string(n) + " " + noun;
}

// The verb after it.
inline std::string is_or_are(const std::size_t n) { return n == 1 ? " is " : " are "; }

// \param words pairs of what the library says and what stands for it, wherever it says so
template <std::size_t N>
std::string with_words(std::string message, const char* const (&words)[N][2])
{
  for(const auto& [theirs, ours] : words)
    for(std::size_t i = 0; (i = message.find(theirs, i)) != message.npos;
        i += std::string(ours).size())
      message.replace(i, std::string(theirs).size(), ours);
  return message;
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
