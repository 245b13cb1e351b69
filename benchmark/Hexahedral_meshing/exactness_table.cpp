// What exactness changes for programs that extract hexahedra. Each map is made an exact integer
// grid; then each corner gets noise of its own, relative to the extent; then the noisy map is
// snapped again. A mesh is complete if it has as many hexahedra as the volume of the map. The table
// counts the maps whose mesh is complete: of extract_hexahedra(), and of programs given by their
// commands.

#include "benchmark_tools.h"
#include "command_line.h"

#include <CGAL/Hexahedral_meshing/extract_hexahedra.h>
#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/is_volume_seamless.h>
#include <CGAL/Seamless_snapping/snap_volume_to_seamless.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace options = benchmark::options;
namespace Meshing = CGAL::Hexahedral_meshing;
using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Uvw = std::vector<Point_3>;

struct Settings
{
  std::vector<std::string> files, commands;
  std::vector<double> noise;
  double number = 1000;
  int seconds = 60;
  unsigned int seed = 1;
};

// The extraction of a number of hexahedra from a map.
using Extraction = std::function<std::size_t(const Meshing::IO::HEXEX_mesh&, const Uvw&)>;

std::size_t extract(const Meshing::IO::HEXEX_mesh& mesh, Uvw uvw)
{
  std::vector<std::array<double, 3> > points;
  std::vector<std::array<std::int32_t, 8> > hexahedra;
  Meshing::extract_hexahedra(mesh.points, mesh.tetrahedra, CGAL::make_property_map(uvw), points,
                             hexahedra);
  return hexahedra.size();
}

// The number after the title of a section, as in the formats of OpenVolumeMesh and MEDIT.
std::size_t number_of_hexahedra(const fs::path& filename)
{
  std::ifstream is(filename);
  std::size_t number = 0;
  for(std::string word; is >> word; )
    if((word == "Polyhedra" || word == "Hexahedra") && is >> number)
      return number;
  return 0;
}

// Runs a command with IN and OUT replaced by files.
std::size_t extract_by(std::string command, const Settings& settings,
                       Meshing::IO::HEXEX_mesh mesh, const Uvw& uvw)
{
  const fs::path folder = fs::temp_directory_path(), in = folder / "exactness_in.hexex",
                 out = folder / "exactness_out.ovm";
  for(std::size_t i = 0; i < uvw.size(); ++i)
    mesh.uvw[i] = {{uvw[i].x(), uvw[i].y(), uvw[i].z()}};
  if(!Meshing::IO::write_HEXEX(in.string(), mesh))
    return 0;
  fs::remove(out);
  for(const auto& [name, path] : {std::pair("IN", in), std::pair("OUT", out)})
    if(const std::size_t i = command.find(name); i != command.npos)
      command.replace(i, std::string(name).size(), path.string());
  if(std::system(("timeout " + std::to_string(settings.seconds) + " " + command +
                  " > /dev/null 2>&1").c_str()) != 0)
    return 0;
  return number_of_hexahedra(out);
}

Uvw with_noise(Uvw uvw, const double noise, const double extent, std::mt19937& random)
{
  std::uniform_real_distribution<double> change(-noise * extent, noise * extent);
  for(Point_3& u : uvw)
    u = Point_3(u.x() + change(random), u.y() + change(random), u.z() + change(random));
  return uvw;
}

class Table
{
public:
  explicit Table(const Settings& settings) : m_settings(settings), m_random(settings.seed)
  {
    m_extractions.push_back(extract);
    for(const std::string& command : settings.commands)
      m_extractions.push_back([&](const auto& mesh, const Uvw& uvw)
                              { return extract_by(command, settings, mesh, uvw); });
    m_complete.assign(1 + 2 * settings.noise.size(),
                      std::vector<std::size_t>(m_extractions.size(), 0));
  }

