// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/patient/patient_model.h"

/// @file
/// Portal veins by formula. Millimetres to the patient's left, back and head of the end of the umbilical
/// part.

namespace glisson::test {

/// Nodes and beams, added way by way.
class TreeMaker {
 public:
  using Way = std::vector<Eigen::RowVector3d>;

  /// A way from a node (-1: the root) in pieces of 4 mm, the radius from one end to the other, mm. @return
  /// its last node.
  int add(int from, const Way& corners, double radius, double last_radius) {
    double length = 0.0, done = 0.0;
    for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).norm();
    if (from < 0) from = node(corners.front(), radius);
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const double piece = (corners[i] - corners[i - 1]).norm();
      const int steps = std::max(1, static_cast<int>(piece / 4.0));
      for (int s = 1; s <= steps; ++s) {
        const double share = static_cast<double>(s) / steps;
        const int next = node(corners[i - 1] + share * (corners[i] - corners[i - 1]),
                              radius + (done + share * piece) / length * (last_radius - radius));
        tree_.beams.push_back({from, next});
        from = next;
      }
      done += piece;
    }
    return from;
  }

  VesselTree made() const {
    VesselTree tree = tree_;
    tree.structure = structure::kPortalVein;
    tree.root = 0;
    tree.nodes.resize(static_cast<Eigen::Index>(nodes_.size()), 3);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      tree.nodes.row(static_cast<Eigen::Index>(i)) = 1e-3 * nodes_[i];
    return tree;
  }

 private:
  int node(const Eigen::RowVector3d& at, double radius) {
    nodes_.push_back(at);
    tree_.radii.push_back(1e-3 * radius);
    return static_cast<int>(nodes_.size()) - 1;
  }

  VesselTree tree_;
  std::vector<Eigen::RowVector3d> nodes_;
};

/// What a portal vein has beside its trunk and the right branch.
enum class LeftBranch { none, transverse, whole };

/// The end of its umbilical part is the origin.
inline VesselTree portal_vein(LeftBranch left) {
  TreeMaker maker;
  const Eigen::RowVector3d fork(-40, 44, -20), right(-62, 44, -14), turn(2, 26, 6), end(0, 0, 0);
  const int at_fork = maker.add(-1, {{0, 56, -60}, {-24, 52, -34}, fork}, 7, 6.5);
  const int at_right = maker.add(at_fork, {fork, right}, 6, 5.5);
  maker.add(at_right, {right, {-80, 22, 0}, {-92, 6, 18}}, 4.5, 2);       // the anterior sector
  maker.add(at_right, {right, {-84, 66, -16}, {-106, 80, -10}}, 4.5, 2);  // the posterior one
  if (left == LeftBranch::none) return maker.made();
  const int at_turn = maker.add(at_fork, {fork, {-22, 38, -8}, turn}, 5.5, 5);
  if (left == LeftBranch::transverse) return maker.made();
  maker.add(at_turn, {turn, {30, 20, 16}, {56, 22, 26}}, 2.5, 1.2);  // to segment II
  const int at_end = maker.add(at_turn, {turn, {2, 12, 6}, end}, 5, 4.5);
  maker.add(at_end, {end, {24, -8, 0}, {50, -10, -4}}, 2.2, 1.2);   // III
  maker.add(at_end, {end, {-16, -12, 4}, {-28, -22, 10}}, 2, 1.2);  // IV
  return maker.made();
}

/// Three hepatic veins that run forwards and down from the vena cava.
inline VesselTree hepatic_veins() {
  TreeMaker maker;
  const Eigen::RowVector3d mouth(-20, 40, 60);
  const int at_mouth = maker.add(-1, {{-20, 60, 62}, mouth}, 8, 7);
  maker.add(at_mouth, {mouth, {-60, 40, 40}, {-100, 40, -10}}, 5.5, 2);
  maker.add(at_mouth, {mouth, {-30, 10, 40}, {-50, -20, -20}}, 5, 2);
  maker.add(at_mouth, {mouth, {10, 10, 50}, {50, -5, 30}}, 4.5, 2);
  return maker.made();
}

}  // namespace glisson::test
