// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "glisson/atlas/member.h"
#include "glisson/atlas/shape_model.h"
#include "glisson/atlas/structure.h"
#include "glisson/core/chi_square.h"
#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"

/// @file
/// The atlas: a mean liver with its modes, and where structures lie on it. It is built from livers, kept as a
/// folder of standard files, and transferred to a patient (transfer.h).

namespace glisson::atlas {

/// The mean liver's frame: CT axes, metres, the members' mean origin and size.
struct MeanFrame {
  static constexpr const char* kName = "mean";
};

/// What one point of another structure tells of a structure: where that one lies d off from where it is
/// expected (mean's frame, metres), this one's k-th point is expected gains[k] d off.
struct Dependence {
  Structure on = Structure::umbilical_notch;
  int point = 0;                       ///< of `on`
  int livers = 0;                      ///< that show both
  std::vector<Eigen::Matrix3d> gains;  ///< one a point
  /// Of what the other one leaves, on livers that had no part in it: mean squares, one matrix a point, m2.
  std::vector<Eigen::Matrix3d> left;
};

/// Where a structure lies on the mean liver, and how far from there it was found on livers that had no part
/// in the prediction. K = point_count(structure).
struct StructureStatistics {
  Structure structure = Structure::umbilical_notch;
  std::string origin;  ///< name of the atlas whose members show it: another one's where it was taken over
  std::vector<std::string> members;  ///< that show it
  PointsIn<MeanFrame> mean;          ///< K x 3, metres
  /// Change of the K points (x0 y0 z0 x1 ...) per deviation of each of the first modes, metres. May have no
  /// column.
  Eigen::MatrixXd slopes;
  std::vector<PointsIn<MeanFrame>> residuals;  ///< one a member: truth - prediction without it, metres
  /// Of so many livers only the residuals' mean square is kept (one matrix a point, m2), neither names nor
  /// single residuals. 0: it is not.
  int summed_livers = 0;
  std::vector<Eigen::Matrix3d> summed;
  /// Deviation in any direction that the members do not show (metres): a population of synthetic livers is
  /// more regular than patients are.
  double added_deviation = 0.0;
  /// How unusual (over Atlas::usual) the livers were that it was set on: only beyond that it grows with what
  /// is doubted of a shape; where nothing is added, so do the members' own deviations. 1: as the members.
  double added_unusual = 1.0;
  /// What others tell of it, at most one point of each. None: it does not follow, or nobody knows.
  std::vector<Dependence> depends;
  /// Areas: for each vertex of the mean the share of members whose area it belongs to.
  Eigen::VectorXd share;

  /// How many livers show it.
  int livers() const { return summed_livers > 0 ? summed_livers : static_cast<int>(members.size()); }
};

/// A liver that the atlas was built from, as far as the atlas remembers it.
struct AtlasMember {
  std::string name;
  double weight = 1.0;         ///< below 1: it differs from the others
  double size = 0.0;           ///< metres, see size_of()
  double unusual = 0.0;        ///< see Atlas::usual, judged by an atlas without it
  double mean_distance = 0.0;  ///< metres, of its correspondence
};

/// What is known of livers, in the mean's frame.
struct Atlas {
  std::string name;
  Triangles triangles;  ///< of the mean's surface
  ShapeModel shape;     ///< CT axes; origin and size those of the members' mean
  std::vector<AtlasMember> members;
  std::vector<StructureStatistics> structures;
  double usual = 0.0;                               ///< how unusual() 95 % of the members are
  double log_size = 0.0, log_size_deviation = 0.0;  ///< of size_of() in metres

