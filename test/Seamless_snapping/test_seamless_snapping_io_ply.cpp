// PLY files with coordinates per corner: read and written, in all forms of the format; and what is
// refused.

#include "floating_point_traps.h"
#include "obj_models.h"
#include "ply_squares.h"

#include <CGAL/Seamless_snapping/IO/PLY.h>

#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using Random = std::mt19937_64;

struct Ply_model : public Surface_model
{
  SS::IO::File_status read(const std::string& text, bool weld = false)
  {
    std::istringstream is(text);
    return SS::IO::read_PLY(is, mesh, uv_map,
                            SS::parameters::edge_is_constrained_map(feature_map)
                                           .weld_borders(weld));
  }

  std::string write() const
  {
    std::ostringstream os;
    CHECK(SS::IO::write_PLY(os, mesh, uv_map, "a comment\nof two lines",
                            SS::parameters::edge_is_constrained_map(feature_map)));
    return os.str();
  }
};

const std::string square_obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 5 5\nvt 6 5\nvt 6 6\n"
                               "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n";

void test_forms()
{
  Surface_model expected;
  CHECK(expected.read(square_obj));
  const Content e = content(expected);
  const auto check = [&e](const std::string& text) {
    Ply_model model, again;
    const SS::IO::File_status status = model.read(text);
    bool good = CHECK_EQUAL(status.message, "") && CHECK(content(model) == e);
    good = CHECK(again.read(model.write())) && CHECK(content(again) == e) && good;
    std::istringstream is(model.write()); // CGAL's reader takes it too
    Ply_model without_uv;
    good = CHECK(CGAL::IO::read_PLY(is, without_uv.mesh)) && good;
    good = CHECK(content(without_uv).points == e.points) && good;
    good = CHECK(content(without_uv).triangles == e.triangles) && good;
    if(!good)
      std::cerr << text << std::endl;
  };
  check(head + body);
  check(replaced(head, "float texcoord", "double texcoord") + body);
  check(replaced(head, "float texcoord", "uchar texcoord") + body);
  check(binary_square<std::uint8_t, float>(true));
  check(binary_square<std::uint8_t, float>(false));
  check(binary_square<std::uint16_t, double>(true));
  check(binary_square<std::uint16_t, double>(false));
}

void test_welded()
{
  Ply_model open, model;
  CHECK_EQUAL(open.read(cut_square).number_of_coinciding_border_edges, 2u);
  CHECK_EQUAL(model.read(cut_square, true).number_of_welded_edges, 1u);
  CHECK_EQUAL(num_vertices(model.mesh), 4u);
}

void test_features()
{
  const std::string edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\n";
  const std::string text = replaced(head, "end_header\n", edges + "end_header\n") + body;
  Ply_model model, again;
  CHECK(model.read(text + "1 2\n2 0\n"));
  CHECK(content(model).features == (std::vector<std::array<std::size_t, 2> >{{0, 2}, {1, 2}}));
  CHECK(again.read(model.write()));
  CHECK(content(again) == content(model));
  CHECK_EQUAL(Ply_model().read(text + "1 2\n3 1\n").message,
              "line element 4 2 is not an edge of the mesh");
}

