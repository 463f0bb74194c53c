// SPDX-License-Identifier: GPL-3.0-or-later
// Families made of the others: changed, united, scaled; and inputs that are invalid.
#include <algorithm>
#include <limits>

#include "campaigns/families.h"
#include "campaigns/mutators.h"
#include "campaigns/shapes.h"

namespace confidel::campaigns {

namespace {

/// A valid member of a family of that dimension that is not itself derived.
Input basic(Random& random, int dimension) {
  static const std::vector<Family> basics = [] {
    std::vector<Family> result;
    for (const auto& part : {triangle_families(), polygon_families(), planar_families()}) result.insert(result.end(), part.begin(), part.end());
    return result;
  }();
  while (true) {
    const Family& family = random.choose(basics);
    if (family.dimension != dimension) continue;
    Input input = without_unused_vertices(family.propose(random));
    if (is_valid(input)) return input;
  }
}

Input mutated_of(Random& random, int dimension) {
  Input input = basic(random, dimension);
  constexpr std::size_t most_vertices = 60;
  for (int i = random.integer(1, 4); i > 0 && input.vertices.size() < most_vertices; --i) input = mutate(input, random);
  return input;
}
Input mutated(Random& random) { return mutated_of(random, 3); }
Input planar_mutated(Random& random) { return mutated_of(random, 2); }

Input united_of(Random& random, int dimension) {
  Input first = basic(random, dimension);
  while (true) {
    // Full mantissas leave no room for a translation: then other summands are tried.
    Input second = basic(random, dimension);
    if (random.one_in(3))
      if (const auto small = scaled(second, -random.integer(1, 12))) second = *small;
    if (auto both = far_union(first, second, random)) return std::move(*both);
    if (random.one_in(3)) first = basic(random, dimension);
  }
}
Input united(Random& random) { return united_of(random, 3); }
Input planar_united(Random& random) { return united_of(random, 2); }

Input huge_or_tiny(Random& random) {
  while (true) {
    const int power = random.integer(100, 800);
    if (const auto result = scaled(basic(random, random.one_in(3) ? 2 : 3), random.one_in(2) ? power : -power)) return *result;
  }
}

/// A small thing near a vertex of a large triangle, sizes 2^-4 to 2^-20 apart.
Input mixed_scales(Random& random) {
  Maker maker;
  for (int i = 0; i < 3; ++i) maker.vertex({4. * (i == 1) + random.real(12), 4. * (i == 2) + random.real(12), random.real(12)});
  maker.facet({0, 1, 2});
  const double size = std::ldexp(1.0, -random.integer(4, 20)), away = size * std::ldexp(1.0, random.integer(1, 3));
  const Position centre = sum(maker.at(0), {random.real(6), random.real(6), random.real(6)}, away);
  const int first = maker.size();
  for (int i = 0; i < 3; ++i) maker.vertex(sum(centre, {random.real(12), random.real(12), random.real(12)}, size));
  maker.facet({first, first + 1, first + 2});
  return maker.input();
}

/// One fault in a valid input: it must be refused with exit code 2 and a place.
Input invalid(Random& random) {
  Input input = basic(random, 3);
  const auto vertex = [&] { return static_cast<int>(random.index(input.vertices.size())); };
  switch (random.integer(0, 5)) {
    case 0: input.vertices.push_back(input.vertices[static_cast<std::size_t>(vertex())]); input.facets.push_back({{{{vertex(), vertex(), static_cast<int>(input.vertices.size()) - 1}, 0}}, {}, 0, 0}); break;
    case 1: input.facets.push_back({{{{vertex(), vertex(), vertex()}, 0}}, {}, 0, 0}); break;
    case 2: input.facets.push_back({{{{vertex(), vertex(), vertex(), vertex()}, 0}}, {}, 0, 0}); break;
    case 3: {
      // A needle through whatever is there.
      const Position low{random.real(), random.real(), -100}, high{random.real(), random.real(), 100};
      const int first = static_cast<int>(input.vertices.size());
      for (const Position& p : {low, high, sum(high, {1, 0, 0})}) input.vertices.push_back({p, 0, 0});
      input.facets.push_back({{{{first, first + 1, first + 2}, 0}}, {}, 0, 0});
      break;
    }
    case 4:
      if (!input.facets.empty()) input.facets.push_back(input.facets[random.index(input.facets.size())]);
      if (!input.facets.empty()) input.facets.back().polygons[0].corners.back() = vertex();
      break;
    default:
      for (double& coordinate : input.vertices[static_cast<std::size_t>(vertex())].position) coordinate = random.real(3);
  }
  // What no format can say is no input.
  try {
    suffix_for(input);
  } catch (const std::exception&) {
    input = Input{};
    input.vertices = {{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 0}, {{2, 0, 0}, 0, 0}};
    input.facets = {{{{{0, 1, 2}, 0}}, {}, 0, 0}};
  }
  return input;
}

}  // namespace

std::vector<Family> derived_families() {
  return {
      {"mutated", 3, true, "a member of another family, changed one to four times", mutated},
      {"united", 3, true, "two members of other families, far apart, perhaps of different size", united},
      {"mixed-scales", 3, true, "a tiny triangle near a large one's corner", mixed_scales},
      {"huge-or-tiny", 3, true, "a member of another family (2D too) times 2^k or 2^-k, k up to 800", huge_or_tiny},
      {"planar-mutated", 2, true, "a planar member changed one to four times", planar_mutated},
      {"planar-united", 2, true, "two planar members, far apart", planar_united},
      {"invalid", 3, false, "crossing, overlapping, twisted or degenerate: to be refused", invalid},
  };
}

}  // namespace confidel::campaigns
