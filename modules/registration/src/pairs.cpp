// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "penalty.h"

namespace glisson::registration {
namespace {

/// The notch pulls like what 1 cm2 holds at the paper's density, however many points were labelled.
constexpr double kNotchPoints = 3.9;

void check(const LabelledCloud& cloud) {
  const auto n = static_cast<std::size_t>(cloud.size());
  if (cloud.size() < kMinimumPoints)
    throw InputError("cloud", "points",
                     "there are " + std::to_string(cloud.size()) + ", at least 10 are needed",
                     "Reconstruct with more features or larger regions");
  for (int i = 0; i < cloud.size(); ++i)
    if (!cloud.points.row(i).allFinite())
      throw InputError("cloud", "point " + std::to_string(i), "a coordinate is not a finite number",
                       "Remove the point");
  if (cloud.normals.rows() != 0 && cloud.normals.rows() != cloud.points.rows())
    throw InputError("cloud", "normals", "there are not as many as points", "Give one a point, or none");
  if (!cloud.features.empty() && cloud.features.size() != n)
    throw InputError("cloud", "labels", "there are not as many as points", "Give one a point, or none");
  require(cloud.looks.empty() ? cloud.eyes.rows() <= 1 : cloud.looks.size() == n && cloud.eyes.rows() > 0,
          "every point of joined looks is of one look, and each look has an eye");
  require(cloud.seen_from.rows() == 0 || cloud.seen_from.rows() == cloud.points.rows(),
          "every point that a moving camera saw has its eye");
  if (!cloud.sigma.empty() && cloud.sigma.size() != n)
    throw InputError("cloud", "sigma", "there are not as many as points", "Give one a point, or none");
}

/// Every so many-th of `count`, `wanted` in all.
int spread(int k, int count, int wanted) { return static_cast<int>(static_cast<long>(k) * count / wanted); }

/// Evenly in the cloud's own order, which tells nothing of place: features stay in proportion. Of a landmark
/// with few points these stay, look by look: without them a step would not know of it.
std::vector<int> thinned_rows(const LabelledCloud& cloud, int maximum) {
  constexpr int kOfLandmark = 5;  // as many as tell a margin that lies elsewhere
  std::vector<int> rows;
  rows.reserve(static_cast<std::size_t>(maximum));
  for (int k = 0; k < maximum; ++k) rows.push_back(spread(k, cloud.size(), maximum));
  struct Landmark {
    std::vector<int> all;
    int taken = 0;
  };
  std::map<std::pair<Feature, int>, Landmark> landmarks;  // by feature and look
  const auto of = [&](int i) -> Landmark& { return landmarks[{cloud.feature(i), cloud.look(i)}]; };
  for (int i = 0; i < cloud.size(); ++i)
    if (cloud.feature(i) != Feature::surface) of(i).all.push_back(i);
  for (const int i : rows)
    if (cloud.feature(i) != Feature::surface) ++of(i).taken;
  for (const auto& [key, found] : landmarks) {
    const int count = static_cast<int>(found.all.size()), wanted = std::min(count, kOfLandmark);
    for (int k = 0; found.taken < wanted && k < wanted; ++k)
      rows.push_back(found.all[static_cast<std::size_t>(spread(k, count, wanted))]);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Along a curve through the cells of a lattice of 1024 a side (Morton 1966).
std::vector<int> by_place(const Points& points) {
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const double side = std::max((points.colwise().maxCoeff() - low).maxCoeff(), 1e-9) / 1023.0;
  const auto spread_out = [](std::uint32_t bits) {  // two zeros between each two
    bits = (bits | bits << 16U) & 0x030000FFU;
    bits = (bits | bits << 8U) & 0x0300F00FU;
    bits = (bits | bits << 4U) & 0x030C30C3U;
    return (bits | bits << 2U) & 0x09249249U;
  };
  std::vector<std::pair<std::uint32_t, int>> cells;
  cells.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    std::uint32_t cell = 0;
    for (int axis = 0; axis < 3; ++axis)
      cell |= spread_out(static_cast<std::uint32_t>((points(i, axis) - low[axis]) / side)) << axis;
    cells.emplace_back(cell, static_cast<int>(i));
  }
  std::sort(cells.begin(), cells.end());
  std::vector<int> order;
  order.reserve(cells.size());
  for (const auto& [cell, point] : cells) order.push_back(point);
  return order;
}

/// @param apart only those of the same look: looks err each in a way of its own.
std::vector<std::vector<int>> nearest_neighbours(const LabelledCloud& cloud, int count, bool apart) {
  const Points& points = cloud.points;
  const int n = cloud.size();
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(n));
  std::vector<std::pair<double, int>> distances;
  for (int i = 0; i < n; ++i) {
    distances.clear();
    for (int j = 0; j < n; ++j)
      if (j != i && (!apart || cloud.look(j) == cloud.look(i)))
        distances.emplace_back((points.row(j) - points.row(i)).squaredNorm(), j);
    const int found = std::min(count, static_cast<int>(distances.size()));
    std::partial_sort(distances.begin(), distances.begin() + found, distances.end());
    auto& own = neighbours[static_cast<std::size_t>(i)];
    for (int k = 0; k < found; ++k) own.push_back(distances[static_cast<std::size_t>(k)].second);
  }
  return neighbours;
}

/// A_i: the area of the disc up to the k-th neighbour, over k. Beside holes and borders this takes in what
/// was not seen, so no point stands for more than three times the median.
/// @param around each point's neighbours in all looks together, so that what is seen twice counts once.
void weigh_surface(PreparedCloud& prepared, const std::vector<std::vector<int>>& around,
                   double reference_area) {
  std::vector<double> areas(prepared.weight.size(), 0.0), of_surface;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto& neighbours = around[i];
    const double reach = (prepared.cloud.points.row(neighbours.back()) -
                          prepared.cloud.points.row(static_cast<Eigen::Index>(i)))
                             .squaredNorm();
    areas[i] = std::numbers::pi * reach / static_cast<double>(neighbours.size());
    if (prepared.cloud.feature(static_cast<int>(i)) == Feature::surface) of_surface.push_back(areas[i]);
  }
  const double most = of_surface.empty() ? 0.0 : 3.0 * upper_median(of_surface);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    prepared.surface_weight.push_back(std::min(areas[i], most) / reference_area);
    if (prepared.cloud.feature(static_cast<int>(i)) == Feature::surface)
      prepared.weight[i] = prepared.surface_weight[i];
  }
}

