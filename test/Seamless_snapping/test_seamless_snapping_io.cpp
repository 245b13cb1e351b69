// Reading and writing of OBJ files: what the format allows, and what is refused with which line.

#include "floating_point_traps.h"
#include "obj_models.h"

#include <CGAL/Seamless_snapping/internal/snapping/snap_surface.h>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

// Two triangles of a square; `f` statements are on lines 9 and 10.
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

void check_same_as_square(const std::string& name, const std::string& text)
{
  Surface_model expected, model;
  CHECK(expected.read(square));
  const SS::IO::File_status status = model.read(text);
  if(!CHECK(status) || !CHECK(content(model) == content(expected)))
    std::cerr << "    " << name << ": " << status << std::endl;
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for(std::size_t i = text.find(what); i != text.npos; i = text.find(what, i + by.size()))
    text.replace(i, what.size(), by);
  return text;
}

void test_valid_variants()
{
  check_same_as_square("no final newline", square.substr(0, square.size() - 1));
  check_same_as_square("CRLF", replaced(square, "\n", "\r\n"));
  check_same_as_square("CR", replaced(square, "\n", "\r"));
  check_same_as_square("tabs", replaced(square, " ", "\t"));
  check_same_as_square("many blanks",
                       "  " + replaced(replaced(square, " ", " \t  "), "\n", "  \n "));
  check_same_as_square("empty lines", "\n\n" + replaced(square, "\n", "\n\n \n"));
  check_same_as_square("UTF-8 mark", "\xEF\xBB\xBF" + square);
  check_same_as_square("comments", "#no blank\n# ends in a backslash \\\n"
                                     + replaced(square, "\n", " # a comment\n"));
  check_same_as_square("continuation", replaced(square, " ", " \\\n"));
  check_same_as_square("continuation without a blank", replaced(square, " ", "\\\r\n"));
  check_same_as_square("normals", replaced(replaced(square, "/3", "/3/1"), "/4", "/4/-1"));
  check_same_as_square("empty normals", replaced(square, "/3", "/3/"));
  check_same_as_square("third texture coordinate", replaced(square, "vt 1 1\n", "vt 1 1 0.5\n"));
  check_same_as_square("color", replaced(square, "v 1 1 0\n", "v 1 1 0 .1 .2 .3\n"));
  check_same_as_square("weight", replaced(square, "v 1 1 0\n", "v 1 1 0 1.0\n"));
  check_same_as_square("plus", replaced(square, "v 1 1 0\n", "v +1 +1. +.0e+9\n"));
  check_same_as_square("scientific", replaced(square, "vt 1 1\n", "vt 100e-2 0.001E+3\n"));
  check_same_as_square("underflow", replaced(square, "vt 0 1\n", "vt 1e-99999999999999999999 1\n"));
  check_same_as_square("underflow", replaced(square, "vt 0 1\n", "vt 2e-324 1\n"));
  check_same_as_square("underflow", replaced(square, "vt 0 1\n",
                                             "vt 0." + std::string(400, '0') + "1 1\n"));
  check_same_as_square("long mantissa", replaced(square, "vt 0 1\n",
                                                 "vt 0 1." + std::string(900, '0') + "1\n"));
  check_same_as_square("zero with a large exponent", replaced(square, "vt 0 1\n", "vt 0e999 1\n"));
  check_same_as_square("other statements", "mtllib a.mtl\no x\ng\ns off\nvn 0 0 1\nvp a b\nfoo\n"
                                             + square + "usemtl y\nend \\\n f 1 2\n");
  check_same_as_square("leading zeros", replaced(square, "f 1/1 2/2", "f 0001/1 2/00000000000002"));
  check_same_as_square("forward references", square.substr(square.find('f'))
                                               + square.substr(0, square.find('f')));
  check_same_as_square("negative indices", replaced(replaced(square, "f 1/1 2/2 3/3",
                                                             "f -4/-4 -3/-3 -2/-2"),
                                                    "f 1/1 3/3 4/4", "f -4/1 3/-2 -1/-1"));
}

