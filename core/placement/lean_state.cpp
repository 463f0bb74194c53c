// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/lean_state.h"

#include <algorithm>
#include <cmath>

#include "core/placement/graded.h"

namespace confidel {
namespace {

std::uint64_t key(int a, int b) {
  if (a > b) std::swap(a, b);
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32) | static_cast<std::uint32_t>(b);
}

}  // namespace

LeanState::LeanState(const Complex& complex, const Features& features, const Limits& limits, Progress& progress)
    : complex_(complex), sizes_(graded_sizes(complex, features)), limits_(limits), progress_(progress), index_(complex.vertices) {
  const long entities = static_cast<long>(complex.vertices.size() + complex.segments.size() + complex.facets.size());
  budget_ = 40000 + 128 * entities;
  early_ = 256 + 8 * entities;
  build();
}

void LeanState::build() {
  const int vertices = static_cast<int>(complex_.vertices.size());
  facets_of_vertex_.resize(vertices);
  for (int v = 0; v < vertices; ++v) {
    points_.push_back(&complex_.vertices[v]);
    information_.push_back({PointKind::vertex, -1});
    alive_.push_back(1);
    tetrahedra_.insert(v, complex_.vertices[v]);
    index_.insert(v, complex_.vertices[v].approximate());
  }
  chains_.resize(complex_.segments.size());
  for (std::size_t s = 0; s < chains_.size(); ++s) {
    const auto [a, b] = complex_.segments[s];
    chains_[s].stations = {{{0, 0}, a}, {{1, 0}, b}};
    segment_of_[key(a, b)] = static_cast<SegmentId>(s);
  }
  for (std::size_t f = 0; f < complex_.facets.size(); ++f) {
    const Facet& facet = complex_.facets[f];
    single_.push_back({static_cast<FacetId>(f)});
    frames_.emplace_back(complex_, facet);
    projections_.push_back(projection_of(facet.normal));
    planar_.emplace_back(projections_.back());
    FacetTriangulation& planar = planar_.back();
    std::vector<VertexId> own(facet.isolated);
    for (const auto* edges : {&facet.boundary, &facet.constraints})
      for (const auto& [a, b] : *edges) {
        own.push_back(a);
        own.push_back(b);
        chains_[complex_.find_segment(a, b)].facets.push_back(static_cast<FacetId>(f));
      }
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    for (VertexId v : own) {
      planar.add_vertex(v, complex_.vertices[v]);
      facets_of_vertex_[v].push_back(static_cast<FacetId>(f));
    }
    for (const auto& [a, b] : facet.boundary) planar.add_constraint(a, b, true);
    for (const auto& [a, b] : facet.constraints) planar.add_constraint(a, b, false);
    planar.mark();
  }
  for (std::size_t s = 0; s < chains_.size(); ++s)
    if (chains_[s].hanging()) hanging_.push_back(static_cast<SegmentId>(s));
  flat_ = tetrahedra_.dimension() < 3;
}

// The facets that a point lies on, by its carrier.
const std::vector<FacetId>& LeanState::facets_of(int id) const {
  if (information_[id].kind == PointKind::vertex) return facets_of_vertex_[id];
  return on_segment(id) ? chains_[information_[id].carrier].facets : single_[information_[id].carrier];
}

bool LeanState::is_piece(int a, int b) const { return segment_of_.count(key(a, b)) > 0; }
SegmentId LeanState::segment_of(int a, int b) const { return segment_of_.at(key(a, b)); }

std::size_t LeanState::station_of(SegmentId s, int id) const {
  const auto& stations = chains_[s].stations;
  for (std::size_t i = 0; i < stations.size(); ++i)
    if (stations[i].point == id) return i;
  throw std::logic_error("lean: a point is not on its segment");
}

// --- changes -------------------------------------------------------------------------------------------------------------------

void LeanState::check_limits() {
  progress_.at("placing points", static_cast<long>(complex_.vertices.size()) + steiner_);
  if (limits_.max_points > 0 && steiner_ > limits_.max_points) throw LimitReached("max-points", steiner_);
  if (progress_.stop_requested(steiner_)) throw LimitReached("stopped", steiner_);
  if (++ever_ > budget_) throw LeanGivesUp("the budget of points is used up");
}

