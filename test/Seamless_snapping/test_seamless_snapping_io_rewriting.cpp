// Files that are copied with other coordinates: all else stays to the byte, and the coordinates are
// those of the mesh, to readers of doubles and of floats.

#include "floating_point_traps.h"
#include "obj_models.h"

#include <CGAL/Seamless_snapping/IO/Mesh_text.h>
#include <CGAL/Seamless_snapping/IO/read_polygon_soup.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

using Random = std::mt19937_64;

// The same by an object that parses the text once, and knows the numbers of vertices.
void check_mesh_text(const std::string& text, const Surface_model& model, const bool weld,
                     const std::string& expected)
{
  SS::IO::Mesh_text file(text, "obj");
  Surface_model own;
  if(!file.read(own.mesh, own.uv_map,
                SS::parameters::edge_is_constrained_map(own.feature_map).weld_borders(weld)))
    return; // polylines that are no edges, which the model has not read
  const auto np = SS::parameters::edge_is_constrained_map(own.feature_map).vertex_index_map(
    boost::make_function_property_map<Surface_model::Mesh::Vertex_index>(
      [&](const auto v) { return file.vertex_numbers()[std::size_t(v)]; }));
  CHECK_EQUAL(file.holds(own.mesh, own.uv_map, np), !weld || text == expected);
  auto f = faces(model.mesh).begin();
  for(const auto own_f : faces(own.mesh)) {
    auto h = halfedge(*f++, model.mesh);
    for(const auto own_h : halfedges_around_face(halfedge(own_f, own.mesh), own.mesh)) {
      put(own.uv_map, own_h, get(model.uv_map, h));
      h = next(h, model.mesh);
    }
  }
  std::string result;
  CHECK_EQUAL(file.rewrite(result, own.mesh, own.uv_map).message, "");
  CHECK_EQUAL(result, expected);

  // by a map of points that stands elsewhere
  std::vector<Kernel::Point_3> points;
  for(const auto v : vertices(own.mesh)) {
    points.push_back(own.mesh.point(v));
    own.mesh.point(v) = CGAL::ORIGIN;
  }
  CHECK(!file.rewrite(result, own.mesh, own.uv_map));
  const auto point_map = CGAL::make_property_map(points);
  const auto point_of = boost::make_function_property_map<Surface_model::Mesh::Vertex_index>(
    [&](const auto v) { return get(point_map, std::size_t(v)); });
  CHECK(file.rewrite(result, own.mesh, own.uv_map, SS::parameters::vertex_point_map(point_of)));
  CHECK_EQUAL(result, expected);
  for(const auto v : vertices(own.mesh))
    own.mesh.point(v) = points[std::size_t(v)];

  const SS::IO::Mesh_text other(result, "obj");
  CHECK(other.holds(own.mesh, own.uv_map, np));
  const auto h = halfedge(*faces(own.mesh).begin(), own.mesh);
  const Kernel::Point_2 uv = get(own.uv_map, h);
  put(own.uv_map, h, Kernel::Point_2(uv.x(), std::nextafter(uv.y(), uv.y() + 1)));
  CHECK(!other.holds(own.mesh, own.uv_map, np));
}

template <typename AnyModel>
std::string rewritten(const std::string& text, const AnyModel& model, bool weld = false)
{
  std::istringstream is(text);
  std::ostringstream os;
  const SS::IO::File_status status =
    SS::IO::rewrite_OBJ(is, os, model.mesh, model.uv_map, SS::parameters::weld_borders(weld));
  CHECK_EQUAL(status.message, "");
  if constexpr(std::is_same_v<AnyModel, Surface_model>)
    check_mesh_text(text, model, weld, os.str());
  return os.str();
}

template <typename AnyModel, typename FT>
void set_uv(AnyModel& model, std::size_t face, std::size_t corner, FT u, FT v)
{
  auto h = halfedge(*std::next(faces(model.mesh).begin(), static_cast<std::ptrdiff_t>(face)),
                    model.mesh);
  for(; corner > 0; --corner)
    h = next(h, model.mesh);
  using Point_2 = typename boost::property_traits<typename AnyModel::Halfedge_uv_map>::value_type;
  put(model.uv_map, h, Point_2(u, v));
}

// All that an OBJ file can hold, in no good order, with all sorts of line ends and indices.
const std::string everything =
  "\xEF\xBB\xBF# made by hand\r\nmtllib a b.mtl\r\no  square \r\n"
  "v 0 0 0 0.5 0.5 0.5\nv 1.0 0 0 # a comment\nvn 0 0 1\nvt 00.00 0.0e0\t\nvt 1 0 0.25 # another\n"
  "g\nusemtl red\ns off\n\nf 1/1/1 2/2 3/0003/-1\n"
  "v 1 1 0\rv 0 1 0\rvt 1.00 +1\rvt 0 \\\n 1\nvp 0 0\ns 1\n"
  "usemtl blue\nf -4/-4 -2/-2/1 \\\n  -1/-1\n"
  "l 1/1 2/2 # a feature\nl 3 4\nvt 9 9\nend # without a new line";

