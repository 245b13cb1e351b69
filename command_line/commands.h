// The subcommands of the program `seamless`. Each has a file of its own, which defines its function; to
// add one, declare it here and add it to the table in seamless.cpp and to CMakeLists.txt.
// A function gets the arguments behind the name of the subcommand, and returns if all went well; else it
// throws, mostly `Failure`.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_COMMANDS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_COMMANDS_H

#include <string>
#include <vector>

using Arguments = std::vector<std::string>;

void check(const Arguments& arguments);
void hexes(const Arguments& arguments);
void layout(const Arguments& arguments);
void make_body(const Arguments& arguments);
void parametrize(const Arguments& arguments);
void quads(const Arguments& arguments);
void remesh(const Arguments& arguments);
void snap(const Arguments& arguments);
void trace(const Arguments& arguments);

// The same for tetrahedral meshes, to which `snap` and `check` turn where a file is one.
bool is_volume(const Arguments& arguments);
void check_volume(const Arguments& arguments);
void snap_volume(const Arguments& arguments);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_COMMANDS_H
