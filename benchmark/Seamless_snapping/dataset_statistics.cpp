// What snap_to_seamless() does on OBJ files, as in Tables 1 and 2 of the paper: size, time of the
// steps, density of the constraint matrix, violation, change, and orientation. Prints a table in
// Markdown, with the averages of the data set, and writes CSV where asked to.
//
//   dataset_statistics FILE_OR_FOLDER... [--noise X --seed S] [--features] [--align-border]
//                                        [--csv FILE]
//
// With --noise, every sector beside a cut is first moved by up to X times the extent, in both
// coordinates.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/is_seamless.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>
#include <CGAL/Seamless_snapping/snap_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>
#include <sstream>
#include <optional>
#include <string>
#include <vector>

namespace options = benchmark::options;
namespace SS = CGAL::Seamless_snapping;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Feature_map = Mesh::Property_map<Mesh::Edge_index, bool>;

struct Settings
{
  std::vector<std::string> names;
  std::string csv;
  double noise = 0;
  unsigned int seed = 1;
  bool features = false, align_border = false;
};

// Corners that no cut separates move together.
void add_noise(const Mesh& mesh, UV_map uv, const double size, const unsigned int seed)
{
  const auto transitions = SS::seam_transitions(mesh, uv, SS::parameters::tolerance(1.));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> component(-size, size);
  const auto begins_sector = [&](const Mesh::Halfedge_index h)
  { return mesh.is_border(mesh.opposite(h)) || transitions.is_cut(h); };
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const auto around = mesh.halfedges_around_target(mesh.halfedge(v));
    const auto cut = std::find_if(around.begin(), around.end(),
                                  [&](const auto h) { return transitions.is_cut(h); });
    if(cut == around.end())
      continue;
    Mesh::Halfedge_index h = *cut;
    Kernel::Vector_2 move(0, 0);
    do {
      if(!mesh.is_border(h)) {
        if(begins_sector(h))
          move = Kernel::Vector_2(component(random), component(random));
        uv[h] = uv[h] + move;
      }
      h = mesh.opposite(mesh.next(h));
    } while(h != *cut);
  }
}

// --- one model -----------------------------------------------------------------------------------

struct Column
{
  std::string name;
  int digits; // in fixed notation; -1 for scientific
};

const std::vector<Column> columns = {
  {"#F", 0}, {"#N", 0}, {"#B", 0},
  {"transitions ms", 2}, {"elimination ms", 2}, {"solution ms", 2}, {"total ms", 2},
  {"density %", 4}, {"after %", 4}, {"violation", -1}, {"mean change", -1}, {"rms / optimum", 6},
  {"largest change", -1}, {"/ unrepaired", 4},
  {"flips", 1}, {"lost", 1}, {"still lost", 1}, {"flips after", 1}};

// Returns no values if the model can't be read or snapped.
std::vector<double> measure(const std::filesystem::path& file, const Settings& settings)
{
  Mesh mesh;
  const auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  const auto read = SS::IO::read_OBJ(file.string(), mesh, uv,
                                     CGAL::parameters::edge_is_constrained_map(is_feature));
  if(!read) {
    std::cerr << file.filename().string() << ": " << read << std::endl;
    return {};
  }
  const double extent = SS::measure_seamlessness(mesh, uv).extent;
  if(settings.noise > 0)
    add_noise(mesh, uv, settings.noise * extent, settings.seed);
  const auto before = SS::measure_seamlessness(mesh, uv);

  SS::Snapping_report report;
  const double start = benchmark::seconds_now();
  if(settings.features)
    report = SS::snap_to_seamless(mesh, uv, SS::parameters::edge_is_constrained_map(is_feature)
                                              .align_border(settings.align_border));
  else
    report = SS::snap_to_seamless(mesh, uv, SS::parameters::align_border(settings.align_border));
  const double total = benchmark::seconds_now() - start;
  if(!report) {
    std::cerr << file.filename().string() << ": " << report << std::endl;
    return {};
  }
  const auto after = SS::measure_seamlessness(mesh, uv);
  benchmark::Step_times times = benchmark::summed(report.step_times);
  const auto ms = [&](const char* step) { return 1e3 * benchmark::time_of(step, times); };
  const SS::Linear_solver_figures& system = report.linear_solver;
  const double cells = double(system.number_of_constraints) * double(system.number_of_unknowns);
  const auto density = [&](const std::size_t entries)
  { return cells > 0 ? 100 * double(entries) / cells : 0; };
  const double unrepaired = report.run.largest_change_before_repair;
  return {double(report.run.number_of_faces), double(report.run.number_of_nodes),
          double(report.run.number_of_cut_branches + report.run.number_of_align_branches),
          ms("transitions"), ms("elimination"), ms("solution"), 1e3 * total,
          density(system.number_of_coefficients), density(system.number_of_eliminated_coefficients),
          report.violation_before / extent, report.mean_change / extent,
          report.optimal_rms_change > 0 ? report.rms_change / report.optimal_rms_change : 1,
          report.largest_change / extent,
          unrepaired > 0 ? report.largest_change / unrepaired : 1,
          double(before.number_of_flipped_faces),
          double(report.run.number_of_lost_faces), double(report.lost_faces.size()),
          double(after.number_of_flipped_faces)};
}

