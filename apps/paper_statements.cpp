// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/paper_statements.h"

namespace confidel {

const std::vector<PaperStatement>& paper_statements() {
  static const std::vector<Counterexample> crossing{{"corner-45.poly", ""}, {"w2.smesh", ""}, {"w3.smesh", ""}, {"g3.smesh", ""}};
  static const std::vector<Counterexample> spheres{{"w2.smesh", "1/3"}, {"w2.smesh", "1/4"}};
  static const std::vector<Counterexample> conformity{{"w3.smesh", "1/3"}, {"w3.smesh", "1/4"}, {"g3.smesh", "1/3"}, {"g3.smesh", "1/4"},
                                                      {"w3-prime.smesh", "1/3"}, {"w3-prime.smesh", "1/4"}, {"w3-prime.smesh", "1/6"}};
  static const std::vector<PaperStatement> statements{
      {"1.3", "Lemma 1.2: a triangle is a face iff a sphere through its corners has no point inside", {}, {}, "points in general position", Experiment::empty_spheres},
      {"1.3", "Lemma 1.2, points on the sphere allowed", {}, {}, "true for closed spheres: no point off the plane may lie on it (L18)", Experiment::ties},
      {"1.3", "hanging edges can be treated by themselves, as Saalfeld does", {"L22"}, {}, "but not left alone (\"considered no further\"): they get the same r, beta and h"},
      {"2.1", "where R > h, the circumcentre is farther than h from all points and stays in the region", {"L8"}, {}, "read for the triangulation of all points of the facet"},
      {"2.2", "h <= r/2 (printed: h/2 <= r)", {}, {}, "", Experiment::radius},
      {"2.2", "chords of the protecting circle are in [h, sqrt3 h]", {"L1"}, {}, "even in [h, 3h/2], if h is a chord of phi'/2 with phi' <= phi, and not just any smaller number"},
      {"2.2", "pieces of edges and protectors are in [h, sqrt3 h], and aligned", {"L2"}, {}, "even in [h, 3h/2]"},
      {"2.2", "entities that are not incident are farther apart than 2h", {"L21", "L6"}, {}, "3r for entities; points of the boundary of P'' only h, which is what is needed"},
      {"2.2", "circles of spoke triangles bulge at most h/2", {"L3"}, {}, ""},
      {"2.2", "circles of Chew's triangles penetrate the buffer by at most 3h/2", {"L23"}, {}, ""},
      {"2.2", "spoke triangles and Chew's triangles do not interfere in the plane", {"L17", "L7"}, {}, ""},
      {"2.3", "d_e can be computed in the same manner as h", {"H-offset", "L5"}, crossing, "repaired: d_e = r sin(phi/3)"},
      {"2.3", "d_e >= h", {}, {}, "", Experiment::offset},
      {"2.3", "circles of boxes bulge at most h/2", {"L4"}, {}, "the worst case (w = sqrt3 h, d = h) never occurs: w <= 3h/2"},
      {"2.3", "Theorem 2.1: circumradii are at most r_max", {"L20"}, {}, "needs r <= 1.9 r_max too"},
      {"3.2", "d_e needs no angles but those between edges", {"L15", "L10"}, conformity, "repaired: phi counts the angles of edges with facets"},
      {"3.2", "minimum spheres in buffer zones do not interfere", {"L9", "L10", "L11", "L13"}, spheres, "they do intersect (spokes share a vertex); what counts is that they are empty"},
      {"3.2", "facets at an edge are at least h' apart outside the buffer", {"L14"}, {}, "with h <= (2/3) d_f"},
      {"3.2", "boxes contain no points of other facets at their edge, by alignment", {"L12", "L13"}, {}, ""},
      {"3.2", "every Chew triangle satisfies Lemma 1.2", {"L16"}, {}, ""},
      {"3.2", "(not said) spheres are empty with nothing off the plane on them, ties cross no constraint", {"L18", "L18b"}, {}, "needed for every Delaunay subdivision to conform"},
      {"3.2", "(implicit) cells tile the facets", {"L19"}, {}, ""},
      {"3.2", "Theorem 3.1: the points conform", {}, {}, "with the repaired parameters; with the printed ones see above", Experiment::verdicts},
  };
  return statements;
}

}  // namespace confidel
