// SPDX-License-Identifier: GPL-3.0-or-later
// The certificates of tests/certificates, read by the product's reader; what it measures against plain rational arithmetic.
#include "proofs/certificate/reader.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "proofs/certificate/clearance.h"

using namespace confidel;
namespace fs = std::filesystem;

namespace {

const fs::path certificates = fs::path(CONFIDEL_SOURCE_DIR) / "tests" / "certificates";

std::vector<fs::path> files(const char* folder) {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(certificates / folder))
    if (entry.path().extension() == ".cert") result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  BOOST_TEST_REQUIRE(!result.empty());
  return result;
}

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// code:line:column of what is wrong, or "".
std::string problem(const std::string& text) {
  try {
    parse_certificate("x", text);
  } catch (const InputError& error) {
    const Problem& first = error.problems.front();
    return first.code + ":" + std::to_string(first.place.line) + ":" + std::to_string(first.place.column);
  }
  return "";
}

using Vector = std::array<mpq_class, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
mpq_class scalar(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector times(const Vector& a, const Vector& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
Vector position(const Certificate& certificate, int point) {
  return {certificate.points[point].coordinate(0), certificate.points[point].coordinate(1), certificate.points[point].coordinate(2)};
}

/// The centre solves the three linear equations |z-a|^2 = |z-b|^2 = |z-c|^2, n.(z-a) = t n.n': Cramer's rule.
Vector centre(const Certificate& certificate, const CertificateCell& cell) {
  const Vector a = position(certificate, cell.corners[0]), u = minus(position(certificate, cell.corners[1]), a), v = minus(position(certificate, cell.corners[2]), a), n = times(u, v);
  const auto& frame = certificate.facets[cell.facet].frame;
  const Vector origin = position(certificate, frame[0]);
  const Vector normal = times(minus(position(certificate, frame[1]), origin), minus(position(certificate, frame[2]), origin));
  const mpq_class right[3] = {scalar(u, u) / 2, scalar(v, v) / 2, cell.offset * scalar(n, normal)};
  const mpq_class determinant = scalar(u, times(v, n));
  const Vector vn = times(v, n), nu = times(n, u), uv = times(u, v);
  Vector z;
  for (int axis = 0; axis < 3; ++axis) z[axis] = a[axis] + (right[0] * vn[axis] + right[1] * nu[axis] + right[2] * uv[axis]) / determinant;
  return z;
}

void compare_with_plain_arithmetic(const Certificate& certificate, const std::string& name) {
  const auto measured = clearances(certificate, approximate_positions(certificate), {});
  BOOST_TEST_REQUIRE(measured.size() == certificate.cells.size());
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const CertificateCell& cell = certificate.cells[i];
    if (measured[i].degenerate) continue;
    // An offset from a plane that the corners are not in is no sphere through them.
    const auto& frame = certificate.facets[cell.facet].frame;
    const auto on_plane = [&](int corner) {
      const Vector origin = position(certificate, frame[0]);
      const Vector normal = times(minus(position(certificate, frame[1]), origin), minus(position(certificate, frame[2]), origin));
      return scalar(normal, minus(position(certificate, corner), origin)) == 0;
    };
    if (cell.offset != 0 && !std::all_of(cell.corners.begin(), cell.corners.end(), on_plane)) continue;
    const Vector a = position(certificate, cell.corners[0]), z = centre(certificate, cell);
    const Vector n = times(minus(position(certificate, cell.corners[1]), a), minus(position(certificate, cell.corners[2]), a));
    const mpq_class radius_square = scalar(minus(a, z), minus(a, z));
    std::vector<int> box_corners;
    for (const CertificateCell& other : certificate.cells)
      if (cell.box >= 0 && other.box == cell.box) box_corners.insert(box_corners.end(), other.corners.begin(), other.corners.end());
    Nearest all, off_plane;
    for (int p = 0; p < static_cast<int>(certificate.points.size()); ++p) {
      if (std::find(cell.corners.begin(), cell.corners.end(), p) != cell.corners.end()) continue;
      const Vector x = position(certificate, p);
      const mpq_class power = scalar(minus(x, z), minus(x, z)) / radius_square - 1;
      const bool tied_box = power == 0 && std::find(box_corners.begin(), box_corners.end(), p) != box_corners.end();
      if (!tied_box && (all.point < 0 || power < all.relative_power)) all = {p, power};
      if (certificate.dimension == 3 && scalar(n, minus(x, a)) != 0 && (off_plane.point < 0 || power < off_plane.relative_power)) off_plane = {p, power};
    }
    BOOST_TEST(measured[i].all.point == all.point, name << ", cell " << i);
    BOOST_TEST(measured[i].off_plane.point == off_plane.point, name << ", cell " << i);
    BOOST_TEST((all.point < 0 || measured[i].all.relative_power == all.relative_power), name << ", cell " << i);
    BOOST_TEST((off_plane.point < 0 || measured[i].off_plane.relative_power == off_plane.relative_power), name << ", cell " << i);
    BOOST_TEST(std::abs(measured[i].radius * measured[i].radius / radius_square.get_d() - 1) < 1e-12, name << ", cell " << i);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(certificate_reader)

BOOST_AUTO_TEST_CASE(the_worked_example) {
  for (const char* file : {"worked-example.cert", "worked-example-raw-zstd.cert"}) {
    const Certificate certificate = read_certificate(certificates / "accept" / file);
    BOOST_TEST(certificate.dimension == 3);
    BOOST_TEST(certificate.points.size() == 7U);
    BOOST_TEST(certificate.vertex_count == 5);
    BOOST_TEST(certificate.segments.size() == 4U);
    BOOST_TEST(certificate.facets.at(0).boundary.size() == 3U);
    BOOST_TEST((certificate.kinds[5] == PointKind::interior && certificate.kinds[6] == PointKind::edge && certificate.carriers[6] == 3));
    BOOST_TEST(certificate.cells.at(2).offset == mpq_class(-1, 100));
    BOOST_TEST(certificate.cells.at(0).line == 33);
    BOOST_TEST(certificate.hanging.size() == 2U);
    BOOST_TEST(certificate.claims.at(0).text == "claim conforms");
    BOOST_TEST(certificate.note("strategy") == "by hand");
    BOOST_TEST(certificate.complex_sha256 == "680b430c4cf762c7e9ef3d597ce3704f7f45f3f7269fa1723b5d7f076d1ad8e3");
    BOOST_TEST(certificate.digest_matches);
  }
}

BOOST_AUTO_TEST_CASE(what_checkers_accept_or_reject_is_read) {
  for (const char* folder : {"accept", "reject"})
    for (const fs::path& path : files(folder)) BOOST_CHECK_NO_THROW(read_certificate(path));
}

BOOST_AUTO_TEST_CASE(what_is_no_certificate_is_refused_or_its_spelling_is_believed) {
  // Order, lowest terms and claims are the checkers' business; what has the wrong shape is not read.
  std::size_t refused = 0, all = 0;
  for (const char* folder : {"malformed", "decline"})
    for (const fs::path& path : files(folder)) {
      ++all;
      try {
        read_certificate(path);
      } catch (const InputError& error) {
        ++refused;
        BOOST_TEST(error.problems.front().code.substr(0, 2) == "E-");
      }
    }
  BOOST_TEST(refused * 2 >= all, refused << " of " << all);
}

BOOST_AUTO_TEST_CASE(errors_have_their_place) {
  const std::string good = content(certificates / "accept" / "worked-example.cert");
  BOOST_TEST(problem(good) == "");
  const auto spoilt = [&](const std::string& what, const std::string& with) {
    std::string text = good;
    const std::size_t at = text.find(what);
    BOOST_TEST_REQUIRE(at != std::string::npos);
    return problem(text.replace(at, what.size(), with));
  };
  BOOST_TEST(spoilt("t 0 1 2 5 C", "t 0 1 2 7 C") == "E-RANGE:34:9");
  BOOST_TEST(spoilt("t 0 1 2 5 C", "t 0 1 2 5 D") == "E-SYNTAX:34:11");
  BOOST_TEST(spoilt("q edge 3 1 1 7 1", "q edge 3 1 1 7 0") == "E-VALUE:31:16");
  BOOST_TEST(spoilt("q edge 3 1 1 7 1", "q edge 3 1 1 7") == "E-SYNTAX:31:15");
  BOOST_TEST(spoilt("cells 3", "cells 2") == "E-SYNTAX:35:1");
  BOOST_TEST(spoilt("end 5 4", "end 5 5") == "E-COUNT:41:7");
  BOOST_TEST(problem(good + "x\n") == "E-TRAILING:42:1");
  BOOST_TEST(problem("") == "E-TRUNCATED:1:1");
  std::string no_digest = good;
  no_digest[good.size() - 2] = no_digest[good.size() - 2] == '0' ? '1' : '0';
  BOOST_TEST(!parse_certificate("x", no_digest).digest_matches);
}

BOOST_AUTO_TEST_CASE(cut_anywhere_it_is_refused) {
  const std::string good = content(certificates / "accept" / "rows-boxes.cert");
  for (std::size_t length = 0; length < good.size(); ++length) BOOST_TEST(problem(good.substr(0, length)) != "");
}

BOOST_AUTO_TEST_CASE(coordinates_are_nearest_doubles) {
  HomogeneousPoint point;
  point.numerator = {1, mpz_class(1) << 2000, -7};
  point.denominator = 3;
  BOOST_TEST(point.approximate(0) == 1.0 / 3);
  BOOST_TEST(std::isinf(point.approximate(1)));
  BOOST_TEST(point.approximate(2) == -7.0 / 3);
  BOOST_TEST(point.coordinate(2) == mpq_class(-7, 3));
}

BOOST_AUTO_TEST_CASE(powers_are_those_of_plain_arithmetic) {
  std::size_t cells = 0;
  for (const char* folder : {"accept", "reject"})
    for (const fs::path& path : files(folder)) {
      const Certificate certificate = read_certificate(path);
      cells += certificate.cells.size();
      if (certificate.dimension == 2 || !certificate.cells.empty()) compare_with_plain_arithmetic(certificate, path.filename());
    }
  BOOST_TEST(cells > 100U);
}

BOOST_AUTO_TEST_CASE(violations_are_seen) {
  const std::string good = content(certificates / "accept" / "worked-example.cert");
  std::string bad = good;
  bad.replace(bad.find("v 1 1 5 1"), 9, "v 1 1 1 2");  // into the smallest sphere of the first cell
  const auto violated = [](const std::string& text) {
    const Certificate certificate = parse_certificate("x", text);
    std::size_t count = 0;
    for (const CellClearance& cell : clearances(certificate, approximate_positions(certificate), {})) count += cell.violated();
    return count;
  };
  BOOST_TEST(violated(good) == 0U);
  BOOST_TEST(violated(bad) > 0U);
}

BOOST_AUTO_TEST_SUITE_END()
