#include "Model.h"

#include "Failure.h"
#include "Progress.h"
#include "files.h"
#include "words.h"

#include <CGAL/Seamless_snapping/IO/OBJ.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>
#include <CGAL/Seamless_snapping/internal/mesh/coinciding_border_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SS = CGAL::Seamless_snapping;

namespace {

// Options in place of the library's named parameters and functions.
std::string with_options(const std::string& message)
{
  static const char* const words[][2] = {
    {"by snap_to_seamless() with repair_flips(true)", "by --repair-flips"},
    {"by grid_scale, or call extract_quad_soup()",
     "by grid_scale, try --soup, or have the mesh remeshed by 'seamless remesh', which always makes "
     "a mesh of quads"},
    {"; raise maximum_number, or shrink the map by grid_scale",
     "; shrink the map by --grid-scale, or ask for fewer by --number"},
    {"; raise maximum_number, or let curves end where they meet others",
     "; let curves end where they meet others: leave out --base-complex"},
    {"by grid_scale", "by --grid-scale or --number"},
    {"more than maximum_number", "more than --maximum-number"},
    {"symmetry_plane", "--symmetry"},
    {"the rounding_tolerance of", "--rounding"},
    {"number_of_untangling_iterations", "--untangling-iterations"}};
  return with_words(message, words);
}

// Names of formats are suffixes.
const char* const obj = "obj";
const char* const ply = "ply";

// Standard streams and pipes have no suffix: what comes from them tells its format.
std::string format_of(const std::string& filename, const std::string& standard_format)
{
  const std::string suffix = is_special_file(filename) ? standard_format : suffix_of(filename);
  if(suffix != obj && suffix != ply)
    throw Failure(USAGE, "'" + filename + "': files with coordinates per corner are .obj and .ply "
                         "files");
  return suffix;
}

template <typename Parser>
SS::internal::Vertex_changes build(Model& model)
{
  const auto np = SS::parameters::edge_is_constrained_map(model.is_feature).weld(model.is_welded);
  auto soup = Parser(model.text).parse();
  const std::size_t n = model.number_of_points = soup.points.size();
  const auto changes =
    SS::internal::build_mesh(soup, model.mesh, model.uv_map, SS::internal::strip(np));
  if constexpr(std::is_same_v<decltype(soup), decltype(model.soup)>) {
    const auto first_copy = changes.file_vertices.end() - std::ptrdiff_t(soup.points.size() - n);
    for(auto& triangle : soup.triangles)
      for(std::size_t& v : triangle.vertices)
        if(v >= n)
          v = first_copy[std::ptrdiff_t(v - n)];
    model.soup = std::move(soup);
  }
  return changes;
}

template <typename UVNumber>
SS::internal::Vertex_changes build_from_format(Model& model)
{
  return model.format == ply ? build<SS::internal::PLY_parser<double, UVNumber> >(model)
                             : build<SS::internal::OBJ_parser<double, UVNumber> >(model);
}

void parse(Model& model)
{
  SS::internal::Vertex_changes changes;
  try {
    changes = model.is_float ? build_from_format<float>(model)
                             : build_from_format<double>(model);
  } catch(const SS::internal::File_refusal& refusal) {
    const std::string message = refusal.message();
    const bool lacks_coordinates = message.find("has no texture coordinate") != message.npos ||
                                   message.find("has no list texcoord") != message.npos;
    throw Failure(UNREADABLE, model.filename + ": " + message +
                                (lacks_coordinates ? "; 'seamless parametrize' computes some" : ""));
  }
  model.file_vertices = changes.file_vertices;
  model.number_of_split_vertices = changes.number_of_split_vertices;
  model.number_of_welded_edges = changes.number_of_welded_edges;
  model.number_of_coinciding_border_edges = changes.number_of_coinciding_border_edges;
}

void parse(const Reading_options& options, Model& model)
{
  model.first_number = model.format == obj ? 1 : 0;
  model.is_welded = options.weld;
  model.is_float = options.in_float;
  parse(model);
}

bool is_same_number(double x, double y) { return x == y && std::signbit(x) == std::signbit(y); }

// Whether vertices of faces, their points, and coordinates are the same, to the bit, in the same
// order, and so are features.
template <typename Soup>
bool is_same(const Model& model, const std::vector<std::size_t>& index_of_vertex, const Soup& soup)
{
  const Mesh& mesh = model.mesh;
  if(mesh.number_of_faces() != soup.triangles.size())
    return false;
  auto triangle = soup.triangles.begin();
  for(const Mesh::Face_index f : mesh.faces()) {
    Halfedge h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i) {
      const auto& p = soup.points[triangle->vertices[i]];
      const auto& uv = soup.uvs[triangle->uvs[i]];
      if(triangle->vertices[i] != index_of_vertex[mesh.target(h)] ||
         mesh.point(mesh.target(h)) != Kernel::Point_3(p[0], p[1], p[2]) ||
         !is_same_number(uv[0], model.uv_map[h].x()) || !is_same_number(uv[1], model.uv_map[h].y()))
        return false;
      h = mesh.next(h);
    }
    ++triangle;
  }
  std::set<std::pair<std::size_t, std::size_t> > features, segments;
  for(const Edge e : mesh.edges())
    if(model.is_feature[e])
      features.insert(std::minmax({index_of_vertex[mesh.vertex(e, 0)],
                                   index_of_vertex[mesh.vertex(e, 1)]}));
  for(const auto& segment : soup.segments)
    segments.insert(std::minmax({segment.vertices[0], segment.vertices[1]}));
  return features == segments;
}

