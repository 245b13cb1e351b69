// Files as the program reads and writes them: if it copies a file with other coordinates, all else stays
// to the byte, and the coordinates are those of the mesh, to readers of doubles and of floats.

#include "HEXEX_rewriter.h"
#include "Mesh_text.h"
#include "polygon_parsers.h"

#include "floating_point_traps.h"
#include "obj_models.h"
#include "ply_squares.h"

#include <CGAL/Seamless_snapping/IO/HEXEX.h>
#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using Random = std::mt19937_64;

// Points of corners and coordinates in the order of faces, whatever the vertices are.
template <typename AnyModel>
std::vector<std::uint64_t> corners(const AnyModel& model)
{
  std::vector<std::uint64_t> result;
  for(const auto f : faces(model.mesh))
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, model.mesh), model.mesh)) {
      const auto p = model.mesh.point(target(h, model.mesh));
      const auto uv = get(model.uv_map, h);
      result.insert(result.end(), {bits(p.x()), bits(p.y()), bits(p.z()), bits(uv.x()),
                                   bits(uv.y())});
    }
  return result;
}

// A mesh with the text that it was read from.
struct File_model
{
  formats::Mesh_text file;
  Mesh mesh;
  Uv_map uv_map = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  Edge_bool_map feature_map = mesh.add_property_map<Edge, bool>("e:feature", false).first;
  formats::File_status status;

  explicit File_model(const std::string& text, const bool weld = false,
                      const bool is_float = false)
    : file(text),
      status(is_float ? file.read<float>(mesh, uv_map, feature_map, weld)
                      : file.read(mesh, uv_map, feature_map, weld))
  { }

  bool is_in(const formats::Mesh_text& text) const
  { return text.holds(mesh, uv_map, feature_map, file.vertex_numbers()); }

  // Compares the new text with the mesh, also by the library's reader.
  std::string rewritten() const
  {
    CHECK_EQUAL(status.message, "");
    std::string result;
    CHECK_EQUAL(file.rewrite(result, mesh, uv_map).message, "");
    const formats::Mesh_text written(result, file.format());
    CHECK(is_in(written));
    if(status.number_of_welded_edges == 0)
      CHECK_EQUAL(is_in(file), result == file.text());
    Surface_model again;
    std::istringstream is(result);
    const auto np = SS::parameters::edge_is_constrained_map(again.feature_map);
    CHECK(file.format() == "ply" ? SS::IO::read_PLY(is, again.mesh, again.uv_map, np)
                                 : SS::IO::read_OBJ(is, again.mesh, again.uv_map, np));
    CHECK(corners(again) == corners(*this));
    CHECK_EQUAL(again.number_of_features(), content(*this).features.size());

    const Halfedge h = mesh.halfedge(*mesh.faces().begin());
    const Kernel::Point_2 uv = uv_map[h];
    uv_map[h] = Kernel::Point_2(uv.x(), uv.y() == 0 ? 1 : uv.y() / 2);
    CHECK(!is_in(written));
    uv_map[h] = uv;
    return result;
  }

  void set_uv(const std::size_t face, std::size_t corner, const double u, const double v) const
  {
    Halfedge h = mesh.halfedge(Mesh::Face_index(Mesh::size_type(face)));
    for(; corner > 0; --corner)
      h = mesh.next(h);
    uv_map[h] = Kernel::Point_2(u, v);
  }
};

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
  CHECK_EQUAL(File_model(everything).rewritten(), everything);
}

void test_changes_in_place()
{
  const File_model model(everything);
  // the corner of the second vt, and both of the first
  model.set_uv(0, 1, 0.1, 0.);
  model.set_uv(0, 0, 0., -0.);
  model.set_uv(1, 0, 0., -0.);
  std::string expected = everything;
  expected.replace(expected.find("vt 1 0 0.25"), 6, "vt 0.1 0");
  expected.replace(expected.find("0.0e0"), 5, "-0");
  CHECK_EQUAL(model.rewritten(), expected);
}

