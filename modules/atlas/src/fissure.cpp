// SPDX-License-Identifier: GPL-3.0-or-later
#include "fissure.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "note.h"

namespace glisson::atlas {
namespace {

// Measured on ten real livers (packaging/figures, README, atlas.md), two readings each; metres, to the left,
// back and head. From the end of the umbilical part the notch lies forwards and down, along the round
// ligament, and a little to the right: the ligament lies right of the vein's fissure.
const Eigen::Vector3d kToNotch(-0.007, -0.028, -0.022);
/// Of that: 8, 6 and 15 mm, widened for ten livers as the atlas widens its own (Hotelling's T^2).
const Eigen::Vector3d kNotchDeviation(0.0125, 0.0095, 0.023);
constexpr double kVeinDeviation = 0.005;  // metres, of where the vein is found, from side to side
constexpr double kTilt = 0.26;            // metres a metre, of the fissure's plane: 15 degrees
/// Of the way to where hepatic veins enter the vena cava: a portal vein's middle is nearer than that to the
/// hilum (at most 0.6 on twelve real livers; of hepatic veins of two of them 0.95 and 1.2).
constexpr double kNearHilum = 0.75;

template <class Proposals>
auto find(Proposals& proposals, Structure structure) {
  const auto at = std::ranges::find(proposals, structure, &Proposal::structure);
  return at == proposals.end() ? nullptr : &*at;
}

/// The middle of trees by their volume.
Eigen::Vector3d middle_of(const std::vector<VesselTree>& trees) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0.0;
  for (const VesselTree& tree : trees)
    for (const auto& [a, b] : tree.beams) {
      const double radius =
          0.5 * (tree.radii[static_cast<std::size_t>(a)] + tree.radii[static_cast<std::size_t>(b)]);
      const double volume = (tree.nodes.row(a) - tree.nodes.row(b)).norm() * radius * radius;
      sum += 0.5 * volume * (tree.nodes.row(a) + tree.nodes.row(b)).transpose();
      weight += volume;
    }
  return weight > 0.0 ? Eigen::Vector3d(sum / weight) : sum;
}

/// Whether these may be hepatic veins: their middle does not lie at the hilum. Both places from statistics:
/// the hilum that the image shows comes from the same label, and a vena cava may be segmented in part.
bool perhaps_hepatic(const std::vector<VesselTree>& trees, const std::vector<Proposal>& foretold) {
  const Proposal *hilum = find(foretold, Structure::portal_entrance),
                 *cava = find(foretold, Structure::vena_cava);
  if (hilum == nullptr || cava == nullptr) return false;
  const Eigen::RowVector3d middle = middle_of(trees).transpose();
  const Eigen::Index top = cava->points.rows() - 1;
  return (hilum->points.row(0) - middle).norm() > kNearHilum * (cava->points.row(top) - middle).norm();
}

/// Whether it lies right of the gallbladder's bed: a branch of the right lobe, or of a round ligament on the
/// right, of which just this is told (Nagai 1997; Shindoh 2012).
bool is_on_right(const UmbilicalPart& part, const Proposal* bed, const Eigen::Vector3d& left) {
  return bed != nullptr && part.tip.xyz.dot(left) < bed->points.colwise().mean().dot(left.transpose());
}

/// What is known of a point from two sides that do not know of each other.
void fuse(Eigen::Vector3d& point, Eigen::Matrix3d& spread, const Eigen::Vector3d& seen,
          const Eigen::Matrix3d& precision) {
  const Eigen::Matrix3d own = spread.inverse();
  spread = (own + precision).inverse();
  point = spread * (own * point + precision * seen);
}

/// Where the part says that the notch lies.
struct SeenNotch {
  Eigen::Vector3d place;
  Eigen::Matrix3d spread;
};
SeenNotch seen_notch(const UmbilicalPart& part, const Eigen::Matrix3d& upright) {
  return {part.tip.xyz + upright.transpose() * kToNotch,
          upright.transpose() * kNotchDeviation.cwiseAbs2().asDiagonal() * upright};
}

}  // namespace

std::optional<UmbilicalPart> fissure_part(const std::vector<Proposal>& proposals,
                                          const std::vector<Proposal>& foretold,
                                          const std::vector<VesselTree>& portal_vein,
                                          const Eigen::Matrix3d& upright, std::vector<std::string>& doubts) {
  auto part = umbilical_part(portal_vein, upright);
  if (!part) {
    doubts.emplace_back("atlas.no_umbilical_part");
    return {};
  }
  if (perhaps_hepatic(portal_vein, foretold) ||
      is_on_right(*part, find(proposals, Structure::gallbladder_bed), upright.row(0))) {
    doubts.emplace_back("atlas.umbilical_part_elsewhere");
    return {};
  }
  return part;
}

bool agrees(const Proposal& notch, const UmbilicalPart& part, const Eigen::Matrix3d& upright,
            std::vector<std::string>& doubts) {
  const SeenNotch seen = seen_notch(part, upright);
  const Eigen::Vector3d off = seen.place - notch.points.row(0).transpose();
  if (off.dot((notch.covariances[0] + seen.spread).inverse() * off) <= kEllipsoid95) return true;
  const std::string code =
      notch.sources[0] == Source::person ? "atlas.mark_contradicted" : "atlas.contradiction";
  doubts.push_back(note(code + " umbilical_notch", 1e3 * off.norm(), 0));
  return false;
}

void draw_notch(Proposal& notch, const UmbilicalPart& part, const Eigen::Matrix3d& upright) {
  const SeenNotch seen = seen_notch(part, upright);
  Eigen::Vector3d point = notch.points.row(0);
  fuse(point, notch.covariances[0], seen.place, seen.spread.inverse());
  notch.points.row(0) = point.transpose();
  notch.sources[0] = Source::both;
}

void draw_line(Proposal& line, const UmbilicalPart& part, const Eigen::Matrix3d& upright) {
  const Eigen::Vector3d left = upright.row(0);
  for (Eigen::Index k = 0; k < line.points.rows(); ++k) {
    Eigen::Matrix3d& spread = line.covariances[static_cast<std::size_t>(k)];
    Eigen::Vector3d point = line.points.row(k);
    const double deviation = std::hypot(kVeinDeviation, kTilt * (point - part.tip.xyz).norm());
    if (deviation * deviation > left.dot(spread * left)) continue;  // statistics know it better
    const double across = (part.tip.xyz - point).dot(left) + kToNotch.x();
    fuse(point, spread, point + across * left, left * left.transpose() / (deviation * deviation));
    line.points.row(k) = point.transpose();
    line.sources[static_cast<std::size_t>(k)] = Source::both;
  }
}

}  // namespace glisson::atlas
