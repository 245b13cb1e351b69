#include "Options.h"

#include "Failure.h"

#include <boost/program_options.hpp>

#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace po = boost::program_options;

const char* const exit_statuses =
  "Exit status: 0 done; 1 no exact solution was found, or the file is not exact; 2 wrong usage;\n"
  "3 an input cannot be read; 4 an output cannot be written.\n";

void print_version(std::ostream& os)
{
  os << "seamless " << SEAMLESS_SNAPPING_VERSION << std::endl;
}

struct Options::Declarations
{
  std::string usage, purpose;
  po::options_description shown{"Options"}, files;
  po::positional_options_description order;
  std::vector<std::string*> filenames;
  po::variables_map values;
};

Options::Options(const std::string& usage, const std::string& purpose)
  : m_declarations(std::make_unique<Declarations>())
{
  m_declarations->usage = usage;
  m_declarations->purpose = purpose;
}

Options::~Options() = default;

void Options::add_file(const std::string& name, std::string& filename)
{
  m_declarations->files.add_options()(name.c_str(), po::value(&filename));
  m_declarations->order.add(name.c_str(), 1);
  m_declarations->filenames.push_back(&filename);
}

void Options::add(const std::string& name, bool& is_set, const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(), po::bool_switch(&is_set), help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, double& value,
                  const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(), po::value(&value)->value_name(placeholder),
                                      help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, int& value,
                  const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(), po::value(&value)->value_name(placeholder),
                                      help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, std::string& value,
                  const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(), po::value(&value)->value_name(placeholder),
                                      help.c_str());
}

bool Options::parse(const Arguments& arguments)
{
  Declarations& d = *m_declarations;
  const std::string command = d.usage.substr(0, d.usage.find(' '));
  d.shown.add_options()("version", "tell the version")("help,h", "show this text");
  po::options_description all;
  all.add(d.shown).add(d.files);
  try {
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(arguments)
                .options(all)
                .positional(d.order)
                .style(style::unix_style & ~style::allow_guessing)
                .run(),
              d.values);
    po::notify(d.values);
  } catch(const po::error& error) {
    throw Failure(USAGE, std::string(error.what()) + "; see seamless " + command + " --help");
  }
  if(is_given("version"))
    print_version(std::cout);
  if(is_given("help"))
    std::cout << "Usage: seamless " << d.usage << " [options]\n\n" << d.purpose << "\n" << d.shown
              << "\n" << exit_statuses;
  if(is_given("version") || is_given("help"))
    return false;
  for(const std::string* filename : d.filenames)
    if(filename->empty())
      throw Failure(USAGE, "usage: seamless " + d.usage + " [options]; see seamless " + command
                             + " --help");
  return true;
}

bool Options::is_given(const std::string& name) const
{
  return m_declarations->values.count(name) != 0;
}