void test_features()
{
  const auto features = [](const std::string& lines) {
    Surface_model model;
    const SS::IO::File_status status = model.read(square + lines);
    CHECK(status);
    return content(model).features;
  };
  using Features = std::vector<std::array<std::size_t, 2> >;
  CHECK(features("l 3 1\n") == (Features{{0, 2}}));
  CHECK(features("l 1 2 3 1 4\n") == (Features{{0, 1}, {0, 2}, {0, 3}, {1, 2}}));
  CHECK(features("l 1/1 2/1\nl -1 -2\nl 2 1\n") == (Features{{0, 1}, {2, 3}}));

  // without a map, only the syntax counts
  std::istringstream is(square + "l 2 4\n");
  Surface_model model;
  CHECK(SS::IO::read_OBJ(is, model.mesh, model.uv_map));
}

void test_corners_and_order()
{
  // the corners of the two faces differ at both shared vertices
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\n"
                           "vt 0 0\nvt 1 0\nvt 1 1\nvt 5 5\nvt 6 6\nvt 7 7\n"
                           "f 3/3 1/1 2/2\nf 3/5 4/6 1/4\n";
  const auto check = [&text](auto model) {
    CHECK(model.read(text));
    const Content c = content(model);
    CHECK(c.triangles == (std::vector<std::size_t>{2, 0, 1, 2, 3, 0}));
    CHECK(c.uvs == (std::vector<std::uint64_t>{
                     bits(1.), bits(1.), bits(0.), bits(0.), bits(1.), bits(0.),
                     bits(6.), bits(6.), bits(7.), bits(7.), bits(5.), bits(5.)}));
    CHECK_EQUAL(num_vertices(model.mesh), 5u); // the last without a face
    CHECK(is_valid_but_for_isolated_vertices(model.mesh));
  };
  check(Surface_model());
  check(Polyhedron_model());

  // corners at a vertex share coordinates if they agree to the last bit, and only then
  Surface_model zeros;
  CHECK(zeros.read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt -0 0\nvt 1 1\nvt 1 1\n"
                   "f 1/1 2/3 3/3\nf 1/2 3/4 4/3\n"));
  const std::string written = zeros.write();
  CHECK_EQUAL(written.substr(written.find("vt")),
              "vt 0 0\nvt 1 1\nvt 1 1\nvt -0 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/4 3/3 4/5\n");

  // data are added, and nothing is touched on failure
  Surface_model model;
  CHECK(model.read(text));
  CHECK(!model.read("v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/1 3/1\n"));
  CHECK_EQUAL(num_vertices(model.mesh), 5u);
  CHECK(model.read(square));
  CHECK_EQUAL(num_vertices(model.mesh), 9u);
  CHECK_EQUAL(num_faces(model.mesh), 4u);
}

void test_split_vertices()
{
  // two open fans at vertex 1, and a closed one, the tip of a tetrahedron
  const std::string text =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nv 1 0 2\nv 0 1 2\nv 0 0 2\nvt 0 0\n"
    "f 1/1 2/1 3/1\nf 4/1 5/1 1/1\n"
    "f 1/1 6/1 7/1\nf 1/1 7/1 8/1\nf 8/1 6/1 1/1\nf 6/1 8/1 7/1\nl 1 5\nl 8 1\n";
  const auto check = [&text](auto model) {
    const SS::IO::File_status status = model.read(text);
    CHECK(status);
    CHECK_EQUAL(status.number_of_split_vertices, 2u);
    CHECK_EQUAL(num_vertices(model.mesh), 10u);
    CHECK(CGAL::is_valid_polygon_mesh(model.mesh));
    CHECK(content(model).triangles
          == (std::vector<std::size_t>{0, 1, 2, 3, 4, 8, 9, 5, 6, 9, 6, 7, 7, 5, 9, 5, 7, 6}));
    CHECK_EQUAL(model.number_of_features(), 2u);

    std::remove_reference_t<decltype(model)> again;
    CHECK_EQUAL(again.read(model.write()).number_of_split_vertices, 0u);
    CHECK(content(again) == content(model));
  };
  check(Surface_model());
  check(Polyhedron_model());
}

