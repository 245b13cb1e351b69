// Parts that the reports of several commands have in common, as JSON.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H

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

// Names of files in messages may hold bytes that are not UTF-8; JSON cannot.
inline void write_json(const std::string& filename, const nlohmann::json& json)
{
  write_file(filename, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_JSON_REPORT_H
