// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

/// @file
/// Optimisation moves nodes, and where a body is thinner than an element its restricted triangulation may
/// then touch itself at an edge or a node. A membrane cannot live on such a boundary. Cells around the place
/// are put in or taken out, the least volume first, until every boundary edge has two triangles and every
/// boundary node one fan.

namespace glisson::model {

/// Works on a CGAL complex. @tparam Quality double(cell): smallest dihedral angle in degrees.
template <class Complex, class Quality>
class ManifoldBoundary {
  using Triangulation = typename Complex::Triangulation;
  using Cell = typename Triangulation::Cell_handle;
  using Vertex = typename Triangulation::Vertex_handle;
  using Key = std::array<double, 3>;

 public:
  ManifoldBoundary(Complex& complex, double least_quality, Quality quality)
      : complex_(complex), least_quality_(least_quality), quality_(quality) {}

  /// Returns whether the boundary is a manifold now. What came off the body is dropped, cavities are
  /// filled.
  bool repair() {
    bool whole = false;
    for (int pass = 0; pass < kPasses && !whole; ++pass) whole = repair_edges() + repair_vertices() == 0;
    keep_one_solid_piece();
    return whole;
  }

 private:
  static constexpr int kPasses = 30;

  static Key key(Vertex v) { return {v->point().x(), v->point().y(), v->point().z()}; }
  bool inside(Cell cell) const { return complex_.is_in_complex(cell); }
  bool may_enter(Cell cell) const {
    return !complex_.triangulation().is_infinite(cell) && quality_(cell) >= least_quality_;
  }
  double volume(Cell cell) const {
    return complex_.triangulation().is_infinite(cell)
               ? std::numeric_limits<double>::infinity()
               : std::abs(complex_.triangulation().tetrahedron(cell).volume());
  }

  /// The sub-domain that most of a cell's neighbours have.
  typename Complex::Subdomain_index neighbours_domain(Cell cell) const {
    std::map<typename Complex::Subdomain_index, int> votes;
    for (int k = 0; k < 4; ++k)
      if (inside(cell->neighbor(k))) ++votes[complex_.subdomain_index(cell->neighbor(k))];
    typename Complex::Subdomain_index best = 1;
    int most = 0;
    for (const auto& [domain, count] : votes)
      if (count > most) {
        most = count;
        best = domain;
      }
    return best;
  }

  /// Cells joined through faces that the predicate lets pass, each group with one side of the boundary.
  struct Group {
    std::vector<Cell> cells;
    bool inside = false;
    double volume = 0.0;
    bool may_change = true;
  };
  void finish(Group& group) const {
    for (const Cell cell : group.cells) {
      group.volume += volume(cell);
      if (!group.inside && !may_enter(cell)) group.may_change = false;
    }
  }

  bool flip_smallest(const std::vector<Group>& groups) {
    const Group* smallest = nullptr;
    for (const Group& group : groups)
      if (group.may_change && (smallest == nullptr || group.volume < smallest->volume)) smallest = &group;
    if (smallest == nullptr) return false;
    for (const Cell cell : smallest->cells) {
      if (smallest->inside)
        complex_.remove_from_complex(cell);
      else
        complex_.add_to_complex(cell, neighbours_domain(cell));
    }
    return true;
  }

  /// Runs of inside and outside cells around an edge.
  std::vector<Group> runs_around(const typename Triangulation::Edge& edge) const {
    std::vector<Cell> ring;
    auto circulator = complex_.triangulation().incident_cells(edge);
    const auto start = circulator;
    do ring.push_back(circulator);
    while (++circulator != start);
    std::size_t first = 0;  // begin where the side changes
    while (first < ring.size() &&
           inside(ring[first]) == inside(ring[(first + ring.size() - 1) % ring.size()]))
      ++first;
    std::vector<Group> runs;
    if (first == ring.size()) return runs;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Cell cell = ring[(first + i) % ring.size()];
      if (runs.empty() || runs.back().inside != inside(cell)) runs.push_back({{}, inside(cell)});
      runs.back().cells.push_back(cell);
    }
    for (Group& run : runs) finish(run);
    return runs;
  }

