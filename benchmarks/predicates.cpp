// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds per predicate (Google Benchmark): clear cases, which the filter decides; ties, which only integers decide; and points as refinement makes
// them, with a hundred bits. CGAL's predicates on the same doubles beside them, where the points are doubles.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "core/numbers/predicates.h"

namespace {

using confidel::Point;
using Coordinates = std::array<double, 3>;

enum Kind { clear, tie, long_tie };
constexpr std::array<const char*, 3> kind_names{"clear", "tie", "tie, 100 bits"};
constexpr std::size_t sets = 1024;

// Five points: corners of one box for ties (cospherical, with flat faces), random ones otherwise.
std::vector<std::array<Coordinates, 5>> coordinates(Kind kind) {
  std::mt19937_64 words(7);
  const auto number = [&] { return static_cast<double>(words() >> 11) * 0x1p-53; };
  std::vector<std::array<Coordinates, 5>> result(sets);
  for (auto& set : result) {
    if (kind == clear) {
      for (auto& p : set)
        for (double& x : p) x = number();
      continue;
    }
    const double shift = static_cast<double>(words() >> 40), size = 1 + static_cast<double>(words() >> 60);
    const std::array<std::array<int, 3>, 5> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}}};
    for (int i = 0; i < 5; ++i)
      for (int axis = 0; axis < 3; ++axis) set[i][axis] = shift + size * corners[i][axis];
  }
  return result;
}

std::vector<std::array<Point, 5>> points(Kind kind) {
  std::vector<std::array<Point, 5>> result;
  // All of a set moved by one vector with a hundred bits: ties stay ties.
  const mpz_class far = (mpz_class(1) << 100) / 3;
  for (const auto& set : coordinates(kind == long_tie ? tie : kind)) {
    result.emplace_back();
    for (int i = 0; i < 5; ++i) {
      const Point p = Point::from_doubles(set[i][0], set[i][1], set[i][2]);
      result.back()[i] = p;
      if (kind != long_tie) continue;
      std::array<mpz_class, 3> moved;
      for (int axis = 0; axis < 3; ++axis) moved[axis] = (p.numerator(axis) << (100 - p.exponent())) + far;
      result.back()[i] = Point(moved[0], moved[1], moved[2], 100);
    }
  }
  return result;
}

template <class Sets, class Predicate>
void measure(benchmark::State& state, const Sets& inputs, Predicate predicate) {
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(predicate(inputs[i++ % sets]));
}

template <class Kernel>
std::vector<std::array<typename Kernel::Point_3, 5>> peer_points(Kind kind) {
  std::vector<std::array<typename Kernel::Point_3, 5>> result(sets);
  const auto given = coordinates(kind);
  for (std::size_t s = 0; s < sets; ++s)
    for (int i = 0; i < 5; ++i) result[s][i] = typename Kernel::Point_3(given[s][i][0], given[s][i][1], given[s][i][2]);
  return result;
}

template <class Kernel>
void peer(const std::string& name, Kind kind) {
  const auto add = [&](const char* predicate, auto function) {
    benchmark::RegisterBenchmark((std::string(predicate) + "/" + kind_names[kind] + "/" + name).c_str(),
                                 [kind, function](benchmark::State& state) { measure(state, peer_points<Kernel>(kind), function); });
  };
  add("orientation", [](const auto& p) { return CGAL::orientation(p[0], p[1], p[2], p[3]); });
  add("diametral power, triangle", [](const auto& p) { return CGAL::side_of_bounded_sphere(p[0], p[1], p[2], p[3]); });
  add("in sphere", [](const auto& p) { return CGAL::side_of_oriented_sphere(p[0], p[1], p[2], p[4], p[3]); });
}

void own(Kind kind) {
  const auto add = [&](const char* predicate, auto function) {
    benchmark::RegisterBenchmark((std::string(predicate) + "/" + kind_names[kind] + "/confidel").c_str(),
                                 [kind, function](benchmark::State& state) { measure(state, points(kind), function); });
  };
  add("orientation", [](const auto& p) { return confidel::orientation(p[0], p[1], p[2], p[3]); });
  add("diametral power, triangle", [](const auto& p) { return confidel::diametral_power(p[0], p[1], p[2], p[3]); });
  add("in sphere", [](const auto& p) { return confidel::in_sphere(p[0], p[1], p[2], p[4], p[3]); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const Kind kind : {clear, tie, long_tie}) own(kind);
  for (const Kind kind : {clear, tie}) {
    peer<CGAL::Exact_predicates_inexact_constructions_kernel>("CGAL, doubles", kind);
    peer<CGAL::Exact_predicates_exact_constructions_kernel>("CGAL, exact", kind);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
