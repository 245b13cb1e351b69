#include "Repairs.h"

#include "Failure.h"
#include "Polygon_soup.h"
#include "Progress.h"
#include "Surface_soup.h"
#include "Topology.h"
#include "closing.h"
#include "words.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Piece_map = Mesh::Property_map<Mesh::Face_index, std::size_t>;

// Turns the pieces back of which most faces were turned: the file tells which side is outside.
void turn_back(Mesh& mesh, const Piece_map piece, const std::vector<char>& is_turned,
               Repairs& repairs)
{
  std::vector<std::ptrdiff_t> turned(repairs.pieces, 0), faces(repairs.pieces, 0);
  for(const auto f : mesh.faces()) {
    turned[piece[f]] += is_turned[f] ? 1 : 0;
    ++faces[piece[f]];
  }
  std::vector<Mesh::Face_index> back;
  for(const auto f : mesh.faces())
    if(2 * turned[piece[f]] > faces[piece[f]])
      back.push_back(f);
  PMP::reverse_face_orientations(back, mesh);
  for(std::size_t p = 0; p < repairs.pieces; ++p)
    repairs.turned_faces += std::size_t((std::min)(turned[p], faces[p] - turned[p]));
}

// All edges between the places of segments, of which there are several where edges were cut.
void mark_segments(const Polygon_soup& soup, const Surface_soup& surface, Model& model)
{
  const auto key = [&](const std::size_t v, const std::size_t w) { // of points in the file
    const std::size_t p = surface.places[v], q = surface.places[w];
    return std::array<std::size_t, 2>{{(std::min)(p, q), (std::max)(p, q)}};
  };
  std::vector<std::pair<std::array<std::size_t, 2>, Edge> > edges;
  for(const Edge e : model.mesh.edges())
    edges.emplace_back(key(model.file_vertices[model.mesh.vertex(e, 0)],
                           model.file_vertices[model.mesh.vertex(e, 1)]), e);
  std::sort(edges.begin(), edges.end());
  for(const auto& segment : soup.segments) {
    const auto sought = key(segment.vertices[0], segment.vertices[1]);
    auto it = std::lower_bound(edges.begin(), edges.end(), sought,
                               [](const auto& e, const auto& k) { return e.first < k; });
    if(it == edges.end() || it->first != sought)
      throw Failure(UNREADABLE,
                    (segment.line == 0 ? "" : "line " + std::to_string(segment.line) + ": ") +
                      "line element " + std::to_string(segment.vertices[0] + soup.first_number) +
                      " " + std::to_string(segment.vertices[1] + soup.first_number) +
                      " is not an edge of the mesh");
    for(; it != edges.end() && it->first == sought; ++it)
      model.is_feature[it->second] = true;
  }
}

std::size_t count_faces_without_area(const Mesh& mesh)
{
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [&](const Halfedge h) {
    const Kernel::Point_3& p = mesh.point(mesh.target(h));
    return Exact_kernel::Point_3(p.x(), p.y(), p.z());
  };
  return static_cast<std::size_t>(
    std::count_if(mesh.faces_begin(), mesh.faces_end(), [&](const auto f) {
      const Halfedge h = mesh.halfedge(f);
      return CGAL::collinear(point(h), point(mesh.next(h)), point(mesh.prev(h)));
    }));
}

// As of points that were rounded.
double small_distance(const Mesh& mesh) { return 1e-6 * diagonal(mesh); }

// Whether the border runs along itself there, beyond a gap that is far smaller than the edges on
// both sides: as a seam of which both sides were computed. Points of tiny edges, and those of a
// border that comes near to itself in one point, are something else.
// \param h,g of the border, to the points on both sides of the gap
bool is_open_seam(const Mesh& mesh, const Halfedge h, const Halfedge g, const double gap,
                  const double most)
{
  constexpr double least_ratio = 100;
  const auto distance = [&](const auto v, const auto w)
    { return CGAL::approximate_sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))); };
  for(const Halfedge e : {h, mesh.next(h), g, mesh.next(g)})
    if(distance(mesh.source(e), mesh.target(e)) < least_ratio * gap)
      return false;
  const auto meet_again = [&](const Halfedge before, const Halfedge after)
    { return distance(mesh.source(before), mesh.target(mesh.next(after))) <= most; };
  return meet_again(h, g) || meet_again(g, h);
}

