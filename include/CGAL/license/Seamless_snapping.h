// Copyright (c) 2026
// The Seamless_snapping authors.
//
// This file is part of the Seamless_snapping package, written to become part of CGAL
// (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Seamless_snapping authors
//
// This file has the form of those that CGAL generates, see Installation/include/CGAL/license.

#ifndef CGAL_LICENSE_SEAMLESS_SNAPPING_H
#define CGAL_LICENSE_SEAMLESS_SNAPPING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE

#  if CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#    if defined(CGAL_LICENSE_WARNING)

       CGAL_pragma_warning("Your commercial license for CGAL does not cover "
                           "this release of the Seamless Snapping package.")
#    endif

#    ifdef CGAL_LICENSE_ERROR
#      error "Your commercial license for CGAL does not cover this release \
              of the Seamless Snapping package. \
              You get this error, as you defined CGAL_LICENSE_ERROR."
#    endif // CGAL_LICENSE_ERROR

#  endif // CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#else // no CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE

#  if defined(CGAL_LICENSE_WARNING)
     CGAL_pragma_warning("\nThe macro CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE is not defined."
                          "\nYou use the CGAL Seamless Snapping package under "
                          "the terms of the GPLv3+.")
#  endif // CGAL_LICENSE_WARNING

#  ifdef CGAL_LICENSE_ERROR
#    error "The macro CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE is not defined.\
            You use the CGAL Seamless Snapping package under the terms of \
            the GPLv3+. You get this error, as you defined CGAL_LICENSE_ERROR."
#  endif // CGAL_LICENSE_ERROR

#endif // no CGAL_SEAMLESS_SNAPPING_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_SEAMLESS_SNAPPING_H