// --- the table -----------------------------------------------------------------------------------

void print_row(std::ostream& os, const std::string& name, const std::vector<double>& values)
{
  os << "| " << name << " |";
  for(std::size_t i = 0; i < columns.size(); ++i) {
    std::ostringstream cell;
    if(columns[i].digits < 0)
      cell << std::scientific << std::setprecision(1) << values[i];
    else
      cell << std::fixed
           << std::setprecision(values[i] == std::size_t(values[i]) ? 0 : columns[i].digits)
           << values[i];
    os << ' ' << cell.str() << " |";
  }
  os << std::endl;
}

void write_csv_row(std::ostream& os, const std::string& name, const std::vector<double>& values)
{
  os << '"' << name << '"' << std::setprecision(17);
  for(const double value : values)
    os << ',' << value;
  os << '\n';
}

int run(const Settings& settings)
{
  const std::vector<std::string> files = benchmark::files_of(settings.names);
  std::ofstream csv;
  if(!settings.csv.empty())
    csv.open(settings.csv);

  std::cout << "| model |";
  csv << "model";
  for(const Column& column : columns) {
    std::cout << ' ' << column.name << " |";
    csv << ',' << column.name;
  }
  std::cout << "\n|---|";
  csv << '\n';
  for(std::size_t i = 0; i < columns.size(); ++i)
    std::cout << "---:|";
  std::cout << std::endl;

  std::vector<double> sums(columns.size(), 0.);
  std::size_t number = 0;
  for(const std::filesystem::path file : files) {
    const std::vector<double> values = measure(file, settings);
    if(values.empty())
      continue;
    ++number;
    for(std::size_t i = 0; i < values.size(); ++i)
      sums[i] += values[i];
    print_row(std::cout, file.stem().string(), values);
    write_csv_row(csv, file.stem().string(), values);
  }
  if(number == 0)
    return EXIT_FAILURE;
  for(double& sum : sums)
    sum /= double(number);
  print_row(std::cout, "average of " + std::to_string(number), sums);
  std::cout << "\nviolation and change relative to the extent; noise "
            << settings.noise << ", seed " << settings.seed << "; " << files.size() - number
            << " of " << files.size() << " files refused" << std::endl;
  return settings.csv.empty() || csv.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char** argv)
{
  Settings settings;
  options::options_description description("Options");
  description.add_options()
    ("file", options::value(&settings.names)->required(),
     "OBJ files, or folders (may go without --file)")
    ("noise", options::value(&settings.noise)->default_value(0), "relative to the extent")
    ("seed", options::value(&settings.seed)->default_value(1), "of the noise")
    ("features", options::bool_switch(&settings.features),
     "keep feature edges (OBJ l) on isocurves")
    ("align-border", options::bool_switch(&settings.align_border), "and the border too")
    ("csv", options::value(&settings.csv), "file to write the table to");
  if(const auto exit_code = benchmark::read_command_line(
       argc, argv, "dataset_statistics [options] FILE_OR_FOLDER...", description, "file"))
    return *exit_code;
  return run(settings);
}
