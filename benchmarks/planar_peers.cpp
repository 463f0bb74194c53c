// SPDX-License-Identifier: GPL-3.0-or-later
// Planar inputs, side by side in one process: Confidel's strategies and CGAL's Mesh_2 conformers, over CGAL's exact kernel and over doubles.
// Prints per input the Steiner points and the seconds of each, and at the end the medians of the ratios. Times are of placing only.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_conformer_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/complex/build.h"
#include "core/features/features.h"
#include "core/io/read.h"
#include "core/placement/graded.h"
#include "core/placement/lean.h"
#include "core/placement/saalfeld.h"

namespace {

using namespace confidel;

class Silent : public Progress {
 public:
  void at(const char*, long) override {}
  bool stop_requested(long) override { return false; }
  void estimated(double) override {}
};

struct Outcome {
  double points = NAN, seconds = NAN;
};

Outcome timed(const std::function<double()>& work) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome;
  try {
    outcome.points = work();
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  } catch (const std::exception&) {
  }
  return outcome;
}

// CGAL's mesher on the segments of the complex (artificial hull edges are left out by asking for none outside).
template <class Kernel>
double conformed(const Complex& complex, bool gabriel) {
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
  Triangulation triangulation;
  std::vector<typename Triangulation::Vertex_handle> vertices;
  for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
    const Point p = complex.input_position(static_cast<VertexId>(v));
    vertices.push_back(triangulation.insert(typename Kernel::Point_2(p.approximate(0), p.approximate(1))));
  }
  for (const auto& [a, b] : complex.segments) triangulation.insert_constraint(vertices[a], vertices[b]);
  const double before = static_cast<double>(triangulation.number_of_vertices());
  if (gabriel) CGAL::make_conforming_Gabriel_2(triangulation);
  else CGAL::make_conforming_Delaunay_2(triangulation);
  return static_cast<double>(triangulation.number_of_vertices()) - before;
}

double median(std::vector<double> values) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); }), values.end());
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

}  // namespace

int main(int count, char** arguments) {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Double = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::vector<std::string> names{"lean", "graded", "Saalfeld", "CGAL Delaunay exact", "CGAL Gabriel exact", "CGAL Delaunay double", "CGAL Gabriel double"};
  fmt::print("| input | segments |");
  for (const auto& name : names) fmt::print(" {} |", name);
  fmt::print("\n|---|---|");
  for (std::size_t i = 0; i < names.size(); ++i) fmt::print("---|");
  fmt::print("\n");
  std::map<std::string, std::vector<double>> ratios;
  for (int i = 1; i < count; ++i) {
    const std::string path = arguments[i];
    const Complex complex = build_complex(read_input(path), {}).complex;
    const Features features = compute_features(complex);
    const Limits limits{1'000'000, 1};
    Silent silent;
    const auto steiner = [&](const Placement& placement) { return static_cast<double>(placement.points.size() - complex.vertices.size()); };
    const std::vector<Outcome> outcomes{
        timed([&] { return steiner(place_lean(complex, features, limits, silent)); }),
        timed([&] { return steiner(place_graded(complex, features, limits, silent)); }),
        timed([&] { return steiner(place_saalfeld(complex, features, limits, silent)); }),
        timed([&] { return conformed<Exact>(complex, false); }),
        timed([&] { return conformed<Exact>(complex, true); }),
        timed([&] { return conformed<Double>(complex, false); }),
        timed([&] { return conformed<Double>(complex, true); })};
    fmt::print("| {} | {} |", path.substr(path.rfind('/') + 1), complex.segments.size());
    for (const Outcome& outcome : outcomes)
      if (std::isfinite(outcome.points)) fmt::print(" {:.0f} ({:.3g} s) |", outcome.points, outcome.seconds);
      else fmt::print(" - |");
    fmt::print("\n");
    std::fflush(stdout);
    // One more on both sides, lest 0 : 0 be undefined.
    ratios["lean : CGAL Delaunay exact, points"].push_back((outcomes[0].points + 1) / (outcomes[3].points + 1));
    ratios["graded : CGAL Gabriel exact, points"].push_back((outcomes[1].points + 1) / (outcomes[4].points + 1));
    ratios["graded : CGAL Gabriel exact, seconds per point"].push_back((outcomes[1].seconds / (outcomes[1].points + 1)) /
                                                                     (outcomes[4].seconds / (outcomes[4].points + 1)));
  }
  fmt::print("\n");
  for (const auto& [name, values] : ratios) fmt::print("median ratio {}: {:.3g}\n", name, median(values));
}
