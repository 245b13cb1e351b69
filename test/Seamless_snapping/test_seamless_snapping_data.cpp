// Tests of the surface function on parametrizations that solvers made, where there are any, and on
// big synthetic ones: exactness, what the transitions are, flips, distances.

#include "surface_checks.h"

#include "Height_field_surface.h"
#include "orientation_checks.h"
#include "test_data.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/seam_transitions.h>

#include <CGAL/Timer.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

using namespace surface_checks;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Feature_map = Mesh::Property_map<Mesh::Edge_index, bool>;

using orientation_checks::not_positive;
using orientation_checks::signs;

// --- files ---------------------------------------------------------------------------------------

struct File
{
  Mesh mesh;
  UV_map uv = test_meshes::uv_map(mesh);
  Feature_map features = test_meshes::feature_map(mesh);

  explicit File(const std::filesystem::path& path)
  {
    const auto status = SS::IO::read_OBJ(path.string(), mesh, uv,
                                         SS::parameters::edge_is_constrained_map(features));
    CHECK_IN(path.filename().string() + ": " + status.message, bool(status));
  }
};

// What the README of the data says about a file.
struct Row
{
  std::size_t faces, cut, nearly_identity, inexact, flips;
  double violation;
};

std::map<std::string, Row> read_table(const std::filesystem::path& path)
{
  std::map<std::string, Row> result;
  std::map<std::string, std::size_t> columns;
  std::ifstream is(path);
  for(std::string line; std::getline(is, line);) {
    std::vector<std::string> cells;
    std::istringstream cell_stream(line);
    for(std::string cell; std::getline(cell_stream, cell, '|');) {
      const auto first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
      cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    if(cells.size() > 1 && cells[1] == "file")
      for(std::size_t i = 0; i < cells.size(); ++i)
        columns[cells[i]] = i;
    if(columns.empty() || cells.size() < columns.size()
       || cells[1].find(".obj") == std::string::npos)
      continue;
    const auto number = [&](const std::string& name) {
      return std::size_t(std::stoul(cells[columns.at(name)]));
    };
    result[cells[1]] = { number("faces"),   number("cut"),   number("nearly identity"),
                         number("inexact"), number("flips"),
                         std::stod(cells[columns.at("largest violation")]) };
  }
  return result;
}

// Without alignment.
void test_file(const std::filesystem::path& path, const Row& row)
{
  const std::string name = path.filename().string();
  File file(path);
  const auto before = exact_check::check_edges(file.mesh, file.uv);
  const auto signs_before = signs(file.mesh, file.uv);
  CHECK_IN(name, file.mesh.number_of_faces() == row.faces);
  CHECK_IN(name, before.inexact_edges == row.inexact);
  const auto flips = std::count(signs_before.begin(), signs_before.end(), -1);
  CHECK_IN(name, std::size_t(flips) == row.flips);

  CGAL::Timer timer;
  timer.start();
  const SS::Snapping_report report = SS::snap_to_seamless(file.mesh, file.uv);
  timer.stop();
  CHECK_IN(name + ": " + report.message, bool(report));
  CHECK_IN(name, exact_check::check_edges(file.mesh, file.uv).is_exact());
  CHECK_IN(name, SS::is_seamless(file.mesh, file.uv));
  CHECK_IN(name, (report.status == SS::Outcome::ALREADY_EXACT)
                   == (row.inexact == 0 && row.nearly_identity == 0));
  CHECK_EQUAL(report.run.number_of_cut_edges, row.cut);
  CHECK_EQUAL(report.run.number_of_merged_edges, row.nearly_identity);
  CHECK_IN(name, std::abs(report.violation_before - before.largest_violation)
                   <= 1e-12 * before.largest_violation);
  const double violation = report.violation_before / report.extent;
  CHECK_IN(name, std::abs(violation - row.violation) <= 0.05 * row.violation);

  const std::size_t losses =
    not_positive(signs_before, signs(file.mesh, file.uv), true).size();
  CHECK_IN(name, losses == 0);
  const Bits after = all_bits(file.mesh, file.uv);
  CHECK_IN(name, SS::snap_to_seamless(file.mesh, file.uv).status
                   == SS::Outcome::ALREADY_EXACT);
  CHECK_IN(name, all_bits(file.mesh, file.uv) == after);

  std::cout << std::left << std::setw(40) << name << std::right << std::setw(10) << violation
            << std::setw(10) << report.largest_change / report.extent << std::setw(8)
            << report.run.number_of_cut_edges << std::setw(6) << report.run.number_of_merged_edges
            << std::setw(6) << losses << std::setw(8) << 1000 * timer.time() << std::endl;
}

// Features and border, where all of them lie on isocurves.
void test_alignment(const std::filesystem::path& path)
{
  const std::string name = path.filename().string() + ", aligned";
  File file(path);
  const bool has_border = std::any_of(file.mesh.edges().begin(), file.mesh.edges().end(),
                                      [&](auto e) { return file.mesh.is_border(e); });
  const bool has_features = std::any_of(file.mesh.edges().begin(), file.mesh.edges().end(),
                                        [&](auto e) { return file.features[e]; });
  if(!has_border && !has_features)
    return;
  // only those edges that do so up to noise: the files say of most, but not of all
  const double tolerance = 1e-6 * extent(file.mesh, file.uv);
  std::size_t aligned = 0;
  for(const auto e : file.mesh.edges()) {
    auto h = file.mesh.halfedge(e);
    h = file.mesh.is_border(h) ? file.mesh.opposite(h) : h;
    const auto d = file.uv[h] - file.uv[file.mesh.prev(h)];
    file.features[e] = (file.features[e] || file.mesh.is_border(e))
                       && (std::min)(std::abs(d.x()), std::abs(d.y())) <= tolerance;
    aligned += file.features[e] ? 1 : 0;
  }
  const auto signs_before = signs(file.mesh, file.uv);
  const auto np = SS::parameters::edge_is_constrained_map(file.features);
  const SS::Snapping_report report = SS::snap_to_seamless(file.mesh, file.uv, np);
  CHECK_IN(name + ": " + report.message, bool(report));
  const auto result = exact_check::check_edges(file.mesh, file.uv,
                                               is_aligned(file.mesh, file.features, false));
  CHECK_IN(name, result.is_exact());
  CHECK_IN(name, result.aligned_edges == aligned);
  CHECK_IN(name, not_positive(signs_before, signs(file.mesh, file.uv), true).empty());
  CHECK_IN(name, SS::is_seamless(file.mesh, file.uv, np));
  std::cout << std::left << std::setw(50) << name << std::right << std::setw(6) << aligned
            << " edges, violation " << report.violation_before / report.extent << ", change "
            << report.largest_change / report.extent << std::endl;
}

void test_refused_file(const std::filesystem::path& path)
{
  const std::string name = path.filename().string();
  Mesh mesh;
  const UV_map uv = test_meshes::uv_map(mesh);
  const auto status = SS::IO::read_OBJ(path.string(), mesh, uv);
  if(!status) { // no mesh at all
    CHECK_IN(name, !status.message.empty());
    std::cout << name << ": " << status.message << std::endl;
    return;
  }
  const Bits before = all_bits(mesh, uv);
  const SS::Snapping_report report = SS::snap_to_seamless(mesh, uv);
  CHECK_IN(name, !report);
  CHECK_IN(name, report.status == SS::Outcome::NOT_SEAMLESS);
  CHECK_IN(name, !report.message.empty());
  CHECK_IN(name, all_bits(mesh, uv) == before);
  std::cout << name << ": " << report << std::endl;
}

void test_files()
{
  const auto table_path = test_data::further_data("README.md", "maps with known figures");
  if(table_path.empty())
    return;
  const std::filesystem::path folder = table_path.parent_path();
  const std::map<std::string, Row> table = read_table(table_path);
  std::cout << std::left << std::setw(40) << "file" << "  violation   change     cut merged losses"
            << " ms" << std::endl;
  std::size_t files = 0;
  for(const auto& row : table) {
    CHECK_IN(row.first, std::filesystem::exists(folder / "uv" / row.first));
    if(!std::filesystem::exists(folder / "uv" / row.first))
      continue;
    test_file(folder / "uv" / row.first, row.second);
    test_alignment(folder / "uv" / row.first);
    ++files;
  }
  CHECK(files > 0);
  for(const auto& entry : std::filesystem::directory_iterator(folder / "uv"))
    CHECK_IN(entry.path().string(), entry.path().extension() != ".obj"
                                      || table.count(entry.path().filename().string()) != 0);
  std::size_t refused = 0;
  for(const auto& entry : std::filesystem::directory_iterator(folder / "refused")) {
    test_refused_file(entry.path());
    ++refused;
  }
  CHECK(refused > 0);
}

// --- big synthetic surfaces ----------------------------------------------------------------------

void test_height_field(unsigned int seed, double relative)
{
  const std::string context = "height field, seed " + std::to_string(seed);
  height_field_surface::Wish wish;
  wish.faces = 20000;
  wish.nodes = 200 + 100 * (seed % 8);
  wish.seed = seed;
  test_meshes::Named_mesh<Kernel> named{ context, false, Mesh() };
  Mesh& mesh = named.mesh;
  height_field_surface::make_surface(wish, mesh);
  const UV_map uv = test_meshes::uv_map(mesh);
  const Truth<Mesh, UV_map> truth(mesh, uv);
  check_sum_of_indices(mesh, truth, context);

  const double noise = relative * truth.extent;
  uv_noise::perturb(mesh, uv, noise, seed,
                    seed % 2 == 0 ? uv_noise::Noise::per_sector : uv_noise::Noise::per_corner);
  const auto before = signs(mesh, uv);
  check_transitions(mesh, truth, SS::seam_transitions(mesh, uv), context);
  const auto snapped = snap_and_check(named, context);
  const auto rotation = [&](auto h) { return truth.rotation(h); };
  CHECK_IN(context, exact_check::check_edges(mesh, uv, exact_check::No_edge_aligned(),
                                             rotation).is_exact());
  CHECK_IN(context, edges_that_gape(mesh, uv, truth) == 0);
  CHECK_IN(context, not_positive(before, signs(mesh, uv), true).empty());
  CHECK_IN(context, snapped.report.largest_change <= 8 * noise);
  CHECK_IN(context, snapped.report.linear_solver.number_of_non_unit_pivots == 0);
  std::cout << context << ": " << mesh.number_of_faces() << " faces, "
            << snapped.report.run.number_of_nodes << " nodes, change / noise "
            << snapped.report.largest_change / noise << std::endl;
}

int main()
{
  std::cout.precision(3);
  test_files();
  for(unsigned int seed = 1; seed <= 16; ++seed)
    test_height_field(seed, seed % 3 == 0 ? 1e-6 : 1e-10);
  return report_checks();
}
