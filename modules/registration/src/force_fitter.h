// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "evidence.h"
#include "force_patches.h"
#include "force_rows.h"
#include "glisson/registration/contact_forces.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {

/// Log evidence of a fit and of its law, up to a constant: what laws are compared by.
double log_posterior(const LawFit& law);

/// What all laws' fits of one cloud share. Read only.
struct ForceProblem {
  const PatientModel& model;
  const ContactForceOptions& options;
  PreparedCloud cloud;
  MovingSurface surface;
  fem::ElasticBody body;
  ForceSurface force_surface;
  CameraFromCt start;
  double told_noise;        ///< deviation that the cloud itself tells of its points, m; 0: none
  bool grounded;            ///< nothing is fixed: springs to the ground hold the body
  bool free_pose;           ///< the pose is found, too
  fem::NodalColumns modes;  ///< of the prior; no columns: none

  ForceProblem(const PatientModel& model, const LabelledCloud& cloud, const CameraFromCt& start,
               const ContactForceOptions& options);
  /// Another cloud of the same organ, for the fits that begin from now on.
  void take(const LabelledCloud& next);
};

/// One law, all stages.
class ForceFitter {
 public:
  ForceFitter(const ForceProblem& problem, const fem::BodyMaterial& material, double ground);
  /// Begins where another fit of the same problem has ended, two stages before the end.
  void begin_at(const ForceFitter& other);
  /// @param x nodes in the CT frame. @param strongest nodes where forces act, the strongest first.
  /// @param first_sigma stages of more noise are left out.
  void begin_at(const CameraFromCt& pose, const Points& x, const std::vector<int>& strongest,
                double first_sigma);
  void begin_at(const ContactForceOptions::Place& place, std::size_t number);
  /// How far the cloud lies from the model there, along the normals: median of the sizes, m.
  double apart(const CameraFromCt& pose, const Points& x);
  /// @return false: cancelled. `advance` is called after each stage.
  bool run(const RunContext& context, const std::function<void()>& advance);
  /// With the forces and the expected error.
  ContactForceFit result() const;
  const LawFit& law() const { return best_.law; }

 private:
  struct State {
    CameraFromCt pose;
    Points x;           ///< CT frame
    LookMotions looks;  ///< of a joined cloud
    LawFit law;
    std::vector<ForcePatch> patches;
    Eigen::VectorXd modes;  ///< their amplitudes, standard deviations
    Eigen::VectorXd amplitudes;
    Eigen::VectorXd expected_error;
    Eigen::VectorXd deviations;  ///< of the amplitudes
    double outlier_share = 0.0;
    int inverted = 0;
  };
  /// Moves the surface to where the model is, and the cloud to it: CT frame.
  PreparedCloud onto_model();
  ForceRows pair(double sigma);
  double energy(const Points& x, Points* gradient) const;
  /// @return false: cancelled.
  bool choose_patches(const ForceRows& rows, double sigma, const RunContext& context);
  void refine_patches(double sigma);
  /// The nodes at the patches' centres, that of the strongest force first.
  static std::vector<int> strongest(const State& state);
  Eigen::MatrixXd design(const ForceRows& rows) const;
  Eigen::VectorXd fixed_variances() const;
  /// The rest shape that amplitudes of the modes make.
  Points shape(const Eigen::VectorXd& amplitudes) const;
  bool stage(double sigma, const RunContext& context);
  bool settle(const RunContext& context);
  double step(const EvidencePosterior& found, const Points& relax);
  /// Of the pose and of further looks that are found with it.
  Eigen::Index pose_columns() const;
  void turn_pose(const Eigen::VectorXd& twist);
  void turn_look(std::size_t look, const Eigen::VectorXd& twist);
  void keep(const EvidencePosterior& found);

  const ForceProblem& problem_;
  fem::ElasticBody body_;
  MovingSurface surface_;
  Eigen::VectorXd springs_;
  Eigen::Vector3d centre_;
  State now_, best_;
  fem::NodalColumns responses_;  ///< displacements for a unit of each patch's x, y, z
  Eigen::VectorXd variances_;
  std::vector<int> strongest_;  ///< strongest() of the last stage
  bool factorised_ = false;
  double first_sigma_;
  int iterations_ = 0;
};

}  // namespace glisson::registration