void test_nothing_changes()
{
  Surface_model model;
  CHECK(model.read(everything));
  CHECK_EQUAL(rewritten(everything, model), everything);
}

void test_changes_in_place()
{
  Surface_model model;
  CHECK(model.read(everything));
  // the corner of the second vt, and both of the first
  set_uv(model, 0, 1, 0.1, 0.);
  set_uv(model, 0, 0, 0., -0.);
  set_uv(model, 1, 0, 0., -0.);
  std::string expected = everything;
  expected.replace(expected.find("vt 1 0 0.25"), 6, "vt 0.1 0");
  expected.replace(expected.find("0.0e0"), 5, "-0");
  CHECK_EQUAL(rewritten(everything, model), expected);
}

void test_new_statements()
{
  Surface_model model;
  CHECK(model.read(everything));
  set_uv(model, 1, 0, 5., 6.);  // of the first vt, which stays for the first face
  set_uv(model, 1, 1, 7., 8.);  // of the third
  std::string expected = everything;
  const auto replace = [&expected](const std::string& from, const std::string& to) {
    const std::size_t i = expected.find(from);
    if(CHECK(i != expected.npos))
      expected.replace(i, from.size(), to);
  };
  replace("vt 00.00 0.0e0\t\n", "vt 00.00 0.0e0\t\nvt 5 6\n");
  replace("vt 1.00 +1\r", "vt 1.00 +1\rvt 7 8\r");
  replace("f 1/1/1 2/2 3/0003/-1", "f 1/1/1 2/3 3/4/-1");
  replace("f -4/-4 -2/-2/1", "f -4/-5 -2/-2/1");
  replace("l 1/1 2/2", "l 1/1 2/3");
  CHECK_EQUAL(rewritten(everything, model), expected);

  // at the end of a text without a new line
  const std::string end = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/2\nvt 2 2\nvt 1 1 4";
  Surface_model other;
  CHECK(other.read(end));
  set_uv(other, 0, 1, 3., 3.);
  CHECK_EQUAL(rewritten(end, other),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\nvt 2 2\nvt 3 3\nvt 1 1 4");
  set_uv(other, 0, 1, 2., 2.);
  set_uv(other, 0, 0, 1., 1.);
  std::string last = end;
  last.replace(last.find("2/1"), 3, "2/2");
  Surface_model third;
  CHECK(third.read(last));
  set_uv(third, 0, 2, -1., 0.5);
  CHECK_EQUAL(rewritten(last, third),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\nvt 2 2\nvt 1 1 4\nvt -1 0.5 4");
}

void test_welded()
{
  const std::string cut = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 0\nv 1 0 0\nvt 0 0\nvt 1 1\n"
                          "f 1/1 2/1 3/1 # one\nf 6/2 5/2 4/2\nf -3/2 -5/2 -1/2\nv 0 -1 0\n";
  const std::string expected = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 0\nv 1 0 0\nvt 0 0\n"
                               "vt 1 1\nf 1/1 2/1 3/1 # one\nf 2/2 1/2 4/2\n";
  const std::string two = cut.substr(0, cut.find("f -3"));
  Surface_model model, cut_model;
  std::istringstream is(two);
  CHECK(SS::IO::read_OBJ(is, model.mesh, model.uv_map, SS::parameters::weld_borders(true)));
  CHECK_EQUAL(num_vertices(model.mesh), 4u);
  CHECK_EQUAL(rewritten(two, model, true), expected);
  CHECK_EQUAL(rewritten(two, model), two); // without welding
  CHECK(cut_model.read(two));
  CHECK_EQUAL(rewritten(two, cut_model), two);

  const std::string polylines = "l 6 5 -2/1\nl -5 -4\n";
  CHECK_EQUAL(rewritten(two + polylines, model, true), expected + "l 2 1 -6/1\nl -5 -4\n");
  const std::string relative = two.substr(0, two.find("f 6")) + "f -1/-1 -2/-1 -3/-1\n";
  CHECK_EQUAL(rewritten(relative, model, true),
              two.substr(0, two.find("f 6")) + "f -5/-1 -6/-1 -3/-1\n");
}

void test_other_meshes()
{
  const auto message = [](const std::string& text, const Surface_model& model) {
    std::istringstream is(text);
    std::ostringstream os;
    const std::string result = SS::IO::rewrite_OBJ(is, os, model.mesh, model.uv_map).message;
    CHECK(os.str().empty());
    return result;
  };
  const std::string refusal = "the mesh has other faces than the file";
  Surface_model model, moved, other;
  CHECK(model.read(everything));
  CHECK(moved.read(everything));
  CHECK(other.read(band(2, false)));
  moved.mesh.point(*vertices(moved.mesh).begin()) = Kernel::Point_3(0, 0, 1);
  CHECK_EQUAL(message(everything, other), refusal);
  CHECK_EQUAL(message(everything, moved), refusal);
  CHECK_EQUAL(message(band(1, false), model), "line 4: face uses vertex 1 twice");
  set_uv(model, 0, 0, 0., std::numeric_limits<double>::infinity());
  CHECK_EQUAL(message(everything, model), "a coordinate is not finite; nothing is written");

  const std::string missing = "no/such/file.obj";
  CHECK_EQUAL(SS::IO::rewrite_OBJ(missing, missing, model.mesh, model.uv_map).message,
              "cannot open 'no/such/file.obj': No such file or directory");
}

// The statements of a text but for `vt`, with the vertices of `f` only.
std::vector<std::string> all_else(const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line); ) {
    if(line.substr(0, 3) == "vt ")
      continue;
    std::string rest;
    std::istringstream tokens(line);
    for(std::string token; tokens >> token; )
      rest += token.substr(0, line[0] == 'f' ? token.find('/') : token.npos) + " ";
    result.push_back(rest);
  }
  return result;
}

