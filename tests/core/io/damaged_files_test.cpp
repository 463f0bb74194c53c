// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever happens to a good file: it is read, or refused with an InputError. Never a crash, never an index out of
// range.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "core/io/source.h"
#include "tests/core/io/binary_file.h"

using namespace confidel;

namespace {

const std::string nodes = "4 3 1 1\n0 0 0 0 .5 1\n1 1 0 0 .5 1\n2 0 1 0 .5 1\n3 0 0 1 .5 1\n";

std::string binary_stl() {
  test::BinaryFile file(std::string(80, 'x'));
  file.integer(2, 4);
  for (int triangle = 0; triangle < 2; ++triangle) {
    for (int i = 0; i < 12; ++i) file.real32(static_cast<float>(i * (triangle + 1) % 5));
    file.integer(0, 2);
  }
  return file.bytes();
}

std::string binary_ply(bool big_endian) {
  test::BinaryFile file(std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                            "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
                            "element face 2\nproperty list uchar int vertex_indices\nproperty list int float t\n"
                            "element edge 1\nproperty int vertex1\nproperty uint vertex2\nend_header\n",
                        big_endian);
  for (int i = 0; i < 3; ++i) file.real64(i).real32(static_cast<float>(i * i)).integer(1, 2);
  for (int i = 0; i < 2; ++i) {
    file.integer(3, 1).integer(0, 4).integer(1, 4).integer(2, 4).integer(2, 4).real32(1).real32(0);
  }
  file.integer(0, 4).integer(2, 4);
  return file.bytes();
}

struct Good {
  const char* name;
  Input (*read)(const io::Source&);
  std::string text;
};

const std::vector<Good>& good_files() {
  static const std::vector<Good> files{
      {"planar .poly", io::read_poly,
       "4 2 0 1\n1 0 0 1\n2 4 0 1\n3 4 4 1\n4 0 4 1\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n1\n1 3 1\n1\n1 1 2 3 "
       "4\n"},
      {".poly", io::read_poly,
       nodes + "2 1\n3 1 5\n3 0 1 2\n2 0\n 1\n1 2\n0 .1 .1 0\n1 0 6 # x\n3 0 1 3\n1\n0 9 9 9\n1\n0 .1 .1 .1 5 -1\n"},
      {".smesh", io::read_smesh, nodes + "3 1\n3 0 1 2 1\n3 0 1\n 3 -2\n2 2 3 0\n0\n0\n"},
      {".off", io::read_off,
       "CNOFF # x\n3 2\n0 0 0 0 0 1 1 1 1 1\n1 0 0 0 0 1 1 1 1 1\n0 1 0 0 0 1 1 1 1\n3 0 1 2 7\n2 0 1\n"},
      {".obj", io::read_obj,
       "o a\nv 0 0 0\nv 1 0 0 1\nv 0 1 0 1 1 1\ng b c\nf 1/1 2//3 \\\n 3/4/5\nl -1 -2 1\ns off\n"},
      {".edg", io::read_edg, "3\n0 0 1 0\n1 0 0 1\n0 1 0 1\n"},
      {".stl", io::read_stl,
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
       "endsolid\nsolid b\nendsolid\n"},
      {"binary .stl", io::read_stl, binary_stl()},
      {".ply", io::read_ply,
       "ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
       "element face 2\nproperty list uchar int vertex_index\nproperty int t\nelement edge 1\nproperty int vertex1\n"
       "property int vertex2\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 9\n2 0 1 9\n1 2\n"},
      {"binary .ply, little endian", io::read_ply, binary_ply(false)},
      {"binary .ply, big endian", io::read_ply, binary_ply(true)},
      {".mesh", io::read_medit,
       "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n1 1 0 0\nTriangles 1\n1 2 3 1\n"
       "Quadrilaterals 1\n1 2 4 3 2\nEdges 1\n1 4 3\nCorners 1\n1\nEnd\n"}};
  return files;
}

bool is_sound(const Input& input) {
  const int count = static_cast<int>(input.vertices.size());
  const auto exists = [&](int vertex) { return vertex >= 0 && vertex < count; };
  for (const InputVertex& vertex : input.vertices) {
    for (const double x : vertex.position) {
      if (!std::isfinite(x) || (x == 0 && std::signbit(x))) return false;
    }
    if (input.dimension == 2 && vertex.position[2] != 0) return false;
  }
  for (const InputFacet& facet : input.facets) {
    if (facet.polygons.empty()) return false;
    for (const InputPolygon& polygon : facet.polygons) {
      if (polygon.corners.empty()) return false;
      for (const int corner : polygon.corners) {
        if (!exists(corner)) return false;
      }
    }
  }
  for (const InputSegment& segment : input.segments) {
    if (!exists(segment.ends[0]) || !exists(segment.ends[1])) return false;
  }
  return input.dimension == 2 ? input.facets.empty() : input.dimension == 3;
}

enum class Outcome { read, refused };

Outcome try_to_read(const Good& good, const std::string& text) {
  try {
    const Input input = good.read({"/nowhere/damaged", text});
    BOOST_REQUIRE_MESSAGE(is_sound(input), good.name << " gives an unsound input");
    return Outcome::read;
  } catch (const InputError& error) {
    BOOST_REQUIRE(!error.problems.empty());
    for (const Problem& problem : error.problems) {
      BOOST_REQUIRE(problem.code.starts_with("E-") && !problem.message.empty() && !problem.place.file.empty());
      BOOST_REQUIRE(problem.place.line >= 0 && problem.place.column >= 0);
    }
  } catch (const FileError&) {
    // Zero vertices: the companion is missing.
  }
  return Outcome::refused;
}

class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  std::string apply(std::string text) {
    const std::size_t times = 1 + below(3);
    for (std::size_t i = 0; i < times && !text.empty(); ++i) text = once(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }

