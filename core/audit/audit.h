// SPDX-License-Identifier: GPL-3.0-or-later
// Is the Delaunay tetrahedralization of somebody's points conforming? Exactly, segment by segment and facet by facet.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/audit/intrusion.h"
#include "core/complex/complex.h"
#include "core/io/mesh.h"
#include "core/placement/placement.h"

namespace confidel {

/// Of a segment or facet of the complex, with respect to the Delaunay subdivisions of the mesh's points.
enum class Standing {
  holds,    ///< a union of edges or triangles of every one of them, and a certificate can say so
  present,  ///< a union of edges of one of them, but with another point in or on a diametral ball: no certificate of this format says so
  fails     ///< not a union of edges or triangles of every one of them
};

struct AuditedPart {
  Standing standing = Standing::fails;
  std::vector<VertexId> missing;  ///< vertices of the part that are no points of the mesh
  int pieces = 0;                 ///< subsegments or triangles that the points exactly on it cut it into
  int bad = 0;                    ///< those that are no Delaunay edges or triangles, or only in case of a tie
  /// The worst bad piece: its corners (the third is -1 for a subsegment), and of a triangle what lies in every sphere through them.
  std::array<int, 3> piece{-1, -1, -1};
  Intrusion intrusion;
  /// The mesh's own triangles on this facet, exactly or nearly; those without empty sphere; and the worst of these.
  int subfaces = 0, bad_subfaces = 0;
  std::array<int, 3> subface{-1, -1, -1};
  Intrusion subface_intrusion;
};

/// A point of the mesh that lies near a segment or facet, but not on it. What is near is a matter of taste and of the report only.
struct OffCarrier {
  int point = -1;
  bool on_segment = false;
  int carrier = -1;
  double distance = 0;  ///< in the input's units, rounded
};

struct Audit {
  std::vector<AuditedPart> segments, facets;
  std::vector<OffCarrier> off;
  std::vector<int> duplicates;  ///< points of the mesh with the position of an earlier one
  double worst_distance = 0;    ///< of off
  long inner_points = 0;        ///< points of the mesh that are near nothing

  /// The parts that hold, for a certificate: the complex itself if everything holds and all points belong to it; otherwise a complex with
  /// the parts that hold, and all other points as vertices without segments.
  bool whole = false;
  Complex complex;
  Placement placement;

  bool conforms() const;     ///< everything holds
  bool fails() const;        ///< something fails
};

/// Pre: a valid complex; points of mesh are finite. near: points up to this distance off a segment or facet, in the input's units, are reported
/// as off it. Exact in Standing. Throws InputError (E-VALUE) if the dimensions differ.
Audit audit_mesh(const Complex& complex, const Mesh& mesh, double near);

}  // namespace confidel
