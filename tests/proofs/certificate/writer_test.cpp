// SPDX-License-Identifier: GPL-3.0-or-later
// From random complexes to the checker program's verdict, and placements that it must not accept.
#include "proofs/certificate/writer.h"

#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>

#include "tests/support/certificate_reader.h"
#include "tests/support/placing.h"
#include "tests/support/random_inputs.h"
#include "tests/support/rationals.h"

using namespace confidel;
using namespace confidel::test;
namespace fs = std::filesystem;

namespace {

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("confidel-writer-" + std::to_string(getpid()))) { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ / name; }
  std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), fs::directory_iterator())); }

 private:
  fs::path path_;
};

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

CertificateSummary write(const Folder& folder, const std::string& name, const Complex& complex, const Placement& placement) {
  return write_certificate(folder / name, folder / (name + ".partial"), complex, placement, {{"strategy", "of a test"}, {"seed", "1"}});
}

/// The checker program's exit code and last line.
std::pair<int, std::string> verdict(const Folder& folder, const std::string& name, const Complex& complex) {
  std::ofstream(folder / "complex.plc", std::ios::binary) << canonical_text(complex);
  const std::string command = std::string(CONFIDEL_BINARY_DIR "/confidel-check ") + (folder / name) + " --quiet --threads 1 --complex " + (folder / "complex.plc") + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char buffer[256];
  while (pipe != nullptr && fgets(buffer, sizeof buffer, pipe) != nullptr) text += buffer;
  const int status = pclose(pipe);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

long rounds() {
  const char* factor = std::getenv("CONFIDEL_ROUNDS");
  return 60 * (factor != nullptr ? std::atol(factor) : 1);
}

Placement small_placement(Complex& complex) {
  complex = build_complex(triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 7}, {10, 10, -14}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})).complex;
  return place(complex, Strategy::graded);
}

int first_of(const Placement& placement, PointKind kind) {
  for (std::size_t i = 0; i < placement.points.size(); ++i)
    if (placement.points[i].kind == kind) return static_cast<int>(i);
  BOOST_FAIL("no such point");
  return -1;
}