// Random coordinates for random sharing of statements: what is read back is what was to be written.
template <typename AnyModel, typename FT>
void test_random(Random& random)
{
  std::ostringstream os;
  const std::size_t n = 3 + random() % 20, number_of_uvs = 1 + random() % 40;
  std::istringstream lines(band(n, false));
  for(std::string line; std::getline(lines, line); ) {
    if(line == "vt 0 0") {
      for(std::size_t i = 0; i < number_of_uvs; ++i)
        os << "vt " << i << " 0.1\n";
    } else if(line[0] == 'f') {
      std::istringstream tokens(line.substr(2));
      os << "f";
      for(std::size_t v; tokens >> v; tokens.ignore(2)) {
        const std::size_t k = random() % number_of_uvs;
        os << " " << v << "/";
        if(random() % 2 == 0)
          os << k + 1;
        else
          os << "-" << number_of_uvs - k;
      }
      os << "\n";
    } else {
      os << line << " # " << random() << "\n";
    }
  }
  const std::string text = os.str();
  AnyModel model, again;
  CHECK(model.read(text));
  for(std::size_t f = 0; f < 2 * n; ++f)
    for(std::size_t c = 0; c < 3; ++c)
      if(random() % 3 == 0)
        set_uv(model, f, c, FT(random() % 3) / FT(10), FT(random() % 3) / FT(7));
  const std::string result = rewritten(text, model);
  CHECK(again.read(result));
  CHECK(content(again) == content(model));
  CHECK(all_else(result) == all_else(text));
  CHECK_EQUAL(rewritten(result, again), result);
  Surface_model as_double; // floats are the same numbers to a reader of doubles
  CHECK(as_double.read(result));
  CHECK(content(as_double) == content(model));
}

// What is read without coordinates per corner, and what is refused.
void test_polygons()
{
  SS::IO::Polygon_soup soup;
  const auto message = [&soup](const std::string& text, const std::string& format) {
    std::istringstream is(text);
    const SS::IO::File_status status = SS::IO::read_polygon_soup(is, soup, format);
    CHECK_EQUAL(status.line != 0, status.message.str().substr(0, 5) == "line ");
    return status.message;
  };
  const std::string off = "OFF # a comment\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1e-3\n";
  CHECK_EQUAL(message(off + "4 0 1 2 3 255 0 0\n3 2 1 0\n", ""), "");
  CHECK_EQUAL(soup.format, "off");
  CHECK_EQUAL(soup.points.size(), 4u);
  CHECK_EQUAL(soup.points[3][2], 1e-3);
  CHECK(soup.polygons[0].vertices == std::vector<std::size_t>({0, 1, 2, 3}));
  CHECK_EQUAL(soup.polygons[1].line, 8u);
  CHECK_EQUAL(message("# a comment\n" + off + "4 0 1 2 3\n3 2 1 0\n", ""), "");
  CHECK_EQUAL(message("#OFFICE\nv 0 0 0\n", ""), "the file has no face");
  CHECK_EQUAL(message(off + "3 0 1 4\n3 2 1 0\n", "off"),
              "line 7: vertex index 4 is out of range: the file has 4");
  CHECK_EQUAL(message(off, "off"), "line 6: the file ends before face 0");
  CHECK_EQUAL(message("v 0 0 0\n", ""), "the file has no face");
  CHECK_EQUAL(soup.polygons.size(), 2u); // what is refused changes nothing
  CHECK_EQUAL(message(everything, "obj"), "");
  CHECK_EQUAL(soup.segments.size(), 2u);
  CHECK_EQUAL(message("solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n", ""),
              "");
  CHECK_EQUAL(soup.format, "stl");
  CHECK_EQUAL(soup.polygons.at(0).line, 2u);
}

int main(int argc, char** argv)
{
  const Floating_point_traps traps; // for all functions that are called
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : std::random_device()();
  std::cout << "seed " << seed << std::endl;
  Random random(seed);
  test_nothing_changes();
  test_changes_in_place();
  test_new_statements();
  test_welded();
  test_other_meshes();
  test_polygons();
  for(int i = 0; i < 300; ++i) {
    test_random<Surface_model, double>(random);
    test_random<Float_model, float>(random);
  }
  return report_checks();
}
