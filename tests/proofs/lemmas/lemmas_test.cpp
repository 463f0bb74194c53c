// SPDX-License-Identifier: GPL-3.0-or-later
// What the graded strategy claims of itself holds, on small and on random inputs; and statements notice when it does not.
#include "proofs/lemmas/lemma.h"

#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>

#include "proofs/lemmas/algebraic.h"
#include "proofs/lemmas/certificate_instance.h"
#include "tests/core/complex/triangulation_rules.h"
#include "tests/support/placing.h"
#include "tests/support/random_inputs.h"

using namespace confidel;
using namespace confidel::test;

namespace {

void require_claims(const Complex& complex, const Placement& placement, const std::string& name) {
  const Instance instance = instance_of(complex, placement, true), counting = instance_of(complex, placement, false);
  for (const std::string& id : placement.claims) {
    const Lemma& lemma = find_lemma(id);
    const LemmaResult result = evaluate(lemma, instance);
    BOOST_TEST(result.failures == 0, name << ": " << id << " fails on " << result.failures << " of " << result.objects << ", first at "
                                          << (result.failure ? result.failure->object : ""));
    BOOST_TEST(result.objects == lemma.count(counting));
  }
}

/// How often a lemma fails after a change of an instance for which it holds.
template <class Change>
long failures_after(const std::string& id, Change change) {
  const Complex complex = build_complex(triangles({{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {20, 20, 7}, {10, 10, -14}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})).complex;
  Placement placement = place(complex, Strategy::graded);
  BOOST_TEST(evaluate(find_lemma(id), instance_of(complex, placement, true)).failures == 0);
  Instance instance = instance_of(complex, placement, true);
  change(instance);
  return evaluate(find_lemma(id), instance).failures;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lemmas)

BOOST_AUTO_TEST_CASE(graded_keeps_its_claims) {
  for (const NamedInput& named : small_inputs()) {
    const Complex complex = build_complex(named.input).complex;
    require_claims(complex, place(complex, Strategy::graded), named.name);
    require_claims(complex, place(complex, Strategy::lean), named.name + ", lean");
  }
  const char* factor = std::getenv("CONFIDEL_ROUNDS");
  const long rounds = 60 * (factor != nullptr ? std::atol(factor) : 1);
  long all = 0, done = 0;
  for (long round = 0; round < rounds; ++round) {
    const NamedInput named = random_input(0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(round + 1001));
    const Complex complex = build_complex(named.input).complex;
    try {
      const Placement placement = place(complex, Strategy::graded, 3000);
      require_claims(complex, placement, named.name);
      ++done;
      all += placement.claims.size() == 16;
    } catch (const LimitReached&) {
    }
  }
  BOOST_TEST(done * 10 >= rounds * 8);
  BOOST_TEST(all * 2 >= rounds);
}

BOOST_AUTO_TEST_CASE(statements_notice) {
  const auto point = [](Instance& instance, PointKind kind) -> RationalVector& {
    for (std::size_t i = 0; i < instance.kinds.size(); ++i)
      if (instance.kinds[i] == kind) return instance.positions[i];
    throw std::logic_error("no such point");
  };
  // An arc point is moved to its vertex: off the sphere, and inside others.
  const auto shrink = [&](Instance& instance) {
    const SpokeCell& spoke = instance.spoke_cells.front();
    for (int axis = 0; axis < 3; ++axis) instance.positions[spoke.q][axis] = (instance.positions[spoke.q][axis] + 7 * instance.positions[spoke.v][axis]) / 8;
  };
  for (const char* id : {"H-ball", "L9", "L11", "L18"}) BOOST_TEST(failures_after(id, shrink) > 0, id);
  BOOST_TEST(failures_after("L10", [](Instance& i) { i.positions[i.end_cells.front().m] = i.positions[i.spoke_cells.front().v]; for (auto& x : i.positions[i.end_cells.front().m]) x += mpq_class(1, 1000); }) > 0);
  BOOST_TEST(failures_after("L13", [](Instance& i) {
    const auto& box = i.boxes.front().corners;
    for (int axis = 0; axis < 3; ++axis) i.positions[i.vertex_count - 1][axis] = (i.positions[box[0]][axis] + i.positions[box[2]][axis]) / 2;
  }) > 0);
  BOOST_TEST(failures_after("L16", [&](Instance& i) { point(i, PointKind::projection) = point(i, PointKind::interior); for (auto& x : point(i, PointKind::projection)) x += mpq_class(1, 1 << 20); }) > 0);
  BOOST_TEST(failures_after("L5", [](Instance& i) { for (EndCell& end : i.end_cells) if (!end.opens) end.a = end.m; for (EndCell& end : i.end_cells) if (end.opens) std::swap(i.positions[end.a], i.positions[i.end_cells[i.closing_cell(end)].m]); }) > 0);
  BOOST_TEST(failures_after("L12", [](Instance& i) {
    auto& row = i.rows.front();
    for (int axis = 0; axis < 3; ++axis) i.positions[row.protectors[0].points.front()][axis] = 3 * i.positions[row.protectors[1].points.front()][axis] - 2 * i.positions[row.points.front()][axis];
  }) > 0);
  BOOST_TEST(failures_after("L19", [](Instance& i) { i.cells.pop_back(); }) == 1);
  BOOST_TEST(failures_after("L21", [](Instance& i) { i.parameters.balls.front().radius *= mpq_class(1000001, 1000000); }) == 1);
  BOOST_TEST(failures_after("H-offset", [](Instance& i) { i.parameters.rows.front().edge_cosine[0] = mpq_class(1, 2); }) > 0);
  BOOST_CHECK_THROW(failures_after("L21", [](Instance& i) { i.parameters = Parameters(); }), MissingParameter);
  BOOST_CHECK_THROW(find_lemma("L99"), std::out_of_range);
}

// The campaign's oracle has nothing against what the checker accepts, and finds what makes others wrong.
BOOST_AUTO_TEST_CASE(objections_to_certificates) {
  const std::filesystem::path folder = CONFIDEL_SOURCE_DIR "/tests/certificates";
  int accepted = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "accept")) {
    if (entry.path().extension() != ".cert") continue;
    BOOST_TEST(objection_to(instance_of(read_certificate(entry.path().string()))) == "", entry.path().filename());
    ++accepted;
  }
  BOOST_TEST(accepted > 20);
  const std::pair<const char*, const char*> wrong[] = {{"emptiness-off-plane-in", "L18 "}, {"emptiness-off-plane-on", "L18 "}, {"emptiness-in-plane", "L18 "}, {"tie-inner", "L18b "},
                                                       {"tiling-gap", "L19 "}, {"hanging-in-ball", "L22 "}, {"hanging-on-ball", "L22 "}};
  for (const auto& [name, statement] : wrong) {
    const std::string objection = objection_to(instance_of(read_certificate((folder / "reject" / (std::string(name) + ".cert")).string())));
    BOOST_TEST(objection.rfind(statement, 0) == 0, name << ": " << objection);
  }
}

BOOST_AUTO_TEST_CASE(extremal_statements) {
  const auto results = decide_extremal_statements();
  BOOST_TEST(results.size() == 7);
  for (const AlgebraicResult& result : results) BOOST_TEST(result.holds, result.id);
  const AlgebraicCorner corner = tetrahedron_corner();
  BOOST_TEST((corner.on_sphere && corner.spacing_is_h && corner.right_angles && corner.end_cells_empty && corner.spokes_miss_caps && corner.spokes_empty));
  BOOST_TEST(corner.end_cells == 6);
  BOOST_TEST(corner.spoke_cells == 12);
}

BOOST_AUTO_TEST_SUITE_END()
