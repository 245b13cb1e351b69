// OBJ files of all kinds come back bit for bit: random numbers of all magnitudes, and the files of
// the data folder; what random changes make of a file is refused or valid, and does no harm.

#include "obj_models.h"
#include "test_data.h"

#include <CGAL/FPU.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <random>
#include <string_view>
#include <tuple>
#include <type_traits>

using Random = std::mt19937_64;

// Finite numbers with all bit patterns alike, and the special ones.
template <typename FT>
FT random_number(Random& random)
{
  using Bits = std::conditional_t<sizeof(FT) == 4, std::uint32_t, std::uint64_t>;
  using Limits = std::numeric_limits<FT>;
  const std::array<FT, 10> special = {FT(0), -FT(0), Limits::denorm_min(), -Limits::denorm_min(),
                                      (Limits::min)(), (Limits::max)(), Limits::lowest(),
                                      std::nextafter((Limits::min)(), FT(0)), FT(0.1),
                                      FT(1e30)};
  if(random() % 8 == 0)
    return special[random() % special.size()];
  for(;;) {
    const Bits b = static_cast<Bits>(random());
    FT x;
    std::memcpy(&x, &b, sizeof(FT));
    if(std::isfinite(x))
      return x;
  }
}

template <typename FT, typename AnyModel>
void test_random_numbers(Random& random)
{
  using Mesh = typename AnyModel::Mesh;
  using Point_2 = typename boost::property_traits<typename AnyModel::Halfedge_uv_map>::value_type;
  using VPM = typename boost::property_map<Mesh, CGAL::vertex_point_t>::type;
  using Point_3 = typename boost::property_traits<VPM>::value_type;

  AnyModel model;
  CHECK(model.read(band(500, false)));
  for(const auto v : vertices(model.mesh))
    put(CGAL::vertex_point, model.mesh, v, Point_3(random_number<FT>(random),
                                                   random_number<FT>(random),
                                                   random_number<FT>(random)));
  for(const auto h : halfedges(model.mesh))
    put(model.uv_map, h, Point_2(random_number<FT>(random), random_number<FT>(random)));
  for(const auto e : edges(model.mesh))
    put(model.feature_map, e, random() % 4 == 0);

  const std::string text = model.write();
  CHECK_EQUAL(text.substr(0, 27), "# a comment\n# of two lines\n");
  AnyModel again, once_more;
  CHECK(again.read(text));
  CHECK(content(again) == content(model));
  CHECK(once_more.read(again.write()));
  CHECK(content(once_more) == content(model));

  // what was written as float is the same number to a reader of doubles
  Surface_model as_double;
  CHECK(as_double.read(text));
  CHECK(content(as_double) == content(model));
}

// The same by streams, for libraries without conversions of floating point numbers.
template <typename FT>
void test_streams(Random& random)
{
  namespace internal = SS::internal;
  const auto read = [](const std::string& text)
  {
    FT value = 17;
    const auto result = internal::read_decimal_by_stream(std::string_view(text), value);
    return std::make_tuple(value, result.ec, std::size_t(result.ptr - text.data()));
  };
  for(int i = 0; i < 5000; ++i) {
    const FT x = random_number<FT>(random);
    const std::string text = internal::decimal_by_stream(x);
    std::string shortest;
    internal::append_decimal(shortest, double(x));
    for(const std::string& decimal : { text, shortest }) {
      const auto [value, error, length] = read(decimal + "x");
      CHECK_EQUAL(bits(value), bits(x));
      CHECK(error == std::errc() && length == decimal.size());
    }
  }
  const std::errc good = std::errc(), bad = std::errc::invalid_argument;
  const std::errc beyond = std::errc::result_out_of_range;
  for(const char* text : { "", "-", ".", "+1", "e5", "-.e5", "nan", "inf", "x1" })
    CHECK(std::get<1>(read(text)) == bad);
  for(const char* text : { "1e999", "-1e999", "123456789e400" })
    CHECK(std::get<1>(read(text)) == beyond);
  CHECK(read("1e-999") == std::make_tuple(FT(0), good, std::size_t(6)));
  CHECK(read("-5.") == std::make_tuple(FT(-5), good, std::size_t(3)));
  CHECK(read(".25e1") == std::make_tuple(FT(2.5), good, std::size_t(5)));
  CHECK(read("2e") == std::make_tuple(FT(2), good, std::size_t(1)));
  CHECK(read("2e+/3") == std::make_tuple(FT(2), good, std::size_t(1)));
  CHECK(read("1,5") == std::make_tuple(FT(1), good, std::size_t(1)));
}