  void add(const std::string& file)
  {
    Meshing::IO::HEXEX_mesh mesh;
    if(const auto status = Meshing::IO::read_HEXEX(file, mesh); !status) {
      std::cerr << file << ": " << status.message << std::endl;
      return;
    }
    Uvw uvw;
    for(const auto& u : mesh.uvw)
      uvw.emplace_back(u[0], u[1], u[2]);
    const auto grid = [&](Uvw& map) {
      return Meshing::measure_volume_integer_grid(mesh.tetrahedra, CGAL::make_property_map(map));
    };
    const double scale = std::cbrt(m_settings.number / grid(uvw).volume);
    if(!snap(mesh, uvw, scale, 1e9)) {
      std::cerr << file << ": no integer grid without flips" << std::endl;
      return;
    }
    ++m_number_of_maps;
    const auto number = std::size_t(std::llround(grid(uvw).volume));
    const double extent =
      Meshing::measure_volume_seamlessness(mesh.tetrahedra, CGAL::make_property_map(uvw)).extent;
    count(0, mesh, uvw, number);
    for(std::size_t i = 0; i < m_settings.noise.size(); ++i) {
      Uvw noisy = with_noise(uvw, m_settings.noise[i], extent, m_random);
      count(1 + 2 * i, mesh, noisy, number);
      if(snap(mesh, noisy, 1, 0.01))
        count(2 + 2 * i, mesh, noisy, number);
    }
  }

  void write() const
  {
    std::cout << "| map | extract_hexahedra() |";
    for(const std::string& command : m_settings.commands)
      std::cout << " " << command.substr(0, command.find(' ')) << " |";
    std::cout << "\n|---|--:|";
    for(std::size_t i = 0; i < m_settings.commands.size(); ++i)
      std::cout << "--:|";
    std::cout << "\n";
    write_row("exact", 0);
    for(std::size_t i = 0; i < m_settings.noise.size(); ++i) {
      std::cout << "| noise of " << m_settings.noise[i];
      write_row("", 1 + 2 * i);
      write_row("the same, snapped", 2 + 2 * i);
    }
    std::cout << m_number_of_maps << " maps of about " << m_settings.number
              << " hexahedra, seed " << m_settings.seed << std::endl;
  }

private:
  static bool snap(const Meshing::IO::HEXEX_mesh& mesh, Uvw& uvw, const double scale,
                   const double rounding)
  {
    const auto report = Meshing::snap_volume_to_seamless(
      mesh.tetrahedra, CGAL::make_property_map(uvw),
      Meshing::parameters::integer_grid(true).grid_scale(scale).rounding_tolerance(rounding)
        .repair_flips(Meshing::Flip_repair::UNTANGLE));
    return report && report.status != Meshing::Outcome::FLIPS_REMAIN;
  }

  void count(const std::size_t row, const Meshing::IO::HEXEX_mesh& mesh, const Uvw& uvw,
             const std::size_t number)
  {
    for(std::size_t k = 0; k < m_extractions.size(); ++k)
      m_complete[row][k] += m_extractions[k](mesh, uvw) == number ? 1 : 0;
  }

  void write_row(const char* const name, const std::size_t row) const
  {
    std::cout << (*name == 0 ? "" : "| ") << name << " |";
    for(const std::size_t n : m_complete[row])
      std::cout << " " << n << " |";
    std::cout << "\n";
  }

  const Settings& m_settings;
  std::mt19937 m_random;
  std::vector<Extraction> m_extractions;
  std::vector<std::vector<std::size_t> > m_complete; // per row and extraction: maps
  std::size_t m_number_of_maps = 0;
};

int main(int argc, char** argv)
{
  Settings settings;
  options::options_description description("options");
  description.add_options()
    ("command", options::value(&settings.commands)->composing(),
     "of a program, such as 'HexHex --in IN --out-hex OUT' or 'HexEx IN OUT'; IN is a HEXEX file, "
     "OUT a file of OpenVolumeMesh")
    ("number", options::value(&settings.number)->default_value(1000), "of hexahedra wanted")
    ("noise", options::value(&settings.noise)->multitoken()->default_value(
      {1e-12, 1e-5}, "1e-12 1e-5"), "relative to the extent")
    ("seconds", options::value(&settings.seconds)->default_value(60), "for each run of a command")
    ("seed", options::value(&settings.seed)->default_value(1), "of the noise")
    ("files", options::value(&settings.files)->required(), "HEXEX files, and folders of them");
  if(const auto exit = benchmark::read_command_line(
       argc, argv, "exactness_table [options] FILES...", description, "files"))
    return *exit;
  Table table(settings);
  for(const std::string& file : benchmark::files_of(settings.files, {".hexex"}))
    table.add(file);
  table.write();
  return EXIT_SUCCESS;
}