/// By length. Centres one reference spacing apart are chosen along the margin; the points nearest to one
/// centre share a weight of 1.
void weigh_margin(PreparedCloud& prepared, double spacing) {
  std::vector<int> centres, members, cell(prepared.weight.size(), -1);
  const Points& points = prepared.cloud.points;
  for (int i = 0; i < prepared.cloud.size(); ++i) {
    if (prepared.cloud.feature(i) != Feature::anterior_margin) continue;
    int nearest = -1;
    double best = spacing;
    for (std::size_t c = 0; c < centres.size(); ++c) {
      const double d = (points.row(centres[c]) - points.row(i)).norm();
      if (d < best) best = d, nearest = static_cast<int>(c);
    }
    if (nearest < 0) {
      nearest = static_cast<int>(centres.size());
      centres.push_back(i);
      members.push_back(0);
    }
    cell[static_cast<std::size_t>(i)] = nearest;
    ++members[static_cast<std::size_t>(nearest)];
  }
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (cell[i] >= 0) prepared.weight[i] = 1.0 / members[static_cast<std::size_t>(cell[i])];
}

/// Each look's mark is one of its own.
void weigh_notch(PreparedCloud& prepared) {
  const LabelledCloud& cloud = prepared.cloud;
  prepared.notch_points.assign(static_cast<std::size_t>(cloud.look_count()), 0);
  for (int i = 0; i < cloud.size(); ++i)
    if (cloud.feature(i) == Feature::umbilical_notch)
      ++prepared.notch_points[static_cast<std::size_t>(cloud.look(i))];
  for (int i = 0; i < cloud.size(); ++i)
    if (cloud.feature(i) == Feature::umbilical_notch)
      prepared.weight[static_cast<std::size_t>(i)] =
          std::min(1.0, kNotchPoints / prepared.notch_points[static_cast<std::size_t>(cloud.look(i))]);
}

/// The middle of what each look has marked as the notch, one row a look; zero: nothing.
Points notches_of(const PreparedCloud& prepared) {
  Points middles = Points::Zero(prepared.cloud.look_count(), 3);
  for (int i = 0; i < prepared.cloud.size(); ++i)
    if (prepared.cloud.feature(i) == Feature::umbilical_notch)
      middles.row(prepared.cloud.look(i)) += prepared.cloud.points.row(i);
  for (std::size_t look = 0; look < prepared.notch_points.size(); ++look)
    middles.row(static_cast<Eigen::Index>(look)) /= std::max(1, prepared.notch_points[look]);
  return middles;
}