// Decimals with few digits, where readers take a fast path, under all rounding modes of an interval
// computation, and decimals half way between two floats.
void test_rounding(Random& random)
{
  std::ostringstream os;
  os << "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  std::vector<double> expected = {1.00000005960464477539062500001, 1.0000000596046448};
  os << "vt 1.00000005960464477539062500001 1.0000000596046448\n";
  for(int i = 0; i < 2000; ++i) {
    const std::string token = std::to_string(random() % 1000000) + "."
                              + std::to_string(random() % 1000) + "e"
                              + std::to_string(static_cast<int>(random() % 40) - 20);
    expected.push_back(std::strtod(token.c_str(), nullptr));
    os << (i % 2 == 0 ? "vt " : " ") << token << (i % 2 == 0 ? "" : "\n");
  }
  const std::size_t n = expected.size() / 2;
  for(std::size_t i = 0; i < n; ++i)
    os << "v 0 0 " << i << "\nv 1 0 " << i << "\nv 0 1 " << i << "\n"
       << "f -1/" << i + 1 << " -2/" << i + 1 << " -3/" << i + 1 << '\n';

  for(const auto mode : {CGAL_FE_TONEAREST, CGAL_FE_UPWARD, CGAL_FE_DOWNWARD, CGAL_FE_TOWARDZERO}) {
    Surface_model model;
    Float_model floats;
    {
      const CGAL::Protect_FPU_rounding<true> rounding(mode);
      CHECK(model.read(os.str()));
      CHECK(floats.read(os.str()));
      CHECK(CGAL::FPU_get_cw() == static_cast<CGAL::FPU_CW_t>(mode));
    }
    std::size_t i = 0, differing = 0;
    for(const auto f : faces(model.mesh)) {
      const Kernel::Point_2 uv = get(model.uv_map, halfedge(f, model.mesh));
      differing += bits(uv.x()) != bits(expected[i]) ? 1 : 0;
      differing += bits(uv.y()) != bits(expected[i + 1]) ? 1 : 0;
      i += 2;
    }
    CHECK_EQUAL(i, expected.size());
    CHECK_EQUAL(differing, 0u);
    // the first is above the middle of 1 and the next float; so is its neighbor, the double
    const auto uv = get(floats.uv_map, halfedge(*faces(floats.mesh).begin(), floats.mesh));
    CHECK_EQUAL(uv.x(), std::nextafter(1.f, 2.f));
  }
}

// The corners of a file, read in the plainest way.
Content plainly_read(const std::string& filename)
{
  Content result;
  std::vector<std::array<double, 2> > uvs;
  std::ifstream is(filename);
  for(std::string line; std::getline(is, line); ) {
    std::istringstream tokens(line);
    std::string keyword, a, b, c;
    tokens >> keyword >> a >> b >> c;
    const std::array<std::string, 3> abc = {a, b, c};
    if(keyword == "v")
      for(const std::string& x : abc)
        result.points.push_back(bits(std::strtod(x.c_str(), nullptr)));
    else if(keyword == "vt")
      uvs.push_back({std::strtod(a.c_str(), nullptr), std::strtod(b.c_str(), nullptr)});
    else if(keyword == "l")
      result.features.push_back({(std::min)(std::stoul(a), std::stoul(b)) - 1,
                                 (std::max)(std::stoul(a), std::stoul(b)) - 1});
    else if(keyword == "f")
      for(const std::string& corner : abc) {
        const std::array<double, 2>& uv = uvs[std::stoul(corner.substr(corner.find('/') + 1)) - 1];
        result.triangles.push_back(std::stoul(corner) - 1);
        result.uvs.insert(result.uvs.end(), {bits(uv[0]), bits(uv[1])});
      }
  }
  std::sort(result.features.begin(), result.features.end());
  result.features.erase(std::unique(result.features.begin(), result.features.end()),
                        result.features.end());
  return result;
}

void test_file(const std::string& filename)
{
  Surface_model model, again;
  const SS::IO::File_status status =
    SS::IO::read_OBJ(filename, model.mesh, model.uv_map,
                     SS::parameters::edge_is_constrained_map(model.feature_map));
  bool good = CHECK(status);
  good = CHECK(content(model) == plainly_read(filename)) && good;
  good = CHECK(again.read(model.write())) && good;
  good = CHECK(content(again) == content(model)) && good;
  if(!good)
    std::cerr << "    " << filename << ": " << status << std::endl;
}

