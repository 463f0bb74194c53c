// SPDX-License-Identifier: GPL-3.0-or-later
// What several families are made of. Angles go through libm, so positions are rounded to few bits: the last digits of a
// cosine, which differ between machines, do not get into an input.
#pragma once

#include "campaigns/instance.h"
#include "campaigns/random.h"

namespace confidel::campaigns {

constexpr double full_turn = 6.283185307179586;

/// The nearest multiple of 2^-bits.
double snapped(double value, int bits = 24);
Position snapped(const Position& position, int bits = 24);

Position sum(const Position& a, const Position& b, double factor = 1);
/// Not exact: steers.
double distance(const Position& a, const Position& b);

/// In the cube [-1, 1)^3 with the given number of bits per coordinate; distinct.
std::vector<Position> random_positions(Random& random, int count, int bits, int dimension = 3);

/// Integer vectors a, b (independent) and o: (u, v) -> o + u a + v b is exact for integers u, v below 2^20, so polygons made with
/// it are exactly flat. Now and then an axis-parallel or nearly degenerate plane.
struct Plane {
  Position origin, a, b;
  Position at(double u, double v) const { return sum(sum(origin, a, u), b, v); }
  Position normal() const;
};
Plane random_plane(Random& random);

/// Triangles (as index triples) and edges of tetrahedra whose open balls, and spheres, hold no other of the points: they are in
/// every Delaunay subdivision, so any of them make a valid complex.
struct DelaunayFaces {
  std::vector<std::vector<int>> triangles;
  std::vector<std::array<int, 2>> edges;
};
DelaunayFaces strict_delaunay_faces(const std::vector<Position>& positions);

/// Random segments between the points that do not cross one another, at most count; only index pairs i < j.
std::vector<std::array<int, 2>> random_noncrossing_segments(Random& random, const std::vector<Position>& planar, int count);

}  // namespace confidel::campaigns