// Counts points of the border that are near to those of another piece, or beyond a seam. Of the
// points that follow along a line, a hundred are looked at.
void find_near_points(const Mesh& mesh, const Piece_map piece, Repairs& repairs)
{
  struct Border_point
  {
    double place;
    Halfedge halfedge; // of the border, to the point
    double nearest;
  };
  constexpr double none = std::numeric_limits<double>::infinity();
  constexpr std::size_t most_looked_at = 100;
  const auto piece_of = [&](const Border_point& p)
    { return piece[mesh.face(mesh.opposite(p.halfedge))]; };
  const double most = small_distance(mesh);
  std::vector<Border_point> points;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h)) {
      const Kernel::Point_3& p = mesh.point(mesh.target(h));
      points.push_back({0.48 * p.x() + 0.6 * p.y() + 0.64 * p.z(), h, none});
    }
  std::sort(points.begin(), points.end(),
            [](const Border_point& a, const Border_point& b) { return a.place < b.place; });
  for(std::size_t i = 0; i < points.size(); ++i)
    for(std::size_t j = i + 1; j < (std::min)(points.size(), i + most_looked_at) &&
                               points[j].place - points[i].place <= most; ++j) {
      const Halfedge h = points[i].halfedge, g = points[j].halfedge;
      const Kernel::Vector_3 v = mesh.point(mesh.target(g)) - mesh.point(mesh.target(h));
      const double distance = std::hypot(v.x(), v.y(), v.z());
      if(distance > 0 && distance <= most &&
         (piece_of(points[i]) != piece_of(points[j]) ||
          is_open_seam(mesh, h, g, distance, most)))
        for(const std::size_t k : {i, j})
          points[k].nearest = (std::min)(points[k].nearest, distance);
    }
  for(const Border_point& p : points)
    if(p.nearest < none) {
      ++repairs.near_points;
      repairs.distance_of_near_points = (std::max)(repairs.distance_of_near_points, p.nearest);
    }
}

// Counts points of the border that are inside of an edge of the border, up to that distance.
std::size_t count_T_junctions(const Mesh& mesh)
{
  using Segments = std::vector<Kernel::Segment_3>;
  using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive> >;
  Segments border;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
      border.emplace_back(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  const Tree tree(border.begin(), border.end());
  const double most = small_distance(mesh), square = most * most;
  return static_cast<std::size_t>(
    std::count_if(border.begin(), border.end(), [&](const Kernel::Segment_3& edge) {
      const Kernel::Point_3& p = edge.target();
      const Kernel::Vector_3 v(most, most, most);
      std::vector<Tree::Primitive_id> near_by;
      tree.all_intersected_primitives(Kernel::Iso_cuboid_3(p - v, p + v),
                                      std::back_inserter(near_by));
      return std::any_of(near_by.begin(), near_by.end(), [&](const auto s) {
        return CGAL::squared_distance(p, *s) <= square &&
               CGAL::squared_distance(p, s->source()) > square &&
               CGAL::squared_distance(p, s->target()) > square;
      });
    }));
}

Repairs build(const Polygon_soup& soup, const Plain_reading_options& options, Model& model)
{
  Repairs repairs;
  repairs.file_points = soup.points.size();
  repairs.file_faces = soup.polygons.size();
  const Surface_soup surface = make_surface(soup, repairs);
  PMP::polygon_soup_to_polygon_mesh(surface.points, surface.polygons, model.mesh);
  model.mesh.shrink_to_fit(); // CGAL reserves more
  model.file_vertices = surface.file_points;
  model.file_faces = surface.file_faces;
  model.first_number = soup.first_number;
  auto piece = model.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece").first;
  repairs.pieces = PMP::connected_components(model.mesh, piece);
  turn_back(model.mesh, piece, surface.is_turned, repairs);
  find_near_points(model.mesh, piece, repairs);
  repairs.T_junctions = count_T_junctions(model.mesh);
  model.mesh.remove_property_map(piece);
  triangulate(soup, model, repairs);
  if(options.fill_holes > 0)
    fill_holes(std::size_t(options.fill_holes), model, repairs);
  repairs.border_loops = border_loops(model.mesh).size();
  repairs.vertices = model.mesh.number_of_vertices();
  repairs.faces = model.mesh.number_of_faces();
  repairs.faces_without_area = count_faces_without_area(model.mesh);
  if(options.features)
    mark_segments(soup, surface, model);
  else
    repairs.unused_segments = soup.segments.size();
  return repairs;
}

} // namespace

void Plain_reading_options::add_to(Options& options)
{
  options.add("features", features, "treat the edges of 'l' elements of a .obj file as features");
  options.add("merge", "DISTANCE", merge, {0, std::numeric_limits<double>::infinity(), true},
              "merge points up to this distance, for surfaces whose parts don't quite meet");
  options.add("fill-holes", "N", fill_holes, whole_numbers(3, 1 << 20),
              "close holes that have at most N edges by triangles; this also closes small open pieces");
  options.add("strict", strict, "refuse a mesh that needs repair or triangulation, such as a mesh of quads");
}