  TriangleMesh mean() const { return {shape.mean, triangles}; }
  /// Null: nothing is known of it.
  const StructureStatistics* find(Structure structure) const;
};

/// How far a shape lies from the model: root of the mean over modes and what they leave of
/// (distance / deviation)^2. About 1 for a member.
double unusual(const ShapeModel& model, const PointsIn<MeanFrame>& shape);

/// The covariance of one point of a structure (mean's frame, m2), so scaled that the 95 % ellipsoid of a
/// normal distribution holds 95 % although few livers show it (Hotelling 1931).
/// @param left_out a member whose residual is not used; -1: none.
/// @param growth of the deviations, for a shape that is more unusual than the members are: the members' own
///   grow by it (StructureStatistics::added_unusual), the added one by what it is over added_unusual.
Eigen::Matrix3d covariance(const StructureStatistics& statistics, int point, int left_out = -1,
                           double growth = 1.0);

/// The same once the place of what it depends on is known exactly. @param of the one that depends
Eigen::Matrix3d covariance(const StructureStatistics& of, const Dependence& on, int point,
                           double growth = 1.0);

/// Root of the mean trace of the covariances of a structure's points, metres.
double deviation(const StructureStatistics& statistics);

/// What became of one structure on a liver that had no part in its prediction.
struct LeftOutStructure {
  double mean_error = 0.0, max_error = 0.0;  ///< metres, over its points
  double area_distance = 0.0;  ///< areas: mean distance between both contacts, both ways, metres
  int inside = 0, points = 0;  ///< how many of its points lie in their 95 % ellipsoids
  double deviation = 0.0;      ///< metres, that was foretold (root of the mean trace)
  double area_largest = 0.0;   ///< areas: Hausdorff distance between both contacts, metres
};
/// A member met as a patient would be: laid on by the mean and modes of all the others.
struct LeftOut {
  std::string name;
  double mean_distance = 0.0, max_distance = 0.0;  ///< metres, between the surfaces
  double turned_deg = 0.0;                         ///< see Correspondence; so are the next two lines
  double misfit = 0.0, mirrored_misfit = 0.0;
  int folded = 0;
  double unusual = 0.0;  ///< as AtlasMember::unusual
  std::vector<std::string> doubts;
  std::map<Structure, LeftOutStructure> structures;
  /// Those that depend on the notch, foretold with the liver's own notch known (without the area).
  std::map<Structure, LeftOutStructure> with_notch;
};
/// How good a shape model is (Styner 2003), metres.
struct ModelQuality {
  double compactness_modes = 0;  ///< that explain 90 % of the variance
  double generality = 0.0;       ///< mean distance of a liver to its best instance by the others' modes
  double specificity = 0.0;      ///< mean distance of drawn instances to the closest member
};

/// An atlas, and what is to be expected of it.
struct BuildResult {
  Atlas atlas;
  std::vector<LeftOut> left_out;  ///< each member foretold by the others; in the members' order
  ModelQuality quality;
  /// How the members differ in where a structure's middle lies on the mean liver: root mean square over
  /// members of its distance from their mean, metres. Only of what the members themselves show.
  std::map<Structure, double> spreads;
  std::vector<std::string> notes;  ///< "atlas.outlier 0009 2.3", ...: codes with values
};

/// `atlas_...`: how many livers and modes, the model's quality, and how far off each structure was on a liver
/// that had no part in its prediction (mean and worst, mm; share of points in their 95 % ellipsoids);
/// `atlas_..._with_notch_...`: likewise with that liver's own notch known.
Figures figures_of(const BuildResult& built);

/// How an atlas is built.
struct BuildOptions {
  std::string name = "atlas";
  double share = 0.9;                                 ///< of the variance that the modes explain
  double added_deviation = 0.0, added_unusual = 1.0;  ///< see StructureStatistics
  /// The base's mean and modes stay; only where structures lie on them is learnt. Ellipsoids then grow only
  /// for shapes that are more unusual than these livers are. The atlas is called "BASE, NAME".
  bool keep_shape = false;
  bool summed = false;  ///< keeps no single liver's residuals (StructureStatistics::summed), nor its name
  int threads = 2;
  /// @throws InputError naming the option.
  void validate() const;
};

/// Builds an atlas (README: "Build"): every member by the template, alignment, modes; then each once more by
/// the others' mean and modes, which gives its structures' places and the honest errors.
/// @param base its mean is the template; what no five members show is taken over from it, and said.
/// @pre the base has a mean. Empty: cancelled.
/// @throws InputError a shape to be kept of a base that has none; fewer than 5 members, two of one name, a
/// plainly mirrored liver.
Cancellable<BuildResult> build(std::vector<Member> members, const Atlas& base, const BuildOptions& options,
                               const RunContext& context);

/// An atlas that is but a template: triangles and mean.
Atlas bare_atlas(const TriangleMesh& mean);

/// A folder with atlas.json and mean.vtp (millimetres), each written whole or not at all, one after the
/// other: for a new folder; see replace_atlas(). @throws FileError.
void write_atlas(const std::filesystem::path& folder, const Atlas& atlas);
/// Writes an atlas beside the folder and exchanges the two in one step: killed at any moment it leaves the
/// former atlas or the new one, whole, and beside it at most a hidden folder that the next one removes. Where
/// the file system cannot exchange, a kill between two renames leaves the former one as .NAME.former, where
/// read_atlas() finds it. Other files in the folder stay, and a link to it stays one; folders around it are
/// made. @throws FileError.
void replace_atlas(const std::filesystem::path& folder, const Atlas& atlas);
/// @throws FileError missing; InputError malformed, of another version, or of files that do not belong
/// together.
Atlas read_atlas(const std::filesystem::path& folder);

}  // namespace glisson::atlas
