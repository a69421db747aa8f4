// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "bezier.h"
#include "glisson/core/error.h"

namespace glisson::model {
namespace {

constexpr double kLeastSamples = 12, kSampleMm = 0.5;  // samples of a curve at least; their spacing
constexpr double kToleranceInVoxels = 0.5;             // how far a curve may pass from the smoothed path
constexpr double kLeastBendMm = 5.0;                   // over which a bend is measured, to either side
constexpr double kMostSmoothing = 3.0;                 // millimetres to either side
constexpr double kRadiusStepMm = 0.25;                 // radii that differ by less are as good as the same

/// Linear interpolation in a table over ascending stations.
template <class T>
T looked_up(const std::vector<double>& stations, const std::vector<T>& values, double station) {
  const auto above = std::upper_bound(stations.begin(), stations.end(), station);
  if (above == stations.begin()) return values.front();
  if (above == stations.end()) return values.back();
  const auto i = static_cast<std::size_t>(above - stations.begin());
  const double width = stations[i] - stations[i - 1],
               share = width > 0.0 ? (station - stations[i - 1]) / width : 0.0;
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

/// The path without the stairs of its voxels: means over a stretch about as long as the vessel is thick,
/// equally far to both sides, so that the ends stay.
std::vector<Eigen::Vector3d> without_stairs(const std::vector<Eigen::Vector3d>& points,
                                            const std::vector<double>& reach) {
  std::vector<Eigen::Vector3d> smooth = points;
  const int last = static_cast<int>(points.size()) - 1;
  for (int i = 1; i < last; ++i) {
    Eigen::Vector3d sum = points[i];
    int count = 1;
    for (int k = 1; i - k >= 0 && i + k <= last; ++k) {
      if ((points[i - k] - points[i]).norm() > reach[i] || (points[i + k] - points[i]).norm() > reach[i])
        break;
      sum += points[i - k] + points[i + k];
      count += 2;
    }
    smooth[i] = sum / count;
  }
  return smooth;
}

/// Distance of a point from a chain of segments.
double off_polyline(const std::vector<Eigen::Vector3d>& line, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector3d along = line[i] - line[i - 1];
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - line[i - 1]).dot(along) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, (p - line[i - 1] - t * along).norm());
  }
  return least;
}

/// Largest distance between two lines, either way.
double apart(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  double most = 0.0;
  for (const Eigen::Vector3d& p : a) most = std::max(most, off_polyline(b, p));
  for (const Eigen::Vector3d& p : b) most = std::max(most, off_polyline(a, p));
  return most;
}

}  // namespace

FittedTree::FittedTree(const VesselVoxels& vessel, const VolumeGrid& grid,
                       const std::vector<SkeletonPath>& paths, Label structure)
    : grid_(grid),
      structure_(structure),
      tolerance_mm_(kToleranceInVoxels * std::cbrt(vessel.mask.spacing_mm.prod())) {
  for (const SkeletonPath& path : paths) {
    require(path.parent < static_cast<int>(branches_.size()), "paths must come parents first");
    branches_.push_back(fit(vessel, path));
  }
}

FittedTree::Branch FittedTree::fit(const VesselVoxels& vessel, const SkeletonPath& path) const {
  Branch branch;
  branch.parent = path.parent;
  std::vector<Eigen::Vector3d> points;
  for (const int voxel : path.voxels) points.push_back(vessel.position_mm(voxel));
  if (path.parent >= 0) {
    const Branch& parent = branches_[static_cast<std::size_t>(path.parent)];
    branch.parent_station = parent.voxel_stations[static_cast<std::size_t>(path.parent_position)];
    points.front() = looked_up(parent.stations, parent.points, branch.parent_station);
    if ((points.front() - points[1]).norm() < 1e-9) points.front() = vessel.position_mm(path.voxels.front());
  }
  const double voxel = std::cbrt(vessel.mask.spacing_mm.prod());
  const double reach = std::max(4.0 * voxel, static_cast<double>(vessel.radius_mm[path.voxels.back()]));
  if (points.size() < 2) points.push_back(points.front() + Eigen::Vector3d(1e-3 * voxel, 0, 0));
  std::vector<double> smoothing;
  for (const int at : path.voxels)
    smoothing.push_back(std::clamp(static_cast<double>(vessel.radius_mm[at]), 2.5 * voxel,
                                   std::max(kMostSmoothing, 2.5 * voxel)));
  if (points.size() == smoothing.size()) points = without_stairs(points, smoothing);
  const CurveChain chain = fit_curves(points, tolerance_mm_, reach);

  std::vector<std::size_t> first_sample, samples;  // of each curve
  for (const CubicBezier& curve : chain.curves) {
    double polygon = 0.0;
    for (std::size_t k = 1; k < 4; ++k) polygon += (curve.control[k] - curve.control[k - 1]).norm();
    samples.push_back(
        static_cast<std::size_t>(std::max<double>(kLeastSamples, std::ceil(polygon / kSampleMm))));
    first_sample.push_back(branch.points.empty() ? 0 : branch.points.size() - 1);
    for (std::size_t k = branch.points.empty() ? 0 : 1; k <= samples.back(); ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(samples.back());
      const Eigen::Vector3d p = curve.at(t);
      branch.stations.push_back(
          branch.points.empty() ? 0.0 : branch.stations.back() + (p - branch.points.back()).norm());
      branch.points.push_back(p);
    }
  }
  branch.curve_error = apart(branch.points, points);
  for (const CurveParameter& parameter : chain.parameters) {
    const auto curve = static_cast<std::size_t>(parameter.curve);
    const double at = parameter.t * static_cast<double>(samples[curve]);
    const auto step = std::min(static_cast<std::size_t>(at), samples[curve] - 1);
    const std::size_t below = first_sample[curve] + step;
    branch.voxel_stations.push_back(branch.stations[below] +
                                    (at - static_cast<double>(step)) *
                                        (branch.stations[below + 1] - branch.stations[below]));
  }
  measure_radius(vessel, path, branch);
  measure_curvature(branch);
  return branch;
}