/// Marks the pairs whose distance stands out from its neighbours'.
void reject_outliers(const PreparedCloud& cloud, const PairOptions& options, std::vector<Pair>& pairs) {
  std::vector<double> deviation(pairs.size(), 0.0), sizes;
  std::vector<double> around;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    around.clear();
    for (const int j : cloud.neighbours[i])
      if (pairs[static_cast<std::size_t>(j)].feature == pairs[i].feature)
        around.push_back(pairs[static_cast<std::size_t>(j)].on_model.distance);
    if (around.size() < 4) continue;
    deviation[i] = std::abs(pairs[i].on_model.distance - upper_median(around));
    sizes.push_back(deviation[i]);
  }
  const double usual = sizes.empty() ? 0.0 : upper_median(sizes);
  const double limit = std::max(options.outlier_floor, options.outlier_deviations * kDeviationPerMad * usual);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (deviation[i] > limit) pairs[i].kept = false;
}

}  // namespace

void CloudOptions::validate() const {
  const OptionCheck demand("cloud options");
  demand(reference_density_per_cm2 > 0.0, "reference_density_per_cm2", reference_density_per_cm2,
         "Give a positive number");
  demand(maximum_points >= 10, "maximum_points", maximum_points, "Give 10 or more");
  demand(neighbours >= 1, "neighbours", neighbours, "Give 1 or more");
}

void PairOptions::validate() const {
  const OptionCheck demand("pair options");
  demand(minimum_normal_cosine >= -1.0 && minimum_normal_cosine <= 1.0, "minimum_normal_cosine",
         minimum_normal_cosine, "Give a number from -1 to 1");
  demand(outlier_deviations > 0.0, "outlier_deviations", outlier_deviations, "Give a positive number");
  demand(outlier_floor >= 0.0, "outlier_floor", outlier_floor, "Give a length from zero, in metres");
}

PreparedCloud prepare_cloud(const LabelledCloud& cloud, const CloudOptions& options) {
  options.validate();
  check(cloud);
  require(options.reference_density_per_cm2 > 0.0 && options.maximum_points >= kMinimumPoints &&
              options.neighbours >= 3,
          "a cloud is prepared with a positive density, ten points and three neighbours at least");
  PreparedCloud prepared;
  const int most = options.maximum_points;
  prepared.cloud = cloud.size() <= most ? cloud : rows_of(cloud, thinned_rows(cloud, most));
  prepared.neighbours = nearest_neighbours(prepared.cloud, options.neighbours, true);
  prepared.turn = by_place(prepared.cloud.points);
  prepared.weight.assign(static_cast<std::size_t>(prepared.cloud.size()), 0.0);
  const double reference_area = 1e-4 / options.reference_density_per_cm2;
  weigh_surface(prepared,
                prepared.cloud.look_count() == 1
                    ? prepared.neighbours
                    : nearest_neighbours(prepared.cloud, options.neighbours, false),
                reference_area);
  weigh_margin(prepared, std::sqrt(reference_area));
  weigh_notch(prepared);
  return prepared;
}

Points estimate_normals(const PreparedCloud& prepared) {
  const Points& points = prepared.cloud.points;
  Points normals(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const auto& neighbours = prepared.neighbours[static_cast<std::size_t>(i)];
    Eigen::RowVector3d mean = points.row(i);
    for (const int j : neighbours) mean += points.row(j);
    mean /= static_cast<double>(neighbours.size() + 1);
    Eigen::Matrix3d covariance = (points.row(i) - mean).transpose() * (points.row(i) - mean);
    for (const int j : neighbours) covariance += (points.row(j) - mean).transpose() * (points.row(j) - mean);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
    Eigen::Vector3d n = eigen.eigenvectors().col(0);
    if (n.dot(points.row(i).transpose() - prepared.cloud.eye(static_cast<int>(i))) > 0.0) n = -n;
    normals.row(i) = n.transpose();
  }
  return normals;
}

