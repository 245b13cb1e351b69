// The program `seamless`: chooses the subcommand, and tells how it ended.

#include "Failure.h"
#include "Options.h"
#include "commands.h"
#include "words.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <new>
#include <string>

struct Command
{
  const char* name;
  const char* purpose;
  const char* remedy; // where memory is not enough
  void (*run)(const Arguments&);
};

const std::array<Command, 9> commands = {{
  {"remesh", "make a mesh of quads from a triangle mesh", "; ask for fewer quads by --number",
   remesh},
  {"parametrize", "compute an exactly seamless parametrization of a triangle mesh", "",
   parametrize},
  {"snap", "make the parametrization in a file exactly seamless", "", snap},
  {"check", "tell whether the parametrization in a file is exactly seamless", "", check},
  {"quads", "make a mesh of quads from a parametrization",
   "; ask for fewer quads by --number", quads},
  {"hexes", "make a mesh of hexahedra from a parametrized tetrahedral mesh",
   "; ask for fewer hexahedra by --number", hexes},
  {"layout", "divide a parametrized surface into rectangles along isocurves", "", layout},
  {"trace", "follow isocurves from singular vertices, before and after snapping",
   "; lower --maximum-number, or leave out --all", trace},
  {"body", "make a surface of a given genus to try things on", "; raise --edge-length", make_body}
}};

void print_help(std::ostream& os)
{
  os << "Usage: seamless COMMAND ...\n\n";
  for(const Command& command : commands)
    os << "  " << std::left << std::setw(13) << command.name << command.purpose << "\n";
  os << "\nseamless COMMAND --help shows the options of a command; for tetrahedral meshes,\n"
        "seamless snap IN.hexex --help, and seamless check IN.hexex --help. seamless --version shows\n"
        "the version. Try: seamless body a.off; seamless remesh a.off b.obj --number 2000\n\n"
     << exit_statuses;
}

void run(Arguments arguments)
{
  if(arguments.size() == 2 && arguments.front() == "help") // of a command
    arguments = {arguments.back(), "--help"};
  const std::string name = arguments.empty() ? "" : arguments.front();
  if(name == "--help" || name == "-h" || name == "help")
    return print_help(std::cout);
  if(name == "--version")
    return print_version(std::cout);
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& c) { return c.name == name; });
  if(command == commands.end()) {
    print_help(std::cerr);
    throw Failure(USAGE, name.empty() ? "a command is needed"
                                      : "'" + name + "' is not a command");
  }
  speak_for(command->name);
  try {
    command->run(Arguments(arguments.begin() + 1, arguments.end()));
  } catch(const std::bad_alloc&) {
    throw Failure(NOT_SOLVED, std::string("out of memory") + command->remedy);
  }
  if(!std::cout.flush())
    throw Failure(UNWRITABLE, "cannot write to the standard output");
}

// Under a name of its own, the program is the command that goes by this name.
Arguments arguments_with_command(const int argc, char** argv)
{
  Arguments result(argv + (std::min)(argc, 1), argv + argc);
  const std::string name = argc > 0 ? std::filesystem::path(argv[0]).stem().string() : "";
  if(name == "quad_obj")
    result.insert(result.begin(), "quads");
  else if(name == "quad_remesh")
    result.insert(result.begin(), "remesh");
  return result;
}

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN); // writing fails then, and what was written is removed
#endif
  try {
    run(arguments_with_command(argc, argv));
    return SUCCESS;
  } catch(const Failure& failure) {
    std::cerr << "seamless: " << failure.what() << std::endl;
    return failure.status;
  } catch(const std::exception& error) {
    std::cerr << "seamless: " << error.what() << std::endl;
  }
  return NOT_SOLVED;
}
