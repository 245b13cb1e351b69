// Numbers of things in words, and the program's words in place of the library's.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H

#include <CGAL/Linear_snapping/types/Message.h>

#include <cstddef>
#include <string>
#include <string_view>

// "1 face", "2 faces", "2 border vertices", "2 branches"
using CGAL::Linear_snapping::counted;

// The verb after it.
inline std::string is_or_are(const std::size_t n) { return n == 1 ? " is " : " are "; }

// The command in whose words messages are from now on: remedies are options of it.
void speak_for(std::string_view command);

// What stands for the library's parameters, functions, and remedies.
std::string words_of_program(const CGAL::Linear_snapping::Message::Part& part);

// A message of the library on a volume or a system, whose elements the user counts as it does.
std::string in_words_of_user(const CGAL::Linear_snapping::Message& message);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_WORDS_H