std::vector<Pair> find_pairs(const PreparedCloud& prepared, const MovingSurface& surface,
                             const PairOptions& options, const std::vector<Pair>& before) {
  options.validate();
  require(before.empty() || before.size() == static_cast<std::size_t>(prepared.cloud.size()),
          "pairs are found again for the cloud that they were found for");
  const LabelledCloud& cloud = prepared.cloud;
  std::vector<Pair> pairs(static_cast<std::size_t>(cloud.size()));
  const ClosestPoint notch = surface.notch();
  const Points notches = notches_of(prepared);
  NormalMemo normals;
  for (const int i : prepared.turn) {
    Pair& pair = pairs[static_cast<std::size_t>(i)];
    pair.point = i;
    pair.feature = cloud.feature(i);
    const bool at_notch = pair.feature == Feature::umbilical_notch && notch.triangle >= 0;
    const Eigen::Vector3d p = (at_notch ? notches.row(cloud.look(i)) : cloud.points.row(i)).transpose();
    if (at_notch)
      pair.on_model = notch;
    else
      pair.on_model = surface.closest(
          pair.feature, p, before.empty() ? -1 : before[static_cast<std::size_t>(i)].on_model.triangle);
    pair.gap = p - pair.on_model.point;
    pair.on_model.distance = pair.gap.norm();
    pair.normal = surface.normal(pair.on_model, normals);
    pair.deviation = surface.deviation(pair.feature, pair.on_model);
    // The ridge and the notch have no one normal: they are kept whatever the cloud's says.
    if (cloud.normals.rows() > 0 && pair.feature == Feature::surface &&
        pair.normal.dot(cloud.normals.row(i).transpose()) < options.minimum_normal_cosine)
      pair.kept = false;
  }
  reject_outliers(prepared, options, pairs);
  return pairs;
}

double landmark_share(Feature feature, double deviation) {
  const double own = feature == Feature::umbilical_notch ? kNotchSigma : kMarginSigma;
  if (feature == Feature::surface || deviation <= own) return 1.0;
  return (own / deviation) * (own / deviation);
}

SeenPlaces::SeenPlaces(const Points& cloud) {
  points_.reserve(static_cast<std::size_t>(cloud.rows()));
  for (const auto& point : cloud.rowwise()) points_.emplace_back(cell_of(point), point);
  std::ranges::sort(points_, {}, &std::pair<Cell, Eigen::RowVector3d>::first);
}

SeenPlaces::Cell SeenPlaces::cell_of(const Eigen::RowVector3d& at) {
  constexpr double kSide = 1.001 * kSeenWithin;  // no rounding takes a near point two cells away
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<std::size_t>(axis)] = static_cast<long>(std::floor(at[axis] / kSide));
  return cell;
}

bool SeenPlaces::is_seen(const Eigen::RowVector3d& at) const {
  const auto [x, y, z] = cell_of(at);
  for (const long i : {x - 1, x, x + 1})
    for (const long j : {y - 1, y, y + 1}) {
      // The three cells along z lie one after the other.
      auto point = std::ranges::lower_bound(points_, Cell{i, j, z - 1}, {},
                                            &std::pair<Cell, Eigen::RowVector3d>::first);
      for (; point != points_.end() && point->first <= Cell{i, j, z + 1}; ++point)
        if ((point->second - at).squaredNorm() < kSeenWithin * kSeenWithin) return true;
    }
  return false;
}

double seen_share(const TriangleMesh& surface, const Points& cloud) {
  const Eigen::VectorXd areas = vertex_areas(surface);
  const SeenPlaces places(cloud);
  double seen = 0.0;
  for (int v = 0; v < surface.vertex_count(); ++v)
    if (places.is_seen(surface.vertices.row(v))) seen += areas[v];
  return seen / areas.sum();
}

double mean_distance(const std::vector<Pair>& pairs) {
  double sum = 0.0;
  int count = 0;
  for (const Pair& pair : pairs)
    if (pair.kept) sum += pair.on_model.distance, ++count;
  return count > 0 ? sum / count : 0.0;
}

fem::AttachedLoad pair_load(const Pair& pair, const MovingSurface& surface, PenaltyForm form, double s,
                            double stiffness, double tangential) {
  // `clamped` and `printed` do not vanish at contact, where their direction flips: soften them over a tenth
  // of a millimetre.
  constexpr double kSoftening = 1e-4;
  fem::AttachedLoad load;
  const Carrier carrier = surface.carrier(pair.on_model);
  load.nodes = carrier.nodes;
  load.weights = carrier.weights;
  const double d = pair.gap.norm();
  const double secant = form == PenaltyForm::corrected ? 1.0 - 2.0 / std::numbers::pi * std::atan(s * d)
                                                       : penalty_force(form, s, d) / std::max(d, kSoftening);
  const Eigen::Matrix3d along = pair.normal * pair.normal.transpose();
  const Eigen::Matrix3d directions =
      form == PenaltyForm::corrected && pair.feature == Feature::surface
          ? Eigen::Matrix3d(along + tangential * (Eigen::Matrix3d::Identity() - along))
          : Eigen::Matrix3d::Identity();
  load.force = stiffness * secant * directions * pair.gap;
  load.tangent = stiffness * std::max(0.0, secant) * directions;
  return load;
}

}  // namespace glisson::registration
