// The options and files that a subcommand takes: declared with the variables that their values go to.
// Boost.Program_options, which takes long to compile, is in Options.cpp only.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_OPTIONS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_OPTIONS_H

#include "commands.h"

#include <cmath>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

extern const char* const exit_statuses; // for helps
void print_version(std::ostream& os);

// Which numbers an option takes.
struct Range
{
  double low, high;
  bool is_open = false; // without its ends
  bool is_whole = false;

  bool contains(const double x) const // no NaN
  {
    return (is_open ? x > low && x < high : x >= low && x <= high) &&
           (!is_whole || x == std::floor(x));
  }
};

inline Range whole_numbers(const double low, const double high)
{ return {low, high, false, true}; }

// The largest number of faces that is made where no other one is asked for: more are mostly a
// mistake of units.
constexpr double most_faces = 1e7;

// Throws `Failure` if an option makes more faces than `most`, which are `noun` in the plural.
// \param remedy what makes no more, or allows more
void check_number_of_faces(const std::string& option, double number, const std::string& noun,
                           const std::string& remedy, double most = most_faces);

// Such a remedy.
// \param number_at_one how many faces an edge length of 1 makes
std::string by_edge_length(double number_at_one, double most = most_faces);

class Options
{
public:
  // `usage` as in "snap IN OUT"
  Options(const std::string& usage, const std::string& purpose);
  ~Options();

  // Files are given in the order in which they are added here. All are needed, but those that are
  // optional and come last.
  void add_file(const std::string& name, std::string& filename, bool is_optional = false);

  void add(const std::string& name, bool& is_set, const std::string& help);
  void add(const std::string& name, const std::string& placeholder, double& value,
           const Range& range, const std::string& help);
  void add(const std::string& name, const std::string& placeholder, int& value,
           const Range& range, const std::string& help);
  void add(const std::string& name, const std::string& placeholder, std::string& value,
           const std::string& help);

  // An earlier name of an option that was added. It is not shown.
  void add_alias(const std::string& alias, const std::string& name);

  // Of which one can be given at most.
  void exclude(const std::vector<std::string>& names);

  // Returns false if only the help or the version was asked for, which is printed then. Throws
  // `Failure` on wrong usage.
  bool parse(const Arguments& arguments);

  // \pre `parse()` has returned
  bool is_given(const std::string& name) const;

private:
  Arguments without_aliases(Arguments arguments) const;
  void check_exclusions() const;

  struct Declarations;
  std::unique_ptr<Declarations> m_declarations;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_OPTIONS_H