void FittedTree::measure_curvature(Branch& branch) {
  // The curves follow the voxels' noise within their tolerance, and its curvature is larger than the
  // vessel's. What bends a beam is the turn over about a vessel's thickness: that between the chords to
  // either side.
  for (std::size_t i = 0; i < branch.points.size(); ++i) {
    const double at = branch.stations[i];
    const double reach = std::min({std::max(2.0 * branch.radius[i], kLeastBendMm), at, branch.length() - at});
    if (reach < 0.5 * kLeastBendMm) {
      branch.curvature.push_back(-1.0);
      continue;
    }
    const Eigen::Vector3d back = branch.points[i] - looked_up(branch.stations, branch.points, at - reach),
                          forth = looked_up(branch.stations, branch.points, at + reach) - branch.points[i];
    branch.curvature.push_back(std::atan2(back.cross(forth).norm(), back.dot(forth)) / reach);
  }
  // Near the ends there are no two sides: as at the next place that has them.
  const auto known = [](double curvature) { return curvature >= 0.0; };
  const auto first = std::find_if(branch.curvature.begin(), branch.curvature.end(), known);
  if (first == branch.curvature.end()) {
    std::fill(branch.curvature.begin(), branch.curvature.end(), 0.0);
    return;
  }
  const auto last = std::find_if(branch.curvature.rbegin(), branch.curvature.rend(), known);
  std::fill(branch.curvature.begin(), first, *first);
  std::fill(branch.curvature.rbegin(), last, *last);
}

void FittedTree::measure_radius(const VesselVoxels& vessel, const SkeletonPath& path, Branch& branch) {
  const std::size_t count = branch.voxel_stations.size();
  std::vector<double> raw(count);
  // A path may run half a voxel beside the middle, where the boundary is nearer than the radius.
  const auto steps = vessel.steps();
  for (std::size_t i = 0; i < count; ++i) {
    const int voxel = path.voxels[std::min(i, path.voxels.size() - 1)];
    raw[i] = vessel.radius_mm[voxel];
    for (const auto& step : steps) raw[i] = std::max<double>(raw[i], vessel.radius_mm[voxel + step.offset]);
  }
  // Inside the parent's tube the distance to the boundary is the parent's radius, not the branch's.
  if (path.parent >= 0) {
    std::size_t out = 0;
    while (out + 1 < count && branch.voxel_stations[out] < 1.2 * raw[0]) ++out;
    std::fill(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(out), raw[out]);
  }
  // At its ends a vessel is closed by a cap, which is nearer than the wall.
  const double length = branch.voxel_stations.back();
  std::size_t first = 0, last = count - 1;
  while (path.parent < 0 && first + 1 < count && branch.voxel_stations[first] < raw[first]) ++first;
  while (last > first && length - branch.voxel_stations[last] < raw[last]) --last;
  if (path.parent < 0) std::fill(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(first), raw[first]);
  std::fill(raw.begin() + static_cast<std::ptrdiff_t>(last), raw.end(), raw[last]);
  // The distance to the boundary steps with the voxels: a mean over a stretch about as long as the vessel is
  // thick.
  std::vector<double> smooth(count);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0, weight = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double far = std::abs(branch.voxel_stations[k] - branch.voxel_stations[i]);
      if (far > std::max(0.6 * raw[i], 1.5)) continue;
      sum += raw[k];
      weight += 1.0;
    }
    smooth[i] = sum / weight;
  }
  for (const double station : branch.stations)
    branch.radius.push_back(looked_up(branch.voxel_stations, smooth, station));
  branch.mean_radius = std::accumulate(smooth.begin(), smooth.end(), 0.0) / static_cast<double>(count);
}

bool FittedTree::Leaf::before(const Leaf& other) const {
  if (branch < 0 || other.branch < 0) return other.branch < 0 && branch >= 0;
  const auto step = [](double radius) { return std::floor(radius / kRadiusStepMm); };
  return step(radius_mm) != step(other.radius_mm) ? step(radius_mm) < step(other.radius_mm)
                                                  : length_mm < other.length_mm;
}