void check_refused(const std::string& text, std::size_t line, const std::string& fragment)
{
  Surface_model model;
  const SS::IO::File_status status = model.read(text);
  const std::string start = line == 0 ? "" : "line " + std::to_string(line) + ": ";
  bool good = CHECK(!status) && CHECK_EQUAL(status.line, line);
  good = CHECK(status.message.find(start) == 0) && good;
  good = CHECK(status.message.find(fragment) != status.message.npos) && good;
  good = CHECK(model.mesh.is_empty()) && good;
  if(!good)
    std::cerr << "    expected: " << fragment << "\n    message:  " << status.message << std::endl;
}

void test_refused_statements()
{
  const auto with = [](const std::string& old, const std::string& changed) {
    CHECK(square.find(old) != square.npos);
    return replaced(square, old, changed);
  };
  check_refused("", 0, "has no face");
  check_refused("v 0 0 0\n\nOFF\n", 0, "has no face");
  check_refused(with("v 1 1 0\n", "v 1 1\n"), 3, "v needs 3 coordinates, but has 2");
  check_refused(with("v 1 1 0\n", "v 1 1 0 2\n"), 3, "point has a weight other than 1");
  check_refused(with("vt 1 1\n", "vt 1\n"), 7, "vt needs 2 coordinates, but has 1");
  check_refused(with("vt 1 1\n", "vt\n"), 7, "vt needs 2 coordinates, but has 0");
  for(const std::string number : {"1x", "1e", "1,5", "0x1p0", "1d5", "1..2", "1e+"})
    check_refused(with("vt 1 1\n", "vt 1 " + number + "\n"), 7, "'" + number + "' is not a number");
  for(const std::string number : {"nan", "inf", "-inf", "NaN(3)", "-", "+", "+-1", "--1", "e5"})
    check_refused(with("vt 1 1\n", "vt 1 " + number + "\n"), 7,
                  "'" + number + "' is not a finite number");
  check_refused(with("vt 1 1\n", "vt 1 .\n"), 7, "'.' is not a number");
  check_refused(with("vt 1 1\n", "vt 1 1#x\n"), 7, "'1#x' is not a number");
  check_refused(with("vt 1 1\n", "vt 1 1 x\n"), 7, "'x' is not a finite number");
  for(const std::string number : {"1e309", "-2e308", "1e99999999999999999999", "0.001e400"})
    check_refused(with("vt 1 1\n", "vt 1 " + number + "\n"), 7, "'" + number + "' is too large");
  for(const std::string exponent : {"", ".5", "e-9"})
    check_refused(with("vt 1 1\n", "vt 1 " + std::string(400, '9') + exponent + "\n"), 7,
                  "999...' is too large");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 2/2 3/3 4/4"), 10,
                "face has 4 corners; triangulate the mesh first");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3"), 10, "face has 2 corners, but needs 3");
  check_refused(with("f 1/1 3/3 4/4", "f"), 10, "face has 0 corners");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3 1/4"), 10, "face uses vertex 1 twice");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3 4/4"), 10, "corner '3' has no texture coordinate");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3//3 4/4"), 10, "corner '3//3' has no texture");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/ 4/4"), 10, "corner '3/' has no texture coordinate");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 /3 4/4"), 10, "'' is not the index of a vertex");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3x 4/4"), 10,
                "'3x' is not the index of a texture coordinate");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3/x 4/4"), 10, "'x' is not the index of a normal");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3/1/1 4/4"), 10, "'1/1' is not the index of a no");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3.0/3 4/4"), 10, "'3.0' is not the index of a vertex");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 0/3 4/4"), 10, "vertex index 0: indices start at 1");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 5/3 4/4"), 10,
                "vertex index 5 is out of range: the file has 4");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/3 4/5"), 10,
                "texture coordinate index 5 is out of range: the file has 4");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 -5/3 4/4"), 10,
                "vertex index -5 is out of range: there are 4 so far");
  // 2^32 more than an index that would do
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 4294967299/3 4/4"), 10,
                "vertex index '4294967299' is out of range");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/4294967299 4/4"), 10,
                "texture coordinate index '4294967299' is out of range");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 3/18446744073709551619 4/4"), 10, "is out of range");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 99999999999999999999/3 4/4"), 10, "is out of range");
  check_refused(with("f 1/1 3/3 4/4", "f 1/1 -9223372036854775808/3 4/4"), 10, "is out of range");
  check_refused(square + "l 1\n", 11, "line element needs 2 vertices or more, but has 1");
  check_refused(square + "l 1 2 x\n", 11, "'x' is not the index of a vertex");
  check_refused(square + "l 1 2 9\n", 11, "vertex index 9 is out of range");
  check_refused(square + "l 1 2\nl 3 2 4\n", 12, "line element 2 4 is not an edge of the mesh");
  check_refused(square + "l 1 1\n", 11, "line element 1 1 is not an edge of the mesh");
  // the line on which the statement starts, however lines end
  check_refused(replaced(with("vt 1 1\n", "vt \\\n\\\n 1 x\n"), "\n", "\r\n"), 7, "'x'");
  check_refused(with("vt 0 0\nvt 1 0\nvt 1 1\n", "vt \\\n0 \\\n0\n#\\\nvt 1 0\n\nvt y 1\n"), 11,
                "'y'");
  check_refused(replaced(with("vt 1 1", "vt 1 x"), "\n", "\r"), 7, "'x'");
}