// A strip that is made of quadrangles; once they are split, its surface is the reason.
void test_quadrangles()
{
  const auto path =
      test_data::further_data("refused/gc_moebius_nonorientable.obj", "a Moebius strip");
  if(path.empty())
    return;
  std::ifstream is(path);
  std::string text, triangles;
  for(std::string line; std::getline(is, line); text += line + "\n") {
    std::istringstream tokens(line);
    std::string keyword, a, b, c, d;
    tokens >> keyword >> a >> b >> c >> d;
    triangles += d.empty() ? line + "\n"
                           : "f " + a + " " + b + " " + c + "\nf " + a + " " + c + " " + d + "\n";
  }
  CHECK_EQUAL(Surface_model().read(text).message,
              "line 566: face has 4 corners; triangulate the mesh first");
  const std::string message = Surface_model().read(triangles).message;
  if(!CHECK(message.find("the surface is not orientable") != message.npos))
    std::cerr << "    " << message << std::endl;
}

std::string mutated(std::string text, Random& random)
{
  static const std::vector<std::string> tokens =
    {"", "\n", "\r", "\\\n", "#", "/", "//", "-", "1", "0", "-1", "9999999999999999999999", "nan",
     "v", "vt", "f", "l", "1e999", "1/1", "f 1/1 2/2 3/3\n", " ", "\t", "\\", std::string(1, '\0')};
  const auto position = [&]() { return random() % (text.size() + 1); };
  for(std::uint64_t n = 1 + random() % 4; n > 0; --n) {
    const std::size_t i = position();
    const std::size_t length = random() % 12;
    switch(random() % 5) {
    case 0: if(i < text.size()) text[i] = static_cast<char>(random()); break;
    case 1: if(random() % 4 == 0) text.resize(i); break;
    case 2: text.insert(i, tokens[random() % tokens.size()]); break;
    case 3: text.erase(i, length); break;
    default: text.insert(position(), text.substr(i, length)); break;
    }
  }
  return text;
}

// Whatever is done to a file, it is refused with a line, or read as a mesh that is valid.
template <typename AnyModel>
void test_mutations(Random& random, std::size_t number)
{
  const std::string valid = "# a cylinder\n" + band(4, false)
                            + "v 3 3 3 # isolated\nl 1 2\nl 3 4 -4\n";
  CHECK(AnyModel().read(valid));
  std::size_t number_of_meshes = 0;
  for(std::size_t i = 0; i < number; ++i) {
    const std::string text = mutated(valid, random);
    AnyModel model, again;
    const SS::IO::File_status status = model.read(text);
    bool good = true;
    if(status) {
      ++number_of_meshes;
      good = CHECK(again.read(model.write())) && CHECK(content(again) == content(model))
             && CHECK(CGAL::is_triangle_mesh(model.mesh))
             && CHECK(is_valid_but_for_isolated_vertices(model.mesh));
    } else {
      const auto ends = std::count_if(text.begin(), text.end(),
                                      [](char c) { return c == '\n' || c == '\r'; });
      good = CHECK(num_vertices(model.mesh) == 0)
             && CHECK(status.line <= static_cast<std::size_t>(ends) + 1)
             && (status.line == 0
                   ? CHECK(status.message == "the file has no face")
                   : CHECK(status.message.find("line " + std::to_string(status.line) + ": ") == 0));
    }
    if(!good) {
      std::cerr << "    " << status << "\n" << text << std::endl;
      return;
    }
  }
  std::cout << number << " mutations: " << number_of_meshes << " meshes" << std::endl;
  CHECK(number_of_meshes > number / 20 && number_of_meshes < number - number / 20);
}

int main(int argc, char** argv)
{
  const std::uint64_t seed = argc > 1 ? std::stoull(argv[1]) : std::random_device()();
  std::cout << "seed " << seed << std::endl;
  Random random(seed);

  for(int i = 0; i < 5; ++i) {
    test_random_numbers<double, Surface_model>(random);
    test_random_numbers<double, Polyhedron_model>(random);
    test_random_numbers<float, Float_model>(random);
  }
  test_streams<double>(random);
  test_streams<float>(random);
  test_rounding(random);
  for(const auto& path : test_data::package_files())
    test_file(path.string());
  for(const auto& path : test_data::further_files("uv", ".obj"))
    test_file(path.string());
  test_quadrangles();
  test_mutations<Surface_model>(random, 20000);
  test_mutations<Polyhedron_model>(random, 5000);
  return report_checks();
}