int LeanState::add_point(Point position, PointKind kind, int carrier) {
  storage_.push_back(std::move(position));
  points_.push_back(&storage_.back());
  information_.push_back({kind, carrier});
  alive_.push_back(1);
  ++steiner_;
  return static_cast<int>(points_.size()) - 1;
}

int LeanState::place(Point position, PointKind kind, int carrier, int near) {
  const int id = add_point(std::move(position), kind, carrier);
  check_limits();
  DelaunayTetrahedralization::Conflict conflict;
  if (!flat_) {
    conflict = tetrahedra_.conflict(point(id), near);
    try {
      tetrahedra_.insert(id, point(id), near);
    } catch (const std::logic_error&) {
      throw LeanGivesUp("a point would fall on another");  // of another facet or segment: sizes or roundings failed here
    }
  }
  index_.insert(id, point(id).approximate());
  pending_.push_back({std::move(conflict), id});
  return id;
}

int LeanState::put_on_segment(SegmentId s, Dyadic t, PointKind kind) {
  Chain& chain = chains_[s];
  const auto less = [](const Dyadic& x, const Dyadic& y) {
    const int e = std::max(x.exponent, y.exponent);
    return (x.numerator << (e - x.exponent)) < (y.numerator << (e - y.exponent));
  };
  std::size_t i = 0;
  while (i + 2 < chain.stations.size() && !less(t, chain.stations[i + 1].t)) ++i;
  if (!less(chain.stations[i].t, t) || !less(t, chain.stations[i + 1].t)) throw LeanGivesUp("a point would fall on another");
  const int a = chain.stations[i].point, b = chain.stations[i + 1].point;
  const auto [first, second] = complex_.segments[s];
  const int id = place(along(complex_.vertices[first], complex_.vertices[second], t), kind, s, a);
  chain.stations.insert(chain.stations.begin() + static_cast<long>(i) + 1, {std::move(t), id});
  segment_of_.erase(key(a, b));
  segment_of_[key(a, id)] = segment_of_[key(id, b)] = s;
  for (FacetId f : chain.facets)
    for (const Triangle& triangle : planar_[f].split(a, b, id, point(id))) fresh_.push_back({f, triangle});
  fresh_pieces_.push_back({a, id});
  fresh_pieces_.push_back({id, b});
  return id;
}

int LeanState::put_in_facet(FacetId f, Point position, PointKind kind, int near) {
  const int id = place(std::move(position), kind, f, near);
  for (const Triangle& triangle : planar_[f].insert(id, point(id), near)) fresh_.push_back({f, triangle});
  return id;
}

void LeanState::remove_from_chain(int id) {
  const SegmentId s = information_[id].carrier;
  auto& stations = chains_[s].stations;
  const std::size_t i = station_of(s, id);
  const int a = stations[i - 1].point, b = stations[i + 1].point;
  stations.erase(stations.begin() + static_cast<long>(i));
  segment_of_.erase(key(a, id));
  segment_of_.erase(key(id, b));
  segment_of_[key(a, b)] = s;
}

void LeanState::take_out(int id) {
  if (on_segment(id)) {
    const auto& stations = chains_[information_[id].carrier].stations;
    const std::size_t i = station_of(information_[id].carrier, id);
    const int a = stations[i - 1].point, b = stations[i + 1].point;
    for (FacetId f : facets_of(id))
      for (const Triangle& t : planar_[f].join(a, id, b)) fresh_.push_back({f, t});
    remove_from_chain(id);
    fresh_pieces_.push_back({a, b});
  } else {
    for (const Triangle& t : planar_[information_[id].carrier].remove(id)) fresh_.push_back({information_[id].carrier, t});
  }
  if (!flat_) tetrahedra_.remove(id);
  alive_[id] = 0;
  --steiner_;
}

