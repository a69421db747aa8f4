// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {

struct ForceRows;
struct LinearPosterior;

/// How far off a lesion may be.
struct LesionError {
  Label lesion = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();      ///< where it is thought to be, camera frame, metres
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of that, m2
  double expected = 0.0;                                 ///< mean error that this implies, metres
  /// Half axes of the ellipsoid that holds it in 95 of 100 cases, metres, the longest first.
  Eigen::Vector3d half_axes_95() const;
};
/// Mean length of an error whose 95 % ellipsoid is that of this covariance, metres. Its tails are those of
/// Student's distribution of three degrees of freedom, as of registrations of development livers: most places
/// are known better than a normal distribution of the same ellipsoid has it, a few are not (EVIDENCE.md).
/// What is no number gives none, here and below.
double mean_error(const Eigen::Matrix3d& covariance);
/// Half axes of the ellipsoid that holds a place of this covariance in 95 of 100 cases, m, the longest first.
Eigen::Vector3d half_axes_95(const Eigen::Matrix3d& covariance);

/// What an ErrorModel takes for granted.
struct ErrorModelOptions {
  /// Deviation of a surface point that the registration weighed by (ShapeFitOptions::sigma_surface), m: a
  /// posterior is the error of an estimate by its own deviations. A noisier cloud counts by its noise.
  double sigma = 3e-3;
  /// Deviation of the patient's surface from the true one, m: segmentation and mesh. With the cloud's noise
  /// it says which misfit is to be expected.
  double surface = 1.5e-3;
  /// Independent information in what the reference density's one point stands for (ShapeFitOptions).
  double information = 0.2;
  /// Motion of a node, rms, m, by unforeseen forces beyond those that the prior knows (OperationOptions).
  double unforeseen = kUnforeseenMotion;
  std::vector<int> fixed_nodes;   ///< known to stay
  std::vector<double> stiffness;  ///< of each tetrahedron over the parenchyma's; empty: all 1
  bool pose_known = false;        ///< the model needs no turning and shifting
  /// @throws InputError naming the option.
  void validate() const;
};

/// What is not known of where a registered organ is: the posterior of pose, amplitudes of the operations'
/// modes and unforeseen forces anywhere on the surface, linearised where the registration has put it. Where
/// something is seen the cloud ties them down; elsewhere they remain, more so the farther away.
///
/// How large they are the cloud tells, too. Where it shows deformations that are larger than expected, so are
/// those that it does not show (variance of the amplitudes by their squares, empirical Bayes). And where
/// places of it are predicted worse by the others than they should be, all is less sure (the a posteriori
/// variance factor of adjustment theory). Neither factor is less than one.
class ErrorModel {
 public:
  /// @param prior null: unforeseen forces alone. @param amplitudes of its modes; empty: none.
  /// @param nodes where the organ is, camera's frame; @param camera_from_ct its rigid part.
  /// @param noise of the cloud's points, m. @throws InputError options. Cancelled: it is not finished, and of
  /// no use.
  ErrorModel(const PatientModel& model, const OperationPrior* prior, const Eigen::VectorXd& amplitudes,
             const CameraFromCt& camera_from_ct, const PointsIn<CameraFrame>& nodes,
             const PreparedCloud& cloud, double noise, const ErrorModelOptions& options = {},
             const RunContext& context = {});

  /// The nodes may as well be elsewhere, with this probability: adds the spread between the two.
  void add_rival(const PointsIn<CameraFrame>& elsewhere, double probability);

  /// Covariance of a point that moves with nodes of the mesh, m2, camera's frame. @pre as many weights.
  Eigen::Matrix3d covariance(const Eigen::Vector4i& nodes, const Eigen::Vector4d& weights) const;
  /// Of points that a binding to the model's mesh carries, one each.
  std::vector<Eigen::Matrix3d> covariances(const TetMesh& mesh, const Binding& points) const;
  /// Where a point that moves with nodes of the mesh may be, one posterior deviation a column: 3 x K, m; its
  /// covariance is this times its transpose. @pre as in covariance().
  Eigen::MatrixXd deviations(const Eigen::Vector4i& nodes, const Eigen::Vector4d& weights) const;
  /// How each row of a further cloud would answer to the same K deviations, of the linear model alone:
  /// size() x K, m.
  Eigen::MatrixXd answers(const ForceRows& rows) const;
  /// Variance of a row that stands for this much of the surface (m2), m2.
  double variance_of_area(double area) const;
  /// Of every node: the mean length of its error.
  Eigen::VectorXd expected() const;
  /// Of every node.
  SymmetricRows node_covariances() const;

  /// Places of the cloud, each predicted from all others: rms of the mean distance that remains, m, and in
  /// its standard deviations.
  struct HeldOut {
    double distance = 0.0, z = 0.0;
  };
  HeldOut held_out(const RunContext& context = {}) const;
  /// rms over places of the mean distance that the most probable motion leaves, m.
  double misfit() const;
  /// Squared amplitudes of modes and forces over what is expected of them.
  double strangeness() const;
  /// How many of them the cloud decides: their variance beforehand less what is left of it.
  double decided() const;
  /// By which share the organ would be larger, and its standard deviation.
  struct Size {
    double value = 0.0, sigma = 0.0;
  };
  Size size() const { return size_; }

 private:
  struct Unknowns;
  LinearPosterior posterior_of(const ForceRows& rows, const Unknowns& unknowns) const;
  void judge(const ForceRows& rows, const Unknowns& unknowns);
  void tell(const ForceRows& rows, const Unknowns& unknowns, const RunContext& context);

  Points nodes_;
  double point_variance_ = 0.0;         ///< of a row that stands for the reference density's one point, m2
  Eigen::Index places_of_cameras_ = 6;  ///< unknowns of the pose and of further looks; they come last
  Eigen::Index modes_ = 0;              ///< columns of the prior's modes; they come first
  Eigen::MatrixXd spread_;              ///< 3 N x K: motion of the nodes by one posterior deviation each
  double scale_ = 1.0;                  ///< of spread_ over the linear model's
  /// Of the noise that is to be expected, not of what these points show: whatever there is to doubt is judged
  /// by it.
  std::shared_ptr<const LinearPosterior> judged_;
  Size size_;
};

}  // namespace glisson::registration