template <template <typename, typename> class Parser, template <typename> class Rewriter>
std::string rewritten(const Model& model)
{
  using namespace SS::internal;
  if(model.is_float)
    return rewritten_text<Parser, Rewriter>(model.text, model.mesh, model.uv_map,
                                            strip(SS::parameters::weld(model.is_welded)));
  const auto uvs = uvs_of_mesh(model.soup, model.mesh, model.uv_map, model.mesh.points());
  return Rewriter<decltype(model.soup)>(model.text, model.soup, uvs).rewrite();
}

std::string rewritten(const Model& model)
{
  return model.format == ply ? rewritten<SS::internal::PLY_parser, SS::internal::PLY_rewriter>(model)
                             : rewritten<SS::internal::OBJ_parser, SS::internal::OBJ_rewriter>(model);
}

std::string written(const Model& model, const std::string& format)
{
  using namespace SS::internal;
  const auto np = SS::parameters::edge_is_constrained_map(model.is_feature);
  return format == ply ? build_PLY_text(model.mesh, model.uv_map, "", strip(np))
                       : build_OBJ_text(model.mesh, model.uv_map, "", strip(np));
}

template <typename UVNumber>
void check_text(const Model& model, const std::string& filename, const std::string& format,
                const std::string& text)
{
  std::vector<std::size_t> index_of_vertex(model.file_vertices);
  if(model.format != format) {
    index_of_vertex.resize(model.mesh.num_vertices());
    std::iota(index_of_vertex.begin(), index_of_vertex.end(), std::size_t(0));
  }
  if(!is_same(model, index_of_vertex,
              format == ply ? SS::internal::PLY_parser<double, UVNumber>(text).parse()
                            : SS::internal::OBJ_parser<double, UVNumber>(text).parse()))
    throw Failure(UNWRITABLE, filename + ": does not read back as it was written; not written");
}

} // namespace

void read_model(const std::string& filename, const Reading_options& options, Model& model)
{
  check_format(filename);
  const Progress progress("reading " + filename, options.verbose);
  model.filename = filename;
  model.text = read_file(filename);
  model.format = format_of(filename, model.text.substr(0, 3) == ply ? ply : obj);
  parse(options, model);
}

void read_again(const Model& other, const Reading_options& options, Model& model)
{
  model.filename = other.filename;
  model.text = other.text;
  model.format = other.format;
  parse(options, model);
}

std::string notes_on_reading(const Model& model)
{
  std::string result;
  if(model.number_of_welded_edges > 0)
    result += "note: " + counted(model.number_of_welded_edges, "edge") +
              (model.number_of_welded_edges == 1 ? " was" : " were") + " welded\n";
  if(model.number_of_coinciding_border_edges > 0)
    result += "note: " + SS::internal::note_on_coinciding_border_edges(
                           model.number_of_coinciding_border_edges) +
              (model.number_of_welded_edges > 0
                 ? " They can't be welded, as it is open which belong together.\n"
                 : " --weld closes it.\n");
  if(model.number_of_split_vertices > 0)
    result += "note: " + counted(model.number_of_split_vertices, "vertex") +
              (model.number_of_split_vertices == 1 ? " was" : " were") +
              " added where the faces around a vertex form several fans\n";
  return result;
}

std::string text_of_model(const Model& model, const std::string& filename)
{
  const std::string format = format_of(filename, model.format.empty() ? obj : model.format);
  const Progress progress("writing " + filename);
  std::string text;
  try {
    text = model.format == format ? rewritten(model) : written(model, format);
    check_text<double>(model, filename, format, text);
    if(model.is_float)
      check_text<float>(model, filename, format, text);
  } catch(const SS::internal::File_refusal& refusal) {
    throw Failure(UNWRITABLE, filename + ": " + refusal.message());
  }
  return text;
}

bool changes_format(const Model& model, const std::string& filename)
{
  return format_of(filename, model.format) != model.format;
}

void check_format(const std::string& filename)
{
  format_of(filename, obj);
}

Uv_map copy_of_uv_map(Model& model)
{
  const Uv_map copy = model.mesh.add_property_map<Halfedge, Kernel::Point_2>("h:old_uv").first;
  for(const Halfedge h : model.mesh.halfedges())
    copy[h] = model.uv_map[h];
  return copy;
}

std::string in_words_of_user(const std::string& message, const Model& model)
{
  const auto number_in_file = [&](const std::string& kind, const std::size_t i) {
    const auto& numbers = kind == "face" ? model.file_faces : model.file_vertices;
    return (i < numbers.size() ? numbers[i] : i) + model.first_number;
  };
  std::string result, kind; // the kind of element that the last word was about
  std::istringstream words(with_options(message));
  for(std::string word; words >> word; ) {
    const std::size_t digits = (std::min)(word.find_first_not_of("0123456789"), word.size());
    const std::string rest = word.substr(digits);
    if(!kind.empty() && digits > 0 && rest.find_first_not_of(",;:.)") == rest.npos)
      word = std::to_string(number_in_file(kind, std::stoul(word))) + rest;
    else if(word == "vertex" || word == "vertices" || word == "face")
      kind = word;
    else if(!(kind == "vertices" && word == "and")) // as in "vertices 1 and 2"
      kind.clear();
    result += (result.empty() ? "" : " ") + word;
  }
  return result;
}
