// Parts that the reports of several commands have in common, as JSON.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H

#include "Failure.h"
#include "files.h"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

inline nlohmann::json
json_of_steps(const std::vector<std::pair<std::string, double> >& step_times)
{
  nlohmann::json steps = nlohmann::json::array();
  for(const auto& [name, seconds] : step_times)
    steps.push_back({{"step", name}, {"seconds", seconds}});
  return steps;
}

// What was not measured is null.
template <typename T>
nlohmann::json if_known(const bool is_known, const T& x)
{ return is_known ? nlohmann::json(x) : nlohmann::json(); }

// Names of files in messages may hold bytes that are not UTF-8; JSON cannot.
inline void write_json(const std::string& filename, const nlohmann::json& json)
{
  write_file(filename, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

// What `read()` returns. What keeps it from reading is in the report, too, where one is asked for:
// else that of an earlier run would stay.
// \param success the name of what the report says of a success
template <typename Read>
auto read_or_tell(const std::string& report, const char* const success, const Read& read)
{
  try {
    return read();
  } catch(const Failure& failure) {
    if(!report.empty())
      write_json(report, {{success, false}, {"message", failure.what()}});
    throw;
  }
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H