std::string Repairs::in_words() const
{
  std::string result;
  const auto add = [&](const std::size_t n, const std::string& what, const std::string& done) {
    if(n > 0)
      result += (result.empty() ? "" : ", ") + counted(n, what) + (n == 1 ? " was " : " were ") +
                done;
  };
  add(merged_points, "point", "moved to others by --merge");
  if(is_indexed)
    add(welded_points, "point", "welded to others in the same place");
  add(degenerate_faces, "face", "removed that had less than three different corners");
  add(duplicate_faces, "face", "removed that had the corners of others");
  add(cut_edges, "edge", "cut that three faces or more had shared");
  add(one_sided_edges, "edge", "cut as the surface had one side only");
  add(bowtie_vertices, "vertex", "added where faces had met in a point only");
  add(faces_of_flat_pieces, "face", "removed with pieces that have no area, the first is face " +
                                      std::to_string(first_face_of_flat_pieces));
  add(turned_faces, "face", "turned round to fit the others");
  add(triangulated_faces, "face", "triangulated");
  add(split_diagonals, "point", "added in faces no diagonal of which is free");
  add(filled_holes, "hole", "filled by --fill-holes");
  return result;
}

Repairs read_plain_model(const std::string& filename, const Plain_reading_options& options,
                         Model& model)
{
  model.filename = filename;
  const Progress progress("reading " + filename, options.verbose);
  Polygon_soup soup = read_polygon_soup(filename);
  const std::size_t merged_points = options.merge > 0 ? merge_points(options.merge, soup) : 0;
  Repairs repairs;
  try {
    repairs = build(soup, options, model);
    repairs.merged_points = merged_points;
  } catch(const Failure& failure) {
    throw Failure(failure.status, filename + ": " + failure.what());
  }
  if(options.strict && !repairs.in_words().empty())
    throw Failure(UNREADABLE, filename + ": refused by --strict, as reading repairs it: " +
                                repairs.in_words());
  return repairs;
}

void write_repairs(std::ostream& os, const std::string& filename, const Repairs& repairs)
{
  os << filename << ": " << counted(repairs.file_faces, "face") << ", "
     << counted(repairs.file_points, "point");
  const std::string words = repairs.in_words();
  if(!words.empty())
    os << "\nrepaired: " << words;
  if(!repairs.is_indexed && repairs.welded_points > 0)
    os << "\nwelded: " << counted(repairs.welded_points, "point")
       << ", because the file has one for each corner";
  os << "\nread: " << counted(repairs.faces, "triangle") << ", "
     << counted(repairs.vertices, "vertex") << ", " << counted(repairs.pieces, "piece")
     << (repairs.border_loops > 0 ? ", " + counted(repairs.border_loops, "border loop") : "") << "\n";
  if(repairs.unused_points > 0)
    os << "note: left out, because no face has them: "
       << counted(repairs.unused_points, "point") << "\n";
  if(repairs.faces_without_area > 0)
    os << "note: among them without area: " << counted(repairs.faces_without_area, "triangle")
       << "\n";
  if(repairs.near_points > 0)
    os << "note: near others across a gap, at up to " << repairs.distance_of_near_points
       << ", but not in the same place: " << counted(repairs.near_points, "border point")
       << ". The border stays open there; --merge " << 2 * repairs.distance_of_near_points
       << " merges them, if the surface is to go on\n";
  if(repairs.T_junctions > 0)
    os << "note: inside of border edges, as of parts that are divided differently: "
       << counted(repairs.T_junctions, "border point")
       << ". The border stays open there; split these edges, if the surface is to go on\n";
  if(repairs.unused_segments > 0)
    os << "note: not taken for features: " << counted(repairs.unused_segments, "edge")
       << " of 'l' elements; --features takes them\n";
}

nlohmann::json json_of(const Repairs& r)
{
  return {{"file", {{"faces", r.file_faces}, {"points", r.file_points}}},
          {"repairs", {{"merged_points", r.merged_points},
                       {"welded_points", r.welded_points},
                       {"removed_degenerate_faces", r.degenerate_faces},
                       {"removed_duplicate_faces", r.duplicate_faces},
                       {"unused_points", r.unused_points},
                       {"cut_edges", r.cut_edges},
                       {"cut_one_sided_edges", r.one_sided_edges},
                       {"added_bowtie_vertices", r.bowtie_vertices},
                       {"removed_faces_of_flat_pieces", r.faces_of_flat_pieces},
                       {"turned_faces", r.turned_faces},
                       {"triangulated_faces", r.triangulated_faces},
                       {"split_diagonals", r.split_diagonals},
                       {"filled_holes", r.filled_holes},
                       {"faces_of_filled_holes", r.faces_of_filled_holes}}},
          {"repaired", r.in_words()},
          {"mesh", {{"faces", r.faces}, {"vertices", r.vertices}, {"pieces", r.pieces},
                    {"border_loops", r.border_loops},
                    {"faces_without_area", r.faces_without_area},
                    {"T_junctions", r.T_junctions},
                    {"near_border_points", r.near_points},
                    {"distance_of_near_border_points", r.distance_of_near_points},
                    {"unused_segments", r.unused_segments}}}};
}