void test_refused_surfaces()
{
  const auto faces = [](const std::string& statements) {
    return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 2\nvt 0 0\n" + statements;
  };
  check_refused(faces("f 1/1 2/1 3/1\nf 1/1 2/1 4/1\n"), 8,
                "edge 1 2 has the same direction in two faces (lines 7 and 8); orient the faces");
  check_refused(faces("f 1/1 2/1 3/1\nf 2/1 1/1 4/1\nf 1/1 2/1 5/1\n"), 9,
                "edge 1 2 is not manifold: 3 faces share it (lines 7, 8, 9)");
  check_refused(faces("f 1/1 2/1 3/1\nf 2/1 3/1 1/1\n"), 8, "same direction");
  check_refused(faces("f 1/1 2/1 3/1\nf 2/1 3/1 1/1\nf 1/1 2/1 3/1\nf 1/1 2/1 3/1\n"), 8,
                "4 faces share it (lines 7, 8, 9, ...)");
  CHECK(Surface_model().read(band(5, false)));
  CHECK(Polyhedron_model().read(band(5, false)));
  check_refused(band(5, true), 21, "(lines 12 and 21): the surface is not orientable");
}

// Each face of a file with vertices of its own, as if it was cut along all edges.
std::string exploded(const std::string& text)
{
  std::vector<std::string> points = {""};
  std::string vertices, faces, others;
  std::size_t n = 0;
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line); ) {
    std::istringstream tokens(line);
    std::string keyword, corner;
    tokens >> keyword;
    if(keyword == "v") {
      points.push_back(line + "\n");
    } else if(keyword == "f") {
      faces += "f";
      while(tokens >> corner) {
        vertices += points[std::stoul(corner)];
        faces += " " + std::to_string(++n) + corner.substr(corner.find('/'));
      }
      faces += "\n";
    } else {
      others += line + "\n";
    }
  }
  return vertices + others + faces;
}

SS::IO::File_status read_welded(const std::string& text, Surface_model& model)
{
  std::istringstream is(text);
  return SS::IO::read_OBJ(is, model.mesh, model.uv_map,
                          SS::parameters::weld_borders(true)
                                         .edge_is_constrained_map(model.feature_map));
}

void check_weld(const std::string& text, std::size_t vertices, std::size_t welded,
                std::size_t coinciding)
{
  Surface_model model;
  const SS::IO::File_status status = read_welded(text, model);
  bool good = CHECK(status) && CHECK_EQUAL(num_vertices(model.mesh), vertices);
  good = CHECK_EQUAL(status.number_of_welded_edges, welded) && good;
  good = CHECK_EQUAL(status.number_of_coinciding_border_edges, coinciding) && good;
  if(!good)
    std::cerr << status << "\n" << text << std::endl;

  // what the reader counts is what a function on the mesh counts, with welding and without
  const auto count = [](const Surface_model& m) {
    return SS::internal::number_of_coinciding_border_edges(m.mesh, m.mesh.points());
  };
  CHECK_EQUAL(count(model), coinciding);
  Surface_model cut;
  CHECK_EQUAL(cut.read(text).number_of_coinciding_border_edges, coinciding + 2 * welded);
  CHECK_EQUAL(count(cut), coinciding + 2 * welded);
}

