# Whether the Python module can be built: `builds_python_module`. The interpreter is that of the
# system, whose packages pybind11-dev and python3-numpy are, unless Python_EXECUTABLE names another.

if(UNIX AND NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(builds_python_module OFF)
find_package(Python 3.8 QUIET COMPONENTS Interpreter Development.Module NumPy)
if(Python_FOUND)
  find_package(pybind11 2.10 CONFIG QUIET)
endif()
if(Python_FOUND AND pybind11_FOUND)
  set(builds_python_module ON)
else()
  message("NOTICE: The Python module requires Python's headers, NumPy and pybind11, and will "
          "not be built.")
endif()