/// The rule that the checker names for a placement that somebody has spoilt.
template <class Change>
std::string rule_after(Change change) {
  Complex complex;
  Placement placement = small_placement(complex);
  // Claims about lemmas would be named in place of the rules that they rest on.
  placement.claims.clear();
  placement.parameters = {};
  change(placement, complex);
  const Folder folder;
  write(folder, "spoilt.cert", complex, placement);
  const auto [code, line] = verdict(folder, "spoilt.cert", complex);
  if (code != 5 || line.rfind("s REJECTED ", 0) != 0) return std::to_string(code) + " " + line;
  return line.substr(11, line.find(' ', 11) - 11);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(writer)

BOOST_AUTO_TEST_CASE(random_complexes_are_verified) {
  // Every input is made from one 64-bit seed; CONFIDEL_ROUNDS multiplies their number.
  const Folder folder;
  long graded = 0, lean = 0;
  for (long round = 0; round < rounds(); ++round) {
    const std::uint64_t seed = 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(round + 1);
    const NamedInput named = random_input(seed);
    const Complex complex = build_complex(named.input).complex;
    for (const Strategy strategy : {Strategy::graded, Strategy::lean}) {
      Placement placement;
      try {
        placement = place(complex, strategy, 4000);
      } catch (const LimitReached&) {
        continue;
      }
      write(folder, "random.cert", complex, placement);
      const auto [code, line] = verdict(folder, "random.cert", complex);
      BOOST_TEST((code == 0 && line == "s VERIFIED"), name_of(strategy) << ", " << named.name << ": " << code << " " << line);
      ++(strategy == Strategy::graded ? graded : lean);
    }
  }
  BOOST_TEST_MESSAGE(graded << " graded, " << lean << " lean");
  BOOST_TEST(graded * 10 >= rounds() * 7);
  BOOST_TEST(lean * 10 >= rounds() * 9);
}

BOOST_AUTO_TEST_CASE(small_inputs_are_verified) {
  const Folder folder;
  for (const NamedInput& named : small_inputs()) {
    const Complex complex = build_complex(named.input).complex;
    for (const Strategy strategy : {Strategy::graded, Strategy::lean}) {
      write(folder, "small.cert", complex, place(complex, strategy));
      const auto [code, line] = verdict(folder, "small.cert", complex);
      BOOST_TEST((code == 0 && line == "s VERIFIED"), name_of(strategy) << ", " << named.name << ": " << code << " " << line);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_text_says_what_the_placement_is) {
  const Folder folder;
  for (const NamedInput& named : small_inputs()) {
    const Complex complex = build_complex(named.input).complex;
    const Placement placement = place(complex, Strategy::graded);
    const CertificateSummary summary = write(folder, "a.cert", complex, placement);
    const std::string text = content(folder / "a.cert");
    BOOST_TEST(summary.text_bytes == text.size());
    BOOST_TEST(summary.file_bytes == text.size());
    BOOST_TEST(summary.complex_sha256 == sha256(canonical_text(complex)));
    BOOST_TEST(text.find(canonical_text(complex)) != std::string::npos);
    BOOST_TEST(text.find("\nn strategy of a test\n") != std::string::npos);
    const std::size_t end = text.rfind("\nend ") + 1;
    BOOST_TEST(text.substr(text.rfind(' ') + 1) == sha256(text.substr(0, end)) + "\n");
    const CertifiedPoints read = read_certificate(folder / "a.cert");
    BOOST_REQUIRE(read.points.size() == placement.points.size());
    for (std::size_t i = 0; i < read.points.size(); ++i) BOOST_TEST((read.points[i] == rational(placement.points[i].position.scaled(complex.scale))));
    write(folder, "b.cert", complex, placement);
    BOOST_TEST((content(folder / "b.cert") == text));
    const CertificateSummary packed = write(folder, "c.cert.zst", complex, placement);
    BOOST_TEST(packed.text_bytes == text.size());
    BOOST_TEST(packed.file_bytes == fs::file_size(folder / "c.cert.zst"));
    BOOST_TEST(verdict(folder, "c.cert.zst", complex).second == "s VERIFIED");
  }
  BOOST_TEST(folder.files() == 4);  // three certificates and the complex: no partial files
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_written) {
  const Folder folder;
  Complex complex;
  const Placement placement = small_placement(complex);
  BOOST_CHECK_THROW(write_certificate(folder / "no/a.cert", folder / "no/a.partial", complex, placement, {}), FileError);
  fs::create_directories(folder / "taken.cert/inside");
  BOOST_CHECK_THROW(write_certificate(folder / "taken.cert", folder / "taken.partial", complex, placement, {}), FileError);
  BOOST_TEST(folder.files() == 1);
}

BOOST_AUTO_TEST_CASE(spoilt_placements_are_rejected) {
  BOOST_TEST(rule_after([](Placement& p, const Complex&) { p.cells.pop_back(); }) == "tiling");
  BOOST_TEST(rule_after([](Placement& p, const Complex&) { p.cells.push_back(p.cells.back()); }) == "tiling");
  BOOST_TEST(rule_after([](Placement& p, const Complex&) { std::swap(p.cells.back().corners[0], p.cells.back().corners[1]); }) == "cell");
  const auto move = [](Placement& p, int id, const IntegerVector& direction, int exponent) {
    p.points[id].position = translate(p.points[id].position, {1, exponent}, direction);
  };
  // Off the plane by 2^-200; off the line; beyond the end of the segment; onto another point.
  BOOST_TEST(rule_after([&](Placement& p, const Complex& c) {
    const int id = first_of(p, PointKind::interior);
    move(p, id, c.facets[p.points[id].carrier].normal, 200);
  }) == "carrier");
  BOOST_TEST(rule_after([&](Placement& p, const Complex&) { move(p, first_of(p, PointKind::projection), {0, 0, 1}, 200); }) == "carrier");
  BOOST_TEST(rule_after([&](Placement& p, const Complex& c) {
    const int id = first_of(p, PointKind::edge);
    const auto [a, b] = c.segments[p.points[id].carrier];
    p.points[id].position = along(c.vertices[a], c.vertices[b], {3, 1});
  }) == "carrier");
  BOOST_TEST(rule_after([&](Placement& p, const Complex&) { p.points.back().position = p.points[0].position; }) == "distinct");
  // A rectangle that is none by 2^-100: its row has one point out of place within the plane.
  BOOST_TEST(rule_after([&](Placement& p, const Complex& c) {
    const int id = first_of(p, PointKind::offset);
    const auto& frame = c.facets[p.points[id].carrier].frame;
    move(p, id, direction(c.vertices[frame[0]], c.vertices[frame[1]]), 100);
  }) == "box");
  // A sphere that is moved far along its normal contains the points on that side.
  BOOST_TEST(rule_after([](Placement& p, const Complex&) {
    for (auto& cell : p.cells)
      if (cell.kind == CellKind::C) cell.offset = mpq_class(1000);
  }) == "emptiness");
  // The cells of graded without what graded placed: vertices only.
  BOOST_TEST(rule_after([](Placement& p, const Complex& c) {
    p = Placement();
    for (const Point& v : c.vertices) p.points.push_back({v, PointKind::vertex, -1});
    for (std::size_t f = 0; f < c.facets.size(); ++f)
      for (const auto& t : c.facets[f].triangles) p.cells.push_back({static_cast<FacetId>(f), t, CellKind::C, -1, {}});
  }) == "emptiness");
}

BOOST_AUTO_TEST_SUITE_END()