void test_refused()
{
  const auto check = [](const std::string& text, const std::string& message) {
    Ply_model model;
    CHECK_EQUAL(model.read(text).message, message);
    CHECK(model.mesh.is_empty());
  };
  const std::string text = head + body;
  check("", "line 1: the file does not begin with 'ply'");
  check("ply\n", "line 2: the header has no end ('end_header')");
  check("ply\nelement vertex 1\nend_header\n", "line 3: the header tells no format");
  check(replaced(text, "ascii", "utf8"), "line 2: 'utf8' is not a format");
  check(replaced(text, "vertex 4", "vertex -4"), "line 5: '-4' is not a number of elements");
  check(replaced(text, "face 2", "vertex 2"), "line 10: there are two elements 'vertex'");
  check(replaced(text, "uchar float", "float float"),
        "line 12: the length of a list is not an integer");
  check(replaced(text, "uchar float", "uchar real"), "line 12: 'real' is not a type");
  check(replaced(text, "float x", "float"), "line 6: a property needs a type and a name");
  check(replaced(text, "element vertex 4\n", ""), "line 5: a property comes before any element");
  check(replaced(text, "comment V", "note V"), "line 3: 'note' is not a keyword");
  check(replaced(text, "float z", "float w"), "element vertex has no number z");
  check(replaced(text, "texcoord", "uvs"),
        "element face has no list texcoord: coordinates per corner are needed, not per vertex");
  check(replaced(text, "vertex_indices", "corners"), "element face has no list vertex_indices");
  check(replaced(text, "1 1 0.0", "1 nan 0.0"), "vertex 2: 'nan' is not a finite number");
  check(replaced(text, "3 0 2 3", "4 0 2 3 1"),
        "face 1: has 4 corners; triangulate the mesh first");
  check(replaced(text, "3 0 2 3", "2 0 2"), "face 1: has 2 corners, but needs 3");
  check(replaced(text, "3 0 2 3", "-3 0 2 3"), "face 1: a list has a negative length");
  check(replaced(text, "3 0 2 3", "3 0 2 2"), "face 1: uses vertex 2 twice");
  check(replaced(text, "3 0 2 3", "3 0 2 4"),
        "face 1: vertex index 4 is out of range: the file has 4 vertices");
  check(replaced(text, "3 0 2 3", "3 0 4294967298 3"), "face 1: index 4294967298 is out of range");
  check(replaced(text, "3 0 2 3", "3 0 -2 3"), "face 1: vertex index -2 is negative");
  check(replaced(text, "3 0 2 3", "3 0 2. 3"), "face 1: '2.' is not an integer");
  check(replaced(text, "6 5 5 6 5 6 6", "0"), "face 1: has 0 texture coordinates, but needs 6");
  check(replaced(text, "3 0 2 3", "3 2 0 3"),
        "edge 0 2 has the same direction in two faces (faces 0 and 1); orient the faces "
        "consistently first");
  check(replaced(text, "face 2", "face 3"), "face 2: the file ends here");
  check(replaced(text, "face 2", "face 0"), "the file has no face");
  check(replaced(text, "element face 2", std::string("element \0face 3", 15)),
        "?face 2: the file ends here"); // a name with a byte 0
  check(replaced(text, "vertex 4", "vertex 18446744073709551615"),
        "vertex 10: the file ends here");
}

// Whatever is done to a file, it is refused, or read as a mesh that is valid.
void test_mutations(Random& random, const std::string& valid, const int number)
{
  int number_of_meshes = 0;
  for(int i = 0; i < number; ++i) {
    std::string text = valid;
    for(std::uint64_t n = 1 + random() % 3; n > 0; --n) {
      const std::size_t at = random() % text.size();
      if(random() % 3 == 0)
        text.erase(at, random() % 4);
      else
        text[at] = random() % 2 == 0 ? static_cast<char>(random())
                                     : "0123456789- \n"[random() % 13];
    }
    Ply_model model, again;
    const SS::IO::File_status status = model.read(text, random() % 2 == 0);
    if(!status) {
      CHECK(model.mesh.is_empty());
      continue;
    }
    ++number_of_meshes;
    CHECK(is_valid_but_for_isolated_vertices(model.mesh));
    CHECK(again.read(model.write()));
  }
  std::cout << number << " mutations: " << number_of_meshes << " meshes" << std::endl;
  CHECK(number_of_meshes > number / 50);
}

int main(int argc, char** argv)
{
  const Floating_point_traps traps; // for all functions that are called
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : std::random_device()();
  std::cout << "seed " << seed << std::endl;
  Random random(seed);
  test_forms();
  test_welded();
  test_features();
  test_refused();
  test_mutations(random, head + body, 5000);
  test_mutations(random, binary_square<std::uint8_t, float>(true), 5000);
  return report_checks();
}
