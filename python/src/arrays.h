// NumPy arrays in and out: shapes and types are checked in Python, so that what comes in here is
// contiguous; what goes out owns the memory of a vector, which is not copied.

#ifndef SEAMLESS_SNAPPING_PYTHON_ARRAYS_H
#define SEAMLESS_SNAPPING_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style>;
using Integers = py::array_t<std::int64_t, py::array::c_style>;

// A copy, which calls of the core own: the caller may change the array after an interruption.
template <typename Number>
std::vector<Number> copy_of(const py::array_t<Number, py::array::c_style>& array)
{ return std::vector<Number>(array.data(), array.data() + array.size()); }

// Nothing for None.
template <typename Number>
std::vector<Number> copy_of(const std::optional<py::array_t<Number, py::array::c_style> >& array)
{ return array ? copy_of(*array) : std::vector<Number>(); }

// Rows of so many numbers.
template <std::size_t N, typename Array>
auto rows_of(const Array& array)
{
  const auto numbers = copy_of(array);
  std::vector<std::array<typename decltype(numbers)::value_type, N> > result(numbers.size() / N);
  for(std::size_t i = 0; i < N * result.size(); ++i)
    result[i / N][i % N] = numbers[i];
  return result;
}

// \param shape its product is the number of values; where a value is an array, the last one is the
//        size of that
template <typename Number, typename Value>
py::array_t<Number> to_array(std::vector<Value>&& values, std::vector<py::ssize_t> shape)
{
  static_assert(sizeof(Value) % sizeof(Number) == 0, "values are packed");
  auto owned = std::make_unique<std::vector<Value> >(std::move(values));
  const Number* const data = reinterpret_cast<const Number*>(owned->data());
  const py::capsule owner(owned.get(),
                          [](void* p) { delete static_cast<std::vector<Value>*>(p); });
  owned.release();
  return py::array_t<Number>(std::move(shape), data, owner);
}

template <typename Number, std::size_t N>
py::array_t<Number> to_array(std::vector<std::array<Number, N> >&& values)
{
  const py::ssize_t rows = py::ssize_t(values.size());
  return to_array<Number>(std::move(values), {rows, py::ssize_t(N)});
}

template <typename Number>
py::array_t<Number> to_array(std::vector<Number>&& values)
{
  const py::ssize_t size = py::ssize_t(values.size());
  return to_array<Number>(std::move(values), {size});
}

#endif // SEAMLESS_SNAPPING_PYTHON_ARRAYS_H
