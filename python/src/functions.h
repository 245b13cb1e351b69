// The functions of the module, each group in a source of its own.

#ifndef SEAMLESS_SNAPPING_PYTHON_FUNCTIONS_H
#define SEAMLESS_SNAPPING_PYTHON_FUNCTIONS_H

#include <pybind11/pybind11.h>

void add_snapping(pybind11::module_& module);
void add_parametrization(pybind11::module_& module);
void add_remeshing(pybind11::module_& module);
void add_extraction(pybind11::module_& module);
void add_layouts(pybind11::module_& module);
void add_volumes(pybind11::module_& module);
void add_hexahedra(pybind11::module_& module);
void add_linear(pybind11::module_& module);

#endif // SEAMLESS_SNAPPING_PYTHON_FUNCTIONS_H
