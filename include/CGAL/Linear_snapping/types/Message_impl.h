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

#ifndef CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_IMPL_H
#define CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_IMPL_H

#include <CGAL/license/Linear_snapping.h>

// How messages are put together.

#include <CGAL/Linear_snapping/internal/support/compiled_once.h>
#include <CGAL/Linear_snapping/types/Message.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#ifdef CGAL_SEAMLESS_SNAPPING_COMPILED
template class std::vector<CGAL::Linear_snapping::Message::Part>;
#endif

namespace CGAL {
namespace Linear_snapping {

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message::Message(const char* const text) : Message(std::string(text)) { }

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message::Message(std::string text)
{
  if(!text.empty())
    m_parts.push_back({TEXT, std::move(text)});
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message::Message(const Kind kind, std::string words, const std::size_t index)
  : m_parts{{kind, std::move(words), index}}
{ }

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message& Message::operator+=(const Message& other)
{
  m_parts.insert(m_parts.end(), other.m_parts.begin(), other.m_parts.end());
  return *this;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
Message Message::without_remedies() const
{
  Message result;
  result.m_parts.assign(m_parts.begin(), std::find_if(m_parts.begin(), m_parts.end(),
                        [](const Part& part) { return part.kind == REMEDY; }));
  return result;
}

CGAL_SEAMLESS_SNAPPING_INLINE_FUNCTION
std::string Message::str() const
{
  return str([](const Part& part) { return part.words; },
             [](const Part& part) { return part.index; });
}

} // namespace Linear_snapping
} // namespace CGAL

#endif // CGAL_LINEAR_SNAPPING_TYPES_MESSAGE_IMPL_H