  std::string once(std::string text) {
    static const char* const nasty[] = {"2147483647",
                                        "2147483648",
                                        "-1",
                                        "0",
                                        "1e400",
                                        "nan",
                                        "#",
                                        "\n",
                                        "\r",
                                        " ",
                                        "\\",
                                        "/",
                                        "//",
                                        "0x10",
                                        "",
                                        "\"",
                                        "1 1 1",
                                        "\xEF\xBB\xBF",
                                        "99999999999999999999",
                                        "End",
                                        "v",
                                        "OFF",
                                        "."};
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2:
        text[at] = static_cast<char>(below(256));
        break;
      case 3: {  // A field becomes something nasty.
        const std::size_t begin = text.find_last_of(" \n", at) + 1;
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        text.replace(begin, std::max(begin, end) - begin, nasty[below(std::size(nasty))]);
        break;
      }
      case 4: {  // A line vanishes.
        const std::size_t begin = text.find_last_of('\n', at) + 1;
        text.erase(begin, std::min(text.find('\n', begin), text.size()) - begin);
        break;
      }
      default:  // A piece comes twice.
        text.insert(at, text.substr(below(text.size()), below(20)));
    }
    return text;
  }

  std::mt19937_64 random_;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(io_damaged_files)

BOOST_AUTO_TEST_CASE(undamaged) {
  for (const Good& good : good_files()) BOOST_CHECK_MESSAGE(try_to_read(good, good.text) == Outcome::read, good.name);
}

BOOST_AUTO_TEST_CASE(truncated_anywhere) {
  for (const Good& good : good_files()) {
    for (std::size_t size = 0; size < good.text.size(); ++size) try_to_read(good, good.text.substr(0, size));
  }
}

BOOST_AUTO_TEST_CASE(damaged_at_random) {
  const char* variable = std::getenv("CONFIDEL_SOAK");  // a multiplier
  const int times = 1500 * (variable != nullptr ? std::max(1, std::atoi(variable)) : 1);
  for (const Good& good : good_files()) {
    int refused = 0;
    for (int i = 0; i < times; ++i) {
      BOOST_TEST_CONTEXT(good.name << ", seed " << i) {
        refused +=
            try_to_read(good, Damage(static_cast<std::uint64_t>(i)).apply(good.text)) == Outcome::refused ? 1 : 0;
      }
    }
    BOOST_TEST(refused > times / 10, good.name << ": the damage does no harm");
  }
}

BOOST_AUTO_TEST_CASE(mistaken_for_another_format) {
  for (const Good& reader : good_files()) {
    for (const Good& file : good_files()) try_to_read(reader, file.text);
  }
}

BOOST_AUTO_TEST_SUITE_END()