  /// Cells on one side of the boundary, grouped by what hangs together through faces.
  template <class Seeds>
  std::vector<Group> pieces_of(const Seeds& seeds) const {
    std::map<Cell, int> piece_of;
    std::vector<Group> pieces;
    for (const Cell seed : seeds) {
      if (!piece_of.emplace(seed, 0).second) continue;
      Group piece{{seed}, inside(seed)};
      for (std::size_t next = 0; next < piece.cells.size(); ++next)
        for (int k = 0; k < 4; ++k) {
          const Cell neighbour = piece.cells[next]->neighbor(k);
          if (inside(neighbour) == piece.inside && piece_of.emplace(neighbour, 0).second)
            piece.cells.push_back(neighbour);
        }
      finish(piece);
      pieces.push_back(std::move(piece));
    }
    return pieces;
  }

  /// Keeps the largest piece of the body, and fills cavities: outside cells that do not reach infinity.
  void keep_one_solid_piece() {
    std::vector<Cell> in, out;
    const Triangulation& triangulation = complex_.triangulation();
    for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
      (inside(cell) ? in : out).push_back(cell);
    for (const bool side : {true, false}) {
      const std::vector<Group> pieces = pieces_of(side ? in : out);
      const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const Group& a, const Group& b) {
        return a.volume < b.volume;  // infinite for what reaches infinity
      });
      for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
        if (piece == largest) continue;
        for (const Cell cell : piece->cells) {
          if (side)
            complex_.remove_from_complex(cell);
          else
            complex_.add_to_complex(cell, neighbours_domain(cell));
        }
      }
    }
  }

  int repair_edges() {
    // In the order of their places: the triangulation's own order may follow addresses.
    std::map<std::array<Key, 2>, typename Triangulation::Edge> order;
    const Triangulation& triangulation = complex_.triangulation();
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
      const Key a = key(edge->first->vertex(edge->second)), b = key(edge->first->vertex(edge->third));
      if (runs_around(*edge).size() > 2)
        order.emplace(std::array<Key, 2>{std::min(a, b), std::max(a, b)}, *edge);
    }
    int touched = 0;
    for (const auto& [place, edge] : order) {
      ++touched;
      for (auto runs = runs_around(edge); runs.size() > 2 && flip_smallest(runs); runs = runs_around(edge)) {
      }
    }
    return touched;
  }

  /// Groups of inside (or outside) cells around a vertex that hang together through faces at the vertex.
  std::vector<Group> fans_around(Vertex vertex) const {
    std::vector<Cell> star;
    complex_.triangulation().incident_cells(vertex, std::back_inserter(star));
    std::map<Cell, int> left;
    for (const Cell cell : star) left.emplace(cell, 0);
    std::vector<Group> fans;
    for (const Cell seed : star) {
      if (left.at(seed) != 0) continue;
      fans.push_back({{}, inside(seed)});
      std::vector<Cell> stack{seed};
      left[seed] = 1;
      while (!stack.empty()) {
        const Cell cell = stack.back();
        stack.pop_back();
        fans.back().cells.push_back(cell);
        for (int k = 0; k < 4; ++k) {
          if (cell->vertex(k) == vertex) continue;
          const auto next = left.find(cell->neighbor(k));
          if (next == left.end() || next->second != 0 || inside(next->first) != inside(seed)) continue;
          next->second = 1;
          stack.push_back(next->first);
        }
      }
      finish(fans.back());
    }
    return fans;
  }

  int repair_vertices() {
    std::map<Key, Vertex> order;
    const Triangulation& triangulation = complex_.triangulation();
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
      if (fans_around(v).size() > 2) order.emplace(key(v), v);
    int touched = 0;
    for (const auto& [place, vertex] : order) {
      ++touched;
      for (auto fans = fans_around(vertex); fans.size() > 2 && flip_smallest(fans);
           fans = fans_around(vertex)) {
      }
    }
    return touched;
  }

  Complex& complex_;
  double least_quality_;
  Quality quality_;
};

}  // namespace glisson::model