// A mesh that was cut along all edges comes back, with the coordinates of its corners.
void test_welding_everything()
{
  std::string text = band(7, false);
  for(std::size_t i = 0; i < 14; ++i) // a vt per face
    text += "vt " + std::to_string(i) + " 0.5\n";
  std::size_t face = 0;
  for(std::size_t i = text.find("f "); i != text.npos; i = text.find("f ", i + 1)) {
    const std::size_t end = text.find('\n', i);
    text.replace(i, end - i, replaced(text.substr(i, end - i), "/1",
                                      "/" + std::to_string(++face + 1)));
  }
  Surface_model expected, model;
  CHECK(expected.read(text));
  const SS::IO::File_status status = read_welded(exploded(text), model);
  CHECK(status);
  CHECK_EQUAL(status.number_of_welded_edges, 14u); // rungs and diagonals
  CHECK_EQUAL(num_vertices(model.mesh), 14u);
  CHECK(CGAL::is_valid_polygon_mesh(model.mesh));

  // vertices come in the order of their first corners
  const Content c = content(model), e = content(expected);
  CHECK(c.uvs == e.uvs);
  CHECK_EQUAL(c.triangles.size(), e.triangles.size());
  for(std::size_t i = 0; i < c.triangles.size(); ++i)
    CHECK(std::equal(&c.points[3 * c.triangles[i]], &c.points[3 * c.triangles[i]] + 3,
                     &e.points[3 * e.triangles[i]]));

  std::ostringstream note;
  note << Surface_model().read(exploded(text));
  CHECK_EQUAL(note.str(), "ok; 28 border edges coincide: is this a mesh that was cut open?");
  check_weld(text, 14, 0, 0);
}

void test_welding()
{
  test_welding_everything();
  const std::string two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 -1 0\nvt 0 0\n"
                          "f 1/1 2/1 3/1\n";
  check_weld(two + "f 5/1 4/1 6/1\n", 4, 1, 0);
  check_weld(two + "f 5/1 4/1 6/1\nv 3 3 3\n", 5, 1, 0); // one that has no face anyway
  check_weld(replaced(two, "v 0 0 0\nv 1 0 0\nv 0 -1", "v -0 0 0\nv 1 0 -0\nv 0 -1")
               + "f 5/1 4/1 6/1\n", 4, 1, 0); // zeros are equal
  check_weld(replaced(two, "v 1 0 0\nv 0 -1", "v 1 0 1e-300\nv 0 -1") + "f 5/1 4/1 6/1\n", 6, 0,
             0);                                           // nearly equal
  check_weld(two + "f 4/1 5/1 6/1\n", 6, 0, 2);            // of one direction
  check_weld(two + "f 5/1 4/1 6/1\nv 0 0 0\nv 1 0 0\nv 0 0 9\nf 8/1 7/1 9/1\n", 9, 0, 3); // which?
  check_weld("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv -1 0 0\nv 0 -1 0\nvt 0 0\n"
             "f 1/1 2/1 3/1\nf 4/1 5/1 6/1\n", 6, 0, 0); // a common point only

  // polylines follow their vertices
  Surface_model model;
  CHECK(read_welded(two + "f 5/1 4/1 6/1\nl 4 5\nl 1 3\n", model));
  CHECK(content(model).features == (std::vector<std::array<std::size_t, 2> >{{0, 1}, {0, 2}}));

  // both sides of a cushion: their diagonals become one edge of four faces
  std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const std::string cushion = points + points + "vt 0 0\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\n"
                              "f 7/1 6/1 5/1\nf 8/1 7/1 5/1\n";
  CHECK_EQUAL(read_welded(cushion, model).message,
              "line 12: once welded, edge 1 3 is not manifold: 4 faces share it (lines 10, 11, 12, "
              "...); CGAL::Polygon_mesh_processing::orient_polygon_soup() cuts it");
  // a face without area between two sides of a seam
  const std::string slit = "v 0 0 0\nv 1 0 0\nv 0 0 0\nv 0 1 0\nv 0 1 0\nvt 0 0\n"
                           "f 1/1 2/1 3/1\nf 2/1 1/1 4/1\nf 3/1 2/1 5/1\n";
  CHECK_EQUAL(read_welded(slit, model).line, 7u);
  CHECK_EQUAL(num_faces(model.mesh), 2u); // as before
}

