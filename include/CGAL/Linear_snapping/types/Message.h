// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Linear_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors

#ifndef CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_H
#define CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_H

#include <CGAL/license/Linear_snapping.h>

// The message of a report. Elements, parameters, and remedies are data in it, so that programs with
// other names for them make a sentence of the same data, and search no text.

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Linear_snapping {

/*!
\ingroup PkgLinearSnappingRef

The message of a report: a place, a reason, and a remedy. It converts to a `std::string` that uses
the names of parameters in C++, and indices from 0. A program can replace these names and numbers by
others, part by part.
*/
class Message
{
public:
  /// the kinds of parts
  enum Kind
  {
    TEXT,   ///< words that need no translation
    TERM,   ///< words with the name of a parameter or function
    REMEDY, ///< what the caller can do, with such names; it follows a semicolon
    FACE,   ///< a face of the input
    VERTEX, ///< a vertex of the input
    ELEMENT ///< another element, such as a cell
  };

  /// a part of a message
  struct Part
  {
    Kind kind;             ///< its kind
    std::string words;     ///< the words; of an element: its noun, or nothing after another element
    std::size_t index = 0; ///< the index of an element
  };

  /// \cond SKIP_IN_MANUAL
  Message() = default;
  Message(const char* text);
  Message(std::string text);
  Message(Kind kind, std::string words, std::size_t index = 0);

  Message& operator+=(const Message& other);
  friend Message operator+(Message a, const Message& b) { return std::move(a += b); }
  friend std::ostream& operator<<(std::ostream& os, const Message& m) { return os << m.str(); }
  friend bool operator==(const Message& a, const Message& b) { return a.str() == b.str(); }
  operator std::string() const { return str(); }
  static constexpr std::size_t npos = std::string::npos;
  std::size_t find(const std::string& text) const { return str().find(text); }

  Message without_remedies() const;

  // \param number a callable that returns the number of an element of this kind by its index
  template <typename Number>
  void renumber(const Kind kind, const Number& number)
  {
    for(Part& part : m_parts)
      part.index = part.kind == kind ? number(part.index) : part.index;
  }
  /// \endcond

  /// returns whether there is nothing to say.
  bool empty() const { return m_parts.empty(); }

  /// returns the parts in their order.
  const std::vector<Part>& parts() const { return m_parts; }

  /// returns the sentence in words of C++.
  std::string str() const;

  /*!
  returns the sentence in words of another language.
  \param words a callable that returns the words of a part of the kind `TERM` or `REMEDY`. A remedy
         without words is left out.
  \param number a callable that returns the number that the user knows of an element
  */
  template <typename Words, typename Number>
  std::string str(const Words& words, const Number& number) const
  {
    std::string result;
    for(const Part& part : m_parts) {
      const bool has_words = part.kind == TERM || part.kind == REMEDY;
      const std::string text = has_words ? words(part) : part.words;
      if(part.kind == REMEDY && !text.empty() && !result.empty())
        result += "; ";
      result += text;
      if(part.kind >= FACE)
        result += (text.empty() ? "" : " ") + std::to_string(number(part));
    }
    return result;
  }

private:
  std::vector<Part> m_parts;
};

/// \cond SKIP_IN_MANUAL
// "1 face", "2 faces", "2 boundary vertices", "2 branches", for messages
inline std::string counted(const std::size_t n, std::string noun)
{
  if(n != 1 && noun.back() == 'x')
    noun.replace(noun.size() - 2, 2, "ices");
  else if(n != 1)
    noun += noun.back() == 'h' ? "es" : "s";
  return std::to_string(n) + " " + noun;
}
/// \endcond

} // namespace Linear_snapping
} // namespace CGAL

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
extern template class std::vector<CGAL::Linear_snapping::Message::Part>;
#else
#include <CGAL/Linear_snapping/types/Message_impl.h>
#endif

#endif // CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_H
