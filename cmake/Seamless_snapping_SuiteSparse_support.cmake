# The target Seamless_snapping::SuiteSparse_support, where SuiteSparse is found: programs that link
# it compute parametrizations, and spread roundings to integer grids, with its solver CHOLMOD.

find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

if(CHOLMOD_INCLUDE_DIR AND CHOLMOD_LIBRARY AND
   NOT TARGET Seamless_snapping::SuiteSparse_support)
  add_library(Seamless_snapping::SuiteSparse_support INTERFACE IMPORTED GLOBAL)
  set_target_properties(Seamless_snapping::SuiteSparse_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_SEAMLESS_SNAPPING_USE_SUITESPARSE
    INTERFACE_INCLUDE_DIRECTORIES "${CHOLMOD_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${CHOLMOD_LIBRARY}")
endif()
