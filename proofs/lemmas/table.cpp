// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "proofs/lemmas/counts.h"
#include "proofs/lemmas/tally.h"
#include "proofs/lemmas/statements.h"

namespace confidel {
namespace {

const std::vector<Lemma> table{
    {"H-angle", "the angle phi' is at most pi/4 and at most every angle between edges at a vertex", "2.1, 3.2", "angle",
     "K psi < pi, T_K(C) > 0, 2 T_K(C)^2 >= 1; at every end of e and for every other e' there: T_K(C) >= cos(e,e')", false, counts::segment_ends, statements::angle},
    {"H-ball", "arc points lie on the protecting circle or sphere of their vertex", "2.1, 3.2", "r, in dimension 3 also h; or ball",
     "|p-v|^2 = r^2; in dimension 3: 7 | |p-v|^2 - r^2 | <= h^2; local: 15 r_v^2 <= 16 |p-v|^2 <= 17 r_v^2", true, counts::end_and_spoke_cells, statements::ball},
    {"H-offset", "the offset of an edge is at most what the angles at its ends allow", "2.3, 3.2", "r, angle, beta or offset; or ball and row",
     "beta J: |a-v|^2 - |a-m|^2 >= T_J(C)^2 |a-v|^2; offset J: |a-m|^2 <= 4 r^2 (1 - T_J(C)^2); local: d <= r_v sin(theta/3), d <= r_v sin(0.7 omega), by T_3(A) and T_10(B)", true,
     counts::end_cells, statements::offset},
    {"H-chord", "the spacing h is at most the chord of half the angle", "2.2", "r, h, angle, chord", "4 J <= K, K psi < pi, h^2 <= 4 r^2 (1 - T_J(C)^2)", false, counts::one,
     statements::chord},
    {"L1", "neighbours on an arc are between h and 3h/2 apart (the paper: sqrt3 h)", "2.2", "h", "h^2 <= b^2, 4 b^2 <= 9 h^2", true, counts::spoke_cells, statements::arc_spacing},
    {"L2", "neighbours on edges and protectors are between h and 3h/2 apart", "2.2, 2.3", "h", "4 h^2 <= 4 w^2 <= 9 h^2", true, counts::boxes, statements::edge_spacing},
    {"L3", "the circle of a spoke triangle bulges at most h/2 beyond its chord", "2.2", "h",
     "b^2 <= h^2 and D >= 0; or D > 0 and (b^2-h^2)^2 X <= 4 h^2 b^2 D^2, with D = (A-v).(B-v), X = |(A-v) x (B-v)|^2", true, counts::spoke_cells, statements::spoke_bulge},
    {"L4", "the circle of a rectangle bulges at most h/2 beyond the buffer", "2.3", "h", "w^2 <= h^2, or (w^2-h^2)^2 <= 4 h^2 d^2", true, counts::boxes, statements::box_bulge},
    {"L5", "the protectors of neighbouring edges do not cross", "2.3", "", "((m-v) x (m'-v)).n > 0 implies ((a-v) x (a'-v)).n > 0", true, counts::opening_end_cells,
     statements::protectors_apart},
    {"L6", "points of the boundary of P'' are at least h apart", "2.2", "h", "|x-y|^2 >= h^2", true, counts::protecting_points, statements::boundary_separation},
    {"L7", "the corners of P'' are not acute", "implicit", "", "(q-a).(p-a) <= 0", true, counts::end_cells, statements::obtuse_corners},
    {"L8", "where R > h the circumcentre lies in P'', farther than h from points and h/2 from the boundary", "2.1, 2.2", "h",
     "R^2 > h^2; |x-z0|^2 > h^2 for earlier points; dist^2(z0, AB) >= h^2/4 for the outline; 4096 |POINT-z0|^2 <= h^2", true, counts::interior_points, statements::insertions},
    {"L9", "the sphere of a cell T is empty", "2.3, 3.2", "", "P(x) >= 0, > 0 off the plane, for every x but the corners", true, counts::end_cells, statements::end_cells_empty},
    {"L10", "the sphere of a cell S contains no cap point m of its vertex", "3.2", "", "P(m) >= 0, > 0 off the plane, for every m of a cell T of the same vertex", true,
     counts::spoke_cells, statements::spokes_and_caps},
    {"L11", "the sphere of a cell S contains no arc or offset point", "3.2", "", "P(x) >= 0, > 0 off the plane, for every x of kind arc or offset", true, counts::spoke_cells,
     statements::spokes_and_arcs},
    {"L12", "the sphere of a rectangle does not contain the aligned points of other facets at its edge", "3.2", "", "o'.(o'-o) > 0", true, counts::protectors_off_plane,
     statements::alignment},
    {"L13", "the sphere of a rectangle is empty", "3.2", "", "P(x) >= 0, > 0 off the plane, for every x but the box's corners", true, counts::box_cells, statements::boxes_empty},
    {"L14", "outside their buffers, facets at an edge are at least 3h/2 apart", "3.2", "h", "9 h^2 <= 4 |o-o'|^2", true, counts::protector_pairs, statements::sheet_separation},
    {"L15", "edges at a vertex make at least the angle phi' with facets that do not contain them", "missing", "angle",
     "where e projects into a cell of f at v: T_K(C) > 0, (u.n)^2 >= (1 - T_K(C)^2) |u|^2 |n|^2", true, counts::tilts, statements::tilt},
    {"L16", "the sphere of a cell C is empty, and its radius is at most (1 + 1/16) h", "3.2", "h if r is there", "P(x) >= 0, > 0 off the plane; 256 R^2 <= 289 h^2", true,
     counts::other_cells, statements::other_cells_empty},
    {"L17", "the boundary of P'' is locally Delaunay in its plane", "2.2, 2.3", "", "P(y) >= 0 for the C cell at an edge of the outline, y opposite to it", true,
     counts::outline_edges, statements::locally_delaunay},
    {"L18", "every cell has an empty sphere, without points on it off the plane", "missing", "", "rule emptiness", false, counts::cells, statements::emptiness},
    {"L18b", "points on a cell's circle are not beyond an edge of the cell that lies on a segment", "missing", "", "rule tie", false, counts::cells, statements::ties},
    {"L19", "the cells tile the facet, inner constraints are unions of their edges", "implicit", "", "rule tiling", false, counts::facets, statements::tiling},
    {"L20", "circumradii are at most r_max", "2.1, Theorem 2.1", "r-max; r if global", "R^2 <= r_max^2; 100 r^2 <= 361 r_max^2", true, counts::cells, statements::circumradius},
    {"L21", "entities without common vertex are at least 3r apart", "3.2", "r; or ball and row", "9 r^2 <= dist^2; local: 9 r_v^2 <= dist^2, 9 d_e^2 <= dist^2", false,
     counts::vertices_and_segments, statements::feature_separation},
    {"L22", "the closed diametral ball of each piece of a hanging segment contains no other point", "1.3", "", "(x-a).(x-b) > 0", false, counts::hanging_subsegments,
     statements::hanging_empty},
    {"L23", "circles of P'' penetrate the buffer by at most 3h/2", "2.2", "h", "(A-x).(B-x) >= 0, or 4 R^2 - |AB|^2 <= h^2", true, counts::outline_edges,
     statements::penetration},
};

}  // namespace

const std::vector<Lemma>& all_lemmas() { return table; }

const Lemma& find_lemma(const std::string& id) {
  const auto place = std::find_if(table.begin(), table.end(), [&](const Lemma& lemma) { return id == lemma.id; });
  if (place == table.end()) throw std::out_of_range("no lemma " + id);
  return *place;
}

LemmaResult evaluate(const Lemma& lemma, const Instance& instance) {
  if (lemma.needs_kinds && instance.wrong_kind >= 0) throw WrongKind(instance.wrong_kind);
  Tally tally(lemma.count(instance));
  lemma.evaluate(instance, tally);
  return std::move(tally).result();
}

}  // namespace confidel
