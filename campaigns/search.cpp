// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaigns/search.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "campaigns/families.h"
#include "campaigns/instance.h"
#include "campaigns/mutators.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

const std::vector<std::string>& starts() {
  static const std::vector<std::string> names{"hovering-at-edge", "hovering-at-vertex", "wedge", "fan", "star", "sharp-apex", "hanging-edges", "needles", "plates"};
  return names;
}

double size_of(const Input& input) {
  double greatest = 0;
  for (const InputVertex& vertex : input.vertices)
    for (const double coordinate : vertex.position) greatest = std::max(greatest, std::abs(coordinate));
  return greatest;
}

/// One or several vertices moved by about step times the size, to a grid that is finer than the step by little: small numbers shrink well.
Input moved(Input input, double step, Random& random) {
  const double size = size_of(input);
  int exponent = 0;
  std::frexp(step * size, &exponent);
  const int bits = 6 - exponent;
  const std::size_t count = input.vertices.size();
  const bool all = random.one_in(3);
  const std::size_t only = random.index(count);
  for (std::size_t v = 0; v < count; ++v) {
    if (!all && v != only) continue;
    for (double& coordinate : input.vertices[v].position)
      if (random.one_in(2)) coordinate = snapped(coordinate + step * size * (random.real() + random.real()), bits) + 0.0;
  }
  return input;
}

}  // namespace

void search(Random& random, const Search& task) {
  constexpr int patience = 25;
  while (!task.stop()) {
    const std::string name = random.choose(starts());
    Input best = generate(*find_family(name), random.word());
    std::optional<double> reached = task.objective(best);
    if (!reached) continue;
    task.improved({name, best, *reached});
    double step = 0.25;
    for (int failures = 0; failures < patience && !task.stop();) {
      Input candidate = random.one_in(8) ? mutate(best, random) : moved(best, step, random);
      if (!is_valid(candidate)) {
        step = std::max(step * 0.9, 1e-6);
        ++failures;
        continue;
      }
      const std::optional<double> value = task.objective(candidate);
      if (value && *value < *reached) {
        best = std::move(candidate);
        reached = value;
        failures = 0;
        step = std::min(step * 2, 0.5);
        task.improved({name, best, *reached});
      } else {
        ++failures;
        step = std::max(step * 0.84, 1e-6);  // one success in five keeps the step
      }
    }
  }
}

}  // namespace confidel::campaigns