FittedTree::Leaf FittedTree::next_to_prune() const {
  std::vector<char> bears(branches_.size(), 0);
  for (const Branch& branch : branches_)
    if (branch.parent >= 0) bears[static_cast<std::size_t>(branch.parent)] = 1;
  Leaf next;
  for (std::size_t b = 1; b < branches_.size(); ++b) {
    if (bears[b]) continue;
    const Leaf leaf{static_cast<int>(b), branches_[b].mean_radius, branches_[b].length()};
    if (leaf.before(next)) next = leaf;
  }
  return next;
}

void FittedTree::prune(const Leaf& leaf) {
  require(leaf.branch > 0 && leaf.branch < static_cast<int>(branches_.size()),
          "a leaf of this tree is pruned");
  branches_.erase(branches_.begin() + leaf.branch);
  for (Branch& branch : branches_)
    if (branch.parent > leaf.branch) --branch.parent;
}

double FittedTree::length_mm() const {
  double sum = 0.0;
  for (const Branch& branch : branches_) sum += branch.length();
  return sum;
}

double FittedTree::curve_error_mm() const {
  double most = 0.0;
  for (const Branch& branch : branches_) most = std::max(most, branch.curve_error);
  return most;
}

std::vector<double> FittedTree::fixed_stations(std::size_t branch, double shortest_mm) const {
  const double length = branches_[branch].length();
  std::vector<double> wanted;
  for (const Branch& child : branches_)
    if (child.parent == static_cast<int>(branch)) wanted.push_back(child.parent_station);
  std::sort(wanted.begin(), wanted.end());
  std::vector<double> fixed{0.0};
  for (const double station : wanted)
    if (station - fixed.back() >= shortest_mm && length - station >= shortest_mm) fixed.push_back(station);
  fixed.push_back(length);
  return fixed;
}

VesselTree FittedTree::sample(const Sampling& sampling) const {
  require(sampling.longest_mm >= sampling.shortest_mm && sampling.shortest_mm > 0.0 && sampling.turn > 0.0,
          "beam lengths must be positive and in order");
  VesselTree tree;
  tree.structure = structure_;
  tree.root = 0;
  std::vector<Eigen::Vector3d> nodes;
  struct Placed {
    double station;
    int node;
  };
  std::vector<std::vector<Placed>> placed(branches_.size());
  const auto add_node = [&](const Branch& branch, double station) {
    const Eigen::Vector3d mm = looked_up(branch.stations, branch.points, station);
    nodes.push_back(grid_.p_in_ct(mm.cwiseQuotient(grid_.spacing_mm)).xyz);
    tree.radii.push_back(1e-3 * looked_up(branch.stations, branch.radius, station));
    return static_cast<int>(nodes.size()) - 1;
  };
  for (std::size_t b = 0; b < branches_.size(); ++b) {
    const Branch& branch = branches_[b];
    int last = 0;
    if (branch.parent < 0) {
      last = add_node(branch, 0.0);
    } else {
      const auto& along = placed[static_cast<std::size_t>(branch.parent)];
      last =
          std::min_element(along.begin(), along.end(), [&](const Placed& x, const Placed& y) {
            return std::abs(x.station - branch.parent_station) < std::abs(y.station - branch.parent_station);
          })->node;
    }
    placed[b].push_back({0.0, last});
    const std::vector<double> fixed = fixed_stations(b, sampling.shortest_mm);
    for (std::size_t f = 1; f < fixed.size(); ++f) {
      // As many beams as the integral of 1 / (wanted length), each with the same share of it.
      std::vector<double> reached{0.0}, at{fixed[f - 1]};
      const int steps = std::max(8, static_cast<int>(2.0 * (fixed[f] - fixed[f - 1])));
      for (int s = 0; s < steps; ++s) {
        const double station = fixed[f - 1] + (fixed[f] - fixed[f - 1]) * (s + 0.5) / steps;
        const double bend = looked_up(branch.stations, branch.curvature, station);
        const double wanted = std::clamp(bend > 0.0 ? sampling.turn / bend : sampling.longest_mm,
                                         sampling.shortest_mm, sampling.longest_mm);
        reached.push_back(reached.back() + (fixed[f] - fixed[f - 1]) / steps / wanted);
        at.push_back(fixed[f - 1] + (fixed[f] - fixed[f - 1]) * (s + 1.0) / steps);
      }
      const int beams = std::max(1, static_cast<int>(std::ceil(reached.back() - 0.25)));
      for (int i = 1; i <= beams; ++i) {
        const double station = i == beams ? fixed[f] : looked_up(reached, at, reached.back() * i / beams);
        const int node = add_node(branch, station);
        tree.beams.push_back({last, node});
        placed[b].push_back({station, node});
        last = node;
      }
    }
  }
  tree.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    tree.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i].transpose();
  return tree;
}

}  // namespace glisson::model
