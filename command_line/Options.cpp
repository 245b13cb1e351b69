#include "Options.h"

#include "Failure.h"

#include <boost/program_options.hpp>

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace po = boost::program_options;

const char* const exit_statuses =
  "Exit status: 0 done; 1 failed, or the checked file is not exact; 2 wrong usage; 3 an input cannot\n"
  "be read; 4 an output cannot be written; 5 written, but with flaws that the messages name: faces\n"
  "or cells that a repair left flipped, inverted or folded quads, inverted hexahedra, or more than\n"
  "twice as many quads as wanted although nothing in the input forces them.\n";

void print_version(std::ostream& os)
{
  os << "seamless " << SEAMLESS_SNAPPING_VERSION << std::endl;
}

namespace {

std::string in_words(const Range& range)
{
  std::ostringstream os;
  os << std::setprecision(17) << (range.is_whole ? "must be a whole number " : "must be ");
  if(range.high < (std::numeric_limits<double>::max)())
    os << (range.is_open ? "between " : "from ") << range.low << (range.is_open ? " and " : " to ")
       << range.high;
  else
    os << (range.contains(range.high) && !std::isfinite(range.high) ? "" : "finite, and ")
       << (range.is_open ? "greater than " : "at least ") << range.low;
  return os.str();
}

// Checks the given number against the range.
template <typename Number>
po::typed_value<Number>* value_in_range(const std::string& name, const std::string& placeholder,
                                        Number& value, const Range& range)
{
  return po::value(&value)->value_name(placeholder)->notifier([name, range](const Number& x) {
    if(!range.contains(x))
      throw Failure(USAGE, "--" + name + " " + in_words(range));
  });
}

} // namespace

void check_number_of_faces(const std::string& option, const double number, const std::string& noun,
                           const std::string& remedy, const double most)
{
  constexpr double most_written_out = 1e15;
  if(!(number > most))
    return;
  std::ostringstream os;
  os << "--" << option << " makes ";
  if(number > most_written_out)
    os << "more than 1e15";
  else
    os << "about " << std::llround(number);
  os << " " << noun << ", at most ";
  if(most < 1e6)
    os << std::llround(most);
  else
    os << most / 1e6 << " million";
  os << " are made" << remedy;
  throw Failure(USAGE, os.str());
}

std::string by_edge_length(const double number_at_one, const double most)
{
  constexpr double slightly_longer = 1.001; // than rounding makes it
  std::ostringstream os;
  os << std::setprecision(4) << ", by --edge-length "
     << slightly_longer * std::sqrt(number_at_one / most);
  return os.str();
}

struct Options::Declarations
{
  std::string usage, purpose;
  po::options_description shown{"Options"}, files;
  po::positional_options_description order;
  std::vector<std::string*> filenames; // that are needed
  std::vector<std::array<std::string, 2> > aliases; // each with the name that it stands for
  std::vector<std::vector<std::string> > exclusions;
  po::variables_map values;
};

Options::Options(const std::string& usage, const std::string& purpose)
  : m_declarations(std::make_unique<Declarations>())
{
  m_declarations->usage = usage;
  m_declarations->purpose = purpose;
}

Options::~Options() = default;

void Options::add_file(const std::string& name, std::string& filename, const bool is_optional)
{
  m_declarations->files.add_options()(name.c_str(), po::value(&filename));
  m_declarations->order.add(name.c_str(), 1);
  if(!is_optional)
    m_declarations->filenames.push_back(&filename);
}

void Options::add_alias(const std::string& alias, const std::string& name)
{
  m_declarations->aliases.push_back({"--" + alias, "--" + name});
}

void Options::exclude(const std::vector<std::string>& names)
{
  m_declarations->exclusions.push_back(names);
}

void Options::add(const std::string& name, bool& is_set, const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(), po::bool_switch(&is_set), help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, double& value,
                  const Range& range, const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(),
                                      value_in_range(name, placeholder, value, range),
                                      help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, int& value,
                  const Range& range, const std::string& help)
{
  m_declarations->shown.add_options()(name.c_str(),
                                      value_in_range(name, placeholder, value, range),
                                      help.c_str());
}

void Options::add(const std::string& name, const std::string& placeholder, std::string& value,
                  const std::string& help)
{
  const auto check = [name](const std::string& text) {
    if(text.empty())
      throw Failure(USAGE, "--" + name + " is empty");
  };
  m_declarations->shown.add_options()(
    name.c_str(), po::value(&value)->value_name(placeholder)->notifier(check), help.c_str());
}

// "--svg" and "--svg=FILE" become "--picture" and "--picture=FILE".
Arguments Options::without_aliases(Arguments arguments) const
{
  for(std::string& argument : arguments)
    for(const auto& [alias, name] : m_declarations->aliases)
      if(argument == alias || argument.compare(0, alias.size() + 1, alias + "=") == 0)
        argument.replace(0, alias.size(), name);
  return arguments;
}

void Options::check_exclusions() const
{
  for(const std::vector<std::string>& names : m_declarations->exclusions) {
    std::string given;
    for(const std::string& name : names)
      if(is_given(name)) {
        if(!given.empty())
          throw Failure(USAGE, "--" + given + " and --" + name + " exclude each other");
        given = name;
      }
  }
}

bool Options::parse(const Arguments& arguments)
{
  Declarations& d = *m_declarations;
  const std::string command = d.usage.substr(0, d.usage.find(' '));
  d.shown.add_options()("version", "show the version")("help,h", "show this text");
  po::options_description all;
  all.add(d.shown).add(d.files);
  try {
    namespace style = po::command_line_style;
    po::store(po::command_line_parser(without_aliases(arguments))
                .options(all)
                .positional(d.order)
                .style(style::unix_style & ~style::allow_guessing)
                .run(),
              d.values);
    if(d.values.count("help") == 0 && d.values.count("version") == 0)
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
  check_exclusions();
  return true;
}

bool Options::is_given(const std::string& name) const
{
  const po::variables_map& values = m_declarations->values;
  return values.count(name) != 0 && !values[name].defaulted(); // as switches are
}
