// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Hexahedral_meshing package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Seamless_snapping authors
//
// Tells the licence where `CGAL_LICENSE_WARNING` or `CGAL_LICENSE_ERROR` asks for it, like the
// headers that CGAL generates. There is none but the GPL.

#ifndef CGAL_LICENSE_HEXAHEDRAL_MESHING_H
#define CGAL_LICENSE_HEXAHEDRAL_MESHING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("\nYou use the package Hexahedral Meshing "
                    "under the terms of the GPLv3+.")
#endif

#ifdef CGAL_LICENSE_ERROR
#  error "You use the package Hexahedral Meshing under the terms of the GPLv3+. \
          You get this error, as you defined CGAL_LICENSE_ERROR."
#endif

#endif // CGAL_LICENSE_HEXAHEDRAL_MESHING_H