// Streams that throw: at failures, not at their ends.
void test_exceptions()
{
  for(const std::ios::iostate mask : {std::ios::failbit | std::ios::badbit,
                                      std::ios::failbit | std::ios::badbit | std::ios::eofbit}) {
    const auto try_to_read = [mask](auto& is) {
      is.exceptions(mask);
      Surface_model model;
      bool has_thrown = false;
      try {
        CHECK(SS::IO::read_OBJ(is, model.mesh, model.uv_map));
      } catch(const std::ios_base::failure&) {
        has_thrown = true;
      }
      CHECK(is.exceptions() == mask);
      CHECK(has_thrown || num_faces(model.mesh) == 2);
      return !has_thrown;
    };
    std::istringstream is(square);
    CHECK(try_to_read(is));
    CHECK(is);
    std::ifstream folder(".");
    if(folder) // which can be opened, but not read, on some systems
      CHECK(!try_to_read(folder));
  }
}

void test_failing_files()
{
  Surface_model model;
  const std::string missing = "no/such/file.obj";
  SS::IO::File_status status = SS::IO::read_OBJ(missing, model.mesh, model.uv_map);
  CHECK(!status);
  CHECK_EQUAL(status.line, 0u);
  CHECK_EQUAL(status.message, "cannot open '" + missing + "': No such file or directory");
  status = SS::IO::read_OBJ(".", model.mesh, model.uv_map);
  CHECK_EQUAL(status.message, "cannot read '.': Is a directory");
  status = SS::IO::write_OBJ(missing, model.mesh, model.uv_map);
  CHECK_EQUAL(status.message,
              "cannot open '" + missing + "' for writing: No such file or directory");

  std::ostringstream os;
  CHECK(model.read(square));
  put(model.uv_map, halfedge(*faces(model.mesh).begin(), model.mesh),
      Kernel::Point_2(0, std::numeric_limits<double>::quiet_NaN()));
  status = SS::IO::write_OBJ(os, model.mesh, model.uv_map);
  CHECK_EQUAL(status.message, "a coordinate is not finite; nothing is written");
  CHECK(os.str().empty());
  const std::filesystem::path path =
    std::filesystem::temp_directory_path() / "test_seamless_snapping_io.obj";
  std::ofstream(path) << "earlier";
  CHECK(!SS::IO::write_OBJ(path.string(), model.mesh, model.uv_map));
  std::ifstream file(path);
  CHECK_EQUAL(std::string(std::istreambuf_iterator<char>(file), {}), "earlier");
  file.close();
  std::filesystem::remove(path);

  std::istringstream is(square);
  Surface_model other;
  CHECK(SS::IO::read_OBJ(is, other.mesh, other.uv_map));
  CHECK(is); // at its end, but not failed
  CHECK(is.eof());
  if(std::filesystem::exists("/dev/full")) {
    status = SS::IO::write_OBJ("/dev/full", other.mesh, other.uv_map);
    CHECK_EQUAL(status.message, "cannot write to '/dev/full': No space left on device");
  }
  os.setstate(std::ios::badbit);
  status = SS::IO::write_OBJ(os, other.mesh, other.uv_map);
  CHECK_EQUAL(status.message, "cannot write to the stream");
}

int main()
{
  const Floating_point_traps traps; // for all functions that are called
  test_valid_variants();
  test_features();
  test_corners_and_order();
  test_split_vertices();
  test_refused_statements();
  test_refused_surfaces();
  test_welding();
  test_exceptions();
  test_failing_files();
  return report_checks();
}