bool LeanState::try_remove(int id, std::vector<int>& neighbours) {
  neighbours.clear();
  if (!flat_) neighbours = tetrahedra_.neighbours(id);
  const bool on_chain = on_segment(id);
  int a = -1, b = -1;
  if (on_chain) {
    const auto& stations = chains_[information_[id].carrier].stations;
    const std::size_t i = station_of(information_[id].carrier, id);
    a = stations[i - 1].point;
    b = stations[i + 1].point;
  }
  alive_[id] = 0;
  bool fine = true;
  std::vector<std::pair<FacetId, Triangle>> changed;
  const std::vector<FacetId>& facets = facets_of(id);
  std::size_t done = 0;
  for (; done < facets.size() && fine; ++done)
    for (const Triangle& t : on_chain ? planar_[facets[done]].join(a, id, b) : planar_[facets[done]].remove(id)) {
      changed.push_back({facets[done], t});
      // What the surroundings exclude by themselves needs no change of the tetrahedralization, which is dear.
      fine = fine && (flat_ || !clearly_unsupported(t, neighbours));
    }
  const int near = on_chain ? a : changed.empty() ? -1 : changed.front().second[0];
  if (fine) {
    if (!flat_) tetrahedra_.remove(id);
    if (on_chain) fine = chains_[information_[id].carrier].hanging() ? !hanging_encroached(a, b) : flat_ || tetrahedra_.is_edge(a, b);
    for (std::size_t k = 0; k < changed.size() && fine; ++k) fine = test(changed[k].first, changed[k].second) == State::good;
    if (fine) {
      if (on_chain) remove_from_chain(id);
      --steiner_;
      for (const auto& [f, t] : changed) neighbours.insert(neighbours.end(), t.begin(), t.end());
      return true;
    }
    if (!flat_) tetrahedra_.insert(id, point(id), near);
  }
  alive_[id] = 1;
  for (std::size_t k = 0; k < done; ++k) {
    if (on_chain)
      planar_[facets[k]].split(a, b, id, point(id));
    else
      planar_[facets[k]].insert(id, point(id), near);
  }
  return false;
}

// --- what changes may have spoiled ---------------------------------------------------------------------------------------------

void LeanState::examine(FacetId f, const Triangle& t) {
  if (test(f, t) != State::good) queue_.emplace(circumradius(t), -f, -t[0], -t[1], -t[2]);
}

LeanState::Bad LeanState::next_bad() {
  const auto [radius, f, p, q, r] = queue_.top();
  queue_.pop();
  return {-f, {-p, -q, -r}};
}

void LeanState::examine_piece(int a, int b) {
  if (is_piece(a, b) && unsupported(a, b)) missing.push_back({a, b});
}

void LeanState::examine_around(const DelaunayTetrahedralization::Conflict& conflict, int id) {
  for (const auto& [a, b] : conflict.edges)
    if (segment_of_.count(key(a, b)) > 0) missing.push_back({a, b});
  for (const auto& face : conflict.faces) {
    for (FacetId f : facets_of(face[0])) {
      Triangle t{face[0], face[1], face[2]};
      if (planar_orientation(projections_[f], point(t[0]), point(t[1]), point(t[2])) < 0) std::swap(t[1], t[2]);
      if (planar_[f].has_triangle(t)) examine(f, t);
    }
  }
  if (!alive_[id]) return;
  for (SegmentId s : hanging_) {
    const Chain& chain = chains_[s];
    for (std::size_t i = 0; i + 1 < chain.stations.size(); ++i) {
      const int a = chain.stations[i].point, b = chain.stations[i + 1].point;
      if (a != id && b != id && diametral_power(point(a), point(b), point(id)) <= 0) missing.push_back({a, b});
    }
  }
}

void LeanState::settle() {
  auto pending = std::move(pending_);
  pending_.clear();
  auto fresh = std::move(fresh_);
  fresh_.clear();
  auto pieces = std::move(fresh_pieces_);
  fresh_pieces_.clear();
  for (const auto& [f, triangle] : fresh)
    if (planar_[f].has_triangle(triangle)) examine(f, triangle);
  for (const auto& [conflict, id] : pending) examine_around(conflict, id);
  if (flat_) {
    // Without tetrahedra nobody says what else changed: other facets of the plane around the new points are tested again.
    for (const auto& [conflict, id] : pending)
      for (std::size_t f = 0; f < planar_.size(); ++f)
        if (planar_.size() > 1)
          for (const Triangle& t : planar_[f].triangles())
            if (diametral_power(point(t[0]), point(t[1]), point(t[2]), point(id)) <= 0) examine(static_cast<FacetId>(f), t);
  }
  for (const auto& [a, b] : pieces) examine_piece(a, b);
}

void LeanState::examine_everything() {
  for (const Chain& chain : chains_)
    for (std::size_t i = 0; i + 1 < chain.stations.size(); ++i) examine_piece(chain.stations[i].point, chain.stations[i + 1].point);
}

}  // namespace confidel
