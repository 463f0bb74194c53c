// SPDX-License-Identifier: GPL-3.0-or-later
// Just enough of a certificate for an oracle: its complex and its points. Cells are not read.
#pragma once

#include <array>
#include <fstream>

#include "tests/core/complex/canonical_reader.h"

namespace confidel::test {

struct CertifiedPoints {
  CanonicalComplex complex;
  std::vector<Rational3> points;
};

/// Pre: an uncompressed certificate of correct spelling.
inline CertifiedPoints read_certificate(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::size_t begin = text.find("plc 1\n"), end = text.find("\nclaims ");
  require(begin != std::string::npos && end != std::string::npos, "is in the certificate " + path);
  CertifiedPoints result;
  result.complex = CanonicalReader(text.substr(begin, end + 1 - begin)).read();
  result.points = result.complex.vertices;
  std::istringstream lines(text.substr(end));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string word, kind, carrier, number;
    fields >> word >> kind >> carrier;
    if (word != "q") continue;
    std::vector<mpz_class> values;
    while (fields >> number) values.emplace_back(number, 16);
    Rational3 point{0, 0, 0};
    for (std::size_t axis = 0; axis + 1 < values.size(); ++axis) {
      point[axis] = mpq_class(values[axis], values.back());
      point[axis].canonicalize();
    }
    result.points.push_back(point);
  }
  return result;
}

}  // namespace confidel::test
