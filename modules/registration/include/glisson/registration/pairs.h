// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "glisson/patient/labelled_cloud.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/register.h"

namespace glisson::registration {

/// A cloud made ready for pairing: what depends on the cloud alone, computed once.
struct PreparedCloud {
  /// Thinned. All is in the left camera's frame, normals too; these are as given, and may be none.
  LabelledCloud cloud;
  /// What a point stands for: the share of the reference density's point on the surface (A_i / A_ref), of a
  /// reference spacing along the margin, of the notch. No unit; a cloud twice as dense has half the weights.
  std::vector<double> weight;
  /// What it stands for on the surface, whatever it is labelled: what lies on the margin or beside the notch
  /// lies on the surface as exactly as any other point. Of points of the surface the same as `weight`.
  std::vector<double> surface_weight;
  /// The nearest other points of the same look, nearest first; fewer in a small cloud.
  std::vector<std::vector<int>> neighbours;
  /// All points, those that are near each other one after the other: so a search finds in the cache what the
  /// last one has fetched. Each is as if it were alone.
  std::vector<int> turn;
  /// How many points show the notch, in each look: together they are one mark.
  std::vector<int> notch_points;

  /// What the cloud itself says of point i's error (LabelledCloud::sigma), m: as much across the surface as
  /// along the ray, which it is at most. 0: it says nothing.
  double deviation(int i) const {
    return cloud.sigma.empty() ? 0.0 : cloud.sigma[static_cast<std::size_t>(i)];
  }
};

/// Fewer points than this register nothing; nor do fewer of the surface among them.
inline constexpr int kMinimumPoints = 10;

/// How a cloud is weighed, thinned and linked.
struct CloudOptions {
  double reference_density_per_cm2 = 3.9;  ///< at which a point of the surface weighs 1
  int maximum_points = 2000;  ///< a larger cloud is thinned evenly, but for rare landmarks; weights make up
  int neighbours = 10;        ///< of each point
  /// @throws InputError naming the option.
  void validate() const;
};

/// Weighs, thins and links a cloud. @throws InputError options, fewer than 10 points, not finite, arrays of
/// unequal length.
PreparedCloud prepare_cloud(const LabelledCloud& cloud, const CloudOptions& options);

/// Unit normals from the neighbours' plane (principal components), turned towards the camera that saw them.
/// One row a point of the prepared cloud, in its frame.
PointsIn<CameraFrame> estimate_normals(const PreparedCloud& cloud);

/// A point of the cloud and where on the model it is thought to be.
struct Pair {
  int point = -1;
  Feature feature = Feature::surface;
  ClosestPoint on_model;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the model, outwards
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();     ///< cloud point - model point, metres
  double deviation = 0.0;  ///< of the landmark there, metres (MovingSurface::deviation)
  bool kept = true;
};

/// Deviations of margin points and of the notch's centroid where a person has marked the landmark, metres.
inline constexpr double kMarginSigma = 6e-3, kNotchSigma = 3e-3;
/// What a mark on a landmark of this deviation counts for, over one on a person's own: (own / deviation)^2 in
/// (0, 1]. @param deviation metres; what is below the feature's own is as a person's.
double landmark_share(Feature feature, double deviation);

/// Which pairs are not believed.
struct PairOptions {
  /// Cosine between the normals below which a pair is refused; used where the cloud has normals.
  double minimum_normal_cosine = 0.3;
  /// A distance is an outlier when it differs from its neighbours' median by more than `outlier_deviations`
  /// scaled MADs of all such differences, and by more than `outlier_floor` metres.
  double outlier_deviations = 4.0, outlier_floor = 3e-3;
  /// @throws InputError naming the option.
  void validate() const;
};

/// One pair a point, label-restricted: margin points go to the margin's part, the notch's points of a
/// look together to the carried landmark (all with the gap of their centroid: the region clicked around a
/// notch says where it is, not what its outline is); those against the normal and outliers are not `kept`.
/// Coherent distances, however large, are no outliers: a lobe that has moved far is what is looked for.
/// @param before pairs of the same cloud with this surface a little while ago, or none: the same pairs are
/// found, sooner.
/// @throws InputError options.
std::vector<Pair> find_pairs(const PreparedCloud& cloud, const MovingSurface& surface,
                             const PairOptions& options, const std::vector<Pair>& before = {});

/// What lies this near to a point of the cloud has been seen, metres: at the least density that the paper
/// needs (0.7 points per cm2) the points of a patch are 12 mm apart.
inline constexpr double kSeenWithin = 8e-3;
/// Where a cloud has shown something, so that many places are asked about soon.
class SeenPlaces {
 public:
  /// @param cloud metres
  explicit SeenPlaces(const Points& cloud);
  /// Whether any point of the cloud lies within kSeenWithin of a place in its frame, metres.
  bool is_seen(const Eigen::RowVector3d& at) const;

 private:
  using Cell = std::array<long, 3>;  ///< a cube that is a little larger than kSeenWithin
  static Cell cell_of(const Eigen::RowVector3d& at);
  std::vector<std::pair<Cell, Eigen::RowVector3d>> points_;  ///< by cell
};
/// Share of a surface's area that has been seen. Both in one frame.
double seen_share(const TriangleMesh& surface, const Points& cloud);
/// Below a fifth of the surface the paper's error is over its 3 mm (Fig. 8), and ours up to centimetres far
/// from what is seen.
inline constexpr double kLittleSeen = 0.2;
/// Mean distance of the cloud's points from the surface; beyond it is a doubt, m.
inline constexpr double kLargeResidual = 5e-3;

/// Mean distance over the kept pairs, metres; 0 when there are none.
double mean_distance(const std::vector<Pair>& pairs);

/// Eq. 14 as a load on the surface's nodes: force k w(s d) N gap, tangent k w(s d) N (the secant, positive
/// semi-definite), N = n n^T + tangential (I - n n^T) for surface points, the identity for margin and notch.
/// @param stiffness k of this pair, N/m. @param tangential share of k that resists sliding, in [0, 1].
fem::AttachedLoad pair_load(const Pair& pair, const MovingSurface& surface, PenaltyForm form, double s,
                            double stiffness, double tangential);

}  // namespace glisson::registration