void test_new_statements()
{
  const File_model model(everything);
  model.set_uv(1, 0, 5., 6.);  // of the first vt, which stays for the first face
  model.set_uv(1, 1, 7., 8.);  // of the third
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
  CHECK_EQUAL(model.rewritten(), expected);

  // at the end of a text without a new line
  const std::string end = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/2\nvt 2 2\nvt 1 1 4";
  const File_model other(end);
  other.set_uv(0, 1, 3., 3.);
  CHECK_EQUAL(other.rewritten(),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\nvt 2 2\nvt 3 3\nvt 1 1 4");
  other.set_uv(0, 1, 2., 2.);
  other.set_uv(0, 0, 1., 1.);
  std::string last = end;
  last.replace(last.find("2/1"), 3, "2/2");
  const File_model third(last);
  third.set_uv(0, 2, -1., 0.5);
  CHECK_EQUAL(third.rewritten(),
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/3\nvt 2 2\nvt 1 1 4\nvt -1 0.5 4");
}

void test_welded()
{
  const std::string cut = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 0\nv 1 0 0\nvt 0 0\nvt 1 1\n"
                          "f 1/1 2/1 3/1 # one\nf 6/2 5/2 4/2\nf -3/2 -5/2 -1/2\nv 0 -1 0\n";
  const std::string expected = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 0\nv 1 0 0\nvt 0 0\n"
                               "vt 1 1\nf 1/1 2/1 3/1 # one\nf 2/2 1/2 4/2\n";
  const std::string two = cut.substr(0, cut.find("f -3"));
  const File_model model(two, true);
  CHECK_EQUAL(num_vertices(model.mesh), 4u);
  CHECK_EQUAL(model.rewritten(), expected);
  CHECK_EQUAL(File_model(two).rewritten(), two); // without welding
  CHECK_EQUAL(File_model(two, true, true).rewritten(), expected);

  const std::string polylines = "l 6 5 4/1\nl -1 -2 -3/1\nl -5 -4\n";
  CHECK_EQUAL(File_model(two + polylines, true).rewritten(),
              expected + "l 2 1 4/1\nl -5 -6 -3/1\nl -5 -4\n");
  const std::string relative = two.substr(0, two.find("f 6")) + "f -1/-1 -2/-1 -3/-1\n";
  CHECK_EQUAL(File_model(relative, true).rewritten(),
              two.substr(0, two.find("f 6")) + "f -5/-1 -6/-1 -3/-1\n");
}

void test_other_meshes()
{
  File_model model(everything), moved(everything);
  const File_model other(band(4, false));
  const auto message = [&model](const File_model& of) {
    std::string result;
    const auto status = model.file.rewrite(result, of.mesh, of.uv_map);
    CHECK(result.empty());
    return status.message;
  };
  const std::string refusal = "the mesh has other faces than the file";
  moved.mesh.point(*moved.mesh.vertices().begin()) = Kernel::Point_3(0, 0, 1);
  CHECK_EQUAL(message(other), refusal);
  CHECK_EQUAL(message(moved), refusal);
  model.set_uv(0, 0, 0., std::numeric_limits<double>::infinity());
  CHECK_EQUAL(message(model), "a coordinate is not finite; nothing is written");
  CHECK(!File_model(band(1, false)).status);
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
void test_random(const bool is_float, Random& random)
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
  const File_model model(text, false, is_float);
  const auto fraction = [&](const int divisor) {
    const int numerator = int(random() % 3);
    return is_float ? double(float(numerator) / float(divisor)) : double(numerator) / double(divisor);
  };
  for(std::size_t f = 0; f < 2 * n; ++f)
    for(std::size_t c = 0; c < 3; ++c)
      if(random() % 3 == 0)
        model.set_uv(f, c, fraction(10), fraction(7));
  const std::string result = model.rewritten();
  const File_model again(result, false, is_float), as_double(result);
  CHECK(content(again) == content(model));
  CHECK(content(as_double) == content(model)); // floats are the same numbers to a reader of doubles
  CHECK(all_else(result) == all_else(text));
  CHECK_EQUAL(again.rewritten(), result);
}

void test_PLY()
{
  for(const std::string& text :
      {head + body, replaced(head, "float texcoord", "double texcoord") + body,
       replaced(head, "float texcoord", "uchar texcoord") + body,
       binary_square<std::uint8_t, float>(true), binary_square<std::uint8_t, float>(false),
       binary_square<std::uint16_t, double>(true), binary_square<std::uint16_t, double>(false)})
    CHECK_EQUAL(File_model(text).rewritten(), text);

  // a float stays one if it can
  const std::string text = head + body;
  const File_model model(text);
  model.set_uv(0, 1, 0.5, -0.);
  CHECK_EQUAL(model.rewritten(), replaced(text, "6 0 0 1.0 0 1 1", "6 0 0 0.5 -0 1 1"));
  model.set_uv(0, 1, 0.1, 1e300);
  CHECK_EQUAL(model.rewritten(),
              replaced(replaced(text, "6 0 0 1.0 0 1 1", "6 0 0 0.1 1e+300 1 1"), "float texcoord",
                       "double texcoord"));

  const auto growth = [](const std::string& binary, const double x) {
    const File_model changed(binary);
    changed.set_uv(1, 1, x, 0);
    return changed.rewritten().size() - binary.size();
  };
  // "float32" becomes "double", and 12 numbers grow by 4 bytes
  const std::size_t of_all = 12 * 4 - 1;
  CHECK_EQUAL(growth(binary_square<std::uint8_t, float>(true), 0.1), of_all);
  CHECK_EQUAL(growth(binary_square<std::uint8_t, float>(false), 0.1), of_all);
  CHECK_EQUAL(growth(binary_square<std::uint8_t, float>(false), double(0.1f)), 0u);
  CHECK_EQUAL(growth(binary_square<std::uint16_t, double>(true), 0.1), 0u);
}

void test_welded_PLY()
{
  CHECK_EQUAL(File_model(cut_square).rewritten(), cut_square);
  CHECK_EQUAL(File_model(cut_square, true).rewritten(),
              replaced(cut_square, "3 4 5 3", "3 0 2 3"));
  const std::string edge = "element edge 1\nproperty int vertex2\nproperty int vertex1\n";
  const std::string with_edge = replaced(cut_square, "end_header\n", edge + "end_header\n") + "5 4\n";
  CHECK_EQUAL(File_model(with_edge, true).rewritten(),
              replaced(replaced(with_edge, "3 4 5 3", "3 0 2 3"), "5 4\n", "2 0\n"));
}

// The files that a fuzzer has found to take different ways through the readers.
void test_corpus()
{
  std::size_t number_of_meshes = 0;
  for(const auto& entry : std::filesystem::directory_iterator("fuzzing/corpus")) {
    std::ifstream is(entry.path(), std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(is), {}), text = all.substr(1);
    const std::size_t failed = checking::counts().failed;
    const File_model model(text, all[0] % 4 >= 2);
    if(!model.status)
      continue;
    ++number_of_meshes;
    if(model.status.number_of_welded_edges == 0)
      CHECK_EQUAL(model.rewritten(), text);
    std::size_t i = 0; // coordinates that make some corners differ, and others agree
    for(const auto f : model.mesh.faces())
      for(const Halfedge h : model.mesh.halfedges_around_face(model.mesh.halfedge(f)))
        if(++i % 3 != 0)
          model.uv_map[h] = Kernel::Point_2(double(i * i % 7) / 10, i % 5 == 0 ? 1e300 : -0.);
    model.rewritten();
    if(checking::counts().failed != failed)
      std::cerr << "    " << entry.path() << std::endl;
  }
  std::cout << number_of_meshes << " meshes of a fuzzer" << std::endl;
  CHECK(number_of_meshes > 0);
}

void test_HEXEX()
{
  const std::string first = "4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1\n";
  const std::string cell = "0 1 2 3  0 0 0  1/3 0 0\t0 -6/4 0\r\n0 0 1e0\n";
  const std::string last = "1\n0 1 2 0.5\n1 1 1\n0\n1 2\n0 1 3\nand more";
  const auto status = [](const std::string& text, const auto& uvw, std::string& result) {
    std::istringstream original(text);
    std::ostringstream os;
    const auto made = formats::rewrite_HEXEX(original, os, uvw);
    result = os.str();
    return made;
  };
  std::istringstream is(first + cell + last);
  SS::IO::HEXEX_mesh mesh;
  CHECK(bool(SS::IO::read_HEXEX(is, mesh)));
  mesh.uvw[3][2] = 0.1;
  std::string result;
  CHECK_EQUAL(status(first + cell + last, mesh.uvw, result).message, "");
  CHECK_EQUAL(result, first + "0 1 2 3  0 0 0  0.3333333333333333 0 0\t0 -6/4 0\r\n0 0 0.1\n" +
                        last);
  // nothing is written of what is refused
  CHECK(!status(first + "0 1 2 3 0 0", mesh.uvw, result) && result.empty());
  CHECK(!status("4\n0 0", mesh.uvw, result) && result.empty());
  mesh.uvw[3][0] = std::numeric_limits<double>::infinity();
  CHECK(!status(first + cell + last, mesh.uvw, result) && result.empty());
  mesh.uvw.pop_back();
  CHECK_EQUAL(status(first + cell + last, mesh.uvw, result).message,
              "the original has 4 corners, and there are coordinates for 3");
}

// What is read without coordinates per corner, and what is refused.
void test_polygons()
{
  formats::Polygons soup;
  const auto message = [&soup](const std::string& text, const std::string& format) {
    CHECK_EQUAL(formats::format_of_polygons(text), format);
    const formats::File_status status =
      formats::read_polygons([&] { return formats::parse_polygons(text, format); }, soup);
    CHECK_EQUAL(status.line != 0, status.message.str().substr(0, 5) == "line ");
    return status.message;
  };
  const std::string off = "OFF # a comment\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 1e-3\n";
  CHECK_EQUAL(message(off + "4 0 1 2 3 255 0 0\n3 2 1 0\n", "off"), "");
  CHECK_EQUAL(soup.points.size(), 4u);
  CHECK_EQUAL(soup.points[3][2], 1e-3);
  CHECK(soup.polygons[0].vertices == std::vector<std::size_t>({0, 1, 2, 3}));
  CHECK_EQUAL(soup.polygons[1].line, 8u);
  CHECK_EQUAL(message("# a comment\n" + off + "4 0 1 2 3\n3 2 1 0\n", "off"), "");
  CHECK_EQUAL(message("#OFFICE\nv 0 0 0\n", "obj"), "the file has no face");
  CHECK_EQUAL(message(off + "3 0 1 4\n3 2 1 0\n", "off"),
              "line 7: vertex index 4 is out of range: the file has 4");
  CHECK_EQUAL(message(off, "off"), "line 6: the file ends before face 0");
  CHECK_EQUAL(message("v 0 0 0\n", "obj"), "the file has no face");
  CHECK_EQUAL(soup.polygons.size(), 2u); // what is refused changes nothing
  CHECK_EQUAL(message(everything, "obj"), "");
  CHECK_EQUAL(soup.segments.size(), 2u);
  CHECK_EQUAL(message("solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n",
                      "stl"), "");
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
  test_PLY();
  test_welded_PLY();
  test_corpus();
  test_HEXEX();
  test_polygons();
  for(int i = 0; i < 300; ++i) {
    test_random(false, random);
    test_random(true, random);
  }
  return report_checks();
}
