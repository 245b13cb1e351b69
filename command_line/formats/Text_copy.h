// A copy of a text in which parts are replaced.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_TEXT_COPY_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_TEXT_COPY_H

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace formats {

// Tells 0 from -0.
inline bool is_same_number(const double x, const double y)
{
  return x == y && std::signbit(x) == std::signbit(y);
}

// Parts are replaced in the order of the text.
class Text_copy
{
public:
  explicit Text_copy(const std::string_view text)
    : m_text(text)
  {
    m_result.reserve(text.size() + text.size() / 8);
  }

  // Copies what is in front of `old`, a part of the text, and puts `replacement` in its place.
  void replace(const std::string_view old, const std::string& replacement)
  {
    const std::size_t begin = static_cast<std::size_t>(old.data() - m_text.data());
    m_result.append(m_text.substr(m_copied, begin - m_copied)).append(replacement);
    m_copied = begin + old.size();
  }

  // Copies the rest.
  std::string take() { return std::move(m_result.append(m_text.substr(m_copied))); }

private:
  std::string_view m_text;
  std::string m_result;
  std::size_t m_copied = 0; // up to this position
};

} // namespace formats

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_TEXT_COPY_H
