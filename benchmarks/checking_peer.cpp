// SPDX-License-Identifier: GPL-3.0-or-later
// The peer of checking: the time in which CGAL builds the Delaunay tetrahedralization of a certificate's points over doubles, with its
// inexact-constructions kernel (which decides nothing about the exact points; it is the cheapest construction there is).
// usage: checking-peer FILE.cert. Prints points and seconds. Reads the text form, dyadic points only.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gmpxx.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

int main(int count, char** arguments) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  if (count != 2) return 2;
  std::ifstream file(arguments[1]);
  if (!file) return 4;
  std::vector<Kernel::Point_3> points;
  for (std::string line; std::getline(file, line);) {
    const bool vertex = line.rfind("v ", 0) == 0, steiner = line.rfind("q ", 0) == 0;
    if (!vertex && !steiner) continue;
    std::istringstream fields(line);
    std::string word;
    for (int skip = vertex ? 1 : 3; skip > 0; --skip) fields >> word;
    mpz_class number[4];
    for (auto& value : number) {
      fields >> word;
      value.set_str(word, 16);
    }
    double coordinate[3];
    for (int axis = 0; axis < 3; ++axis) coordinate[axis] = mpq_class(number[axis], number[3]).get_d();
    points.emplace_back(coordinate[0], coordinate[1], coordinate[2]);
  }
  const auto start = std::chrono::steady_clock::now();
  const CGAL::Delaunay_triangulation_3<Kernel> triangulation(points.begin(), points.end());
  std::printf("%zu %.6f\n", points.size(), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return triangulation.number_of_vertices() > 0 ? 0 : 1;
}
