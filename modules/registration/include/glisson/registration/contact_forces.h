// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/elastic_body.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/registration/rivals.h"
#include "glisson/registration/shape_fit.h"

namespace glisson::registration {

/// Where the organ is, from the forces that act on it: unknown forces on patches of the surface, few of which
/// act (evidence.h), deform the body under an elastic law; closest points of the cloud say, along the
/// surface's normal alone, what they do. The law, how far the supports give way and the noise are those under
/// which the cloud is most probable. Lengths in metres; forces for a Young's modulus of 1 Pa.
struct ContactForceOptions {
  /// Laws that are tried first. The linear one has odds of 1 to 20 beforehand: it takes turns for strains.
  std::vector<fem::BodyMaterial> materials{{fem::BodyLaw::linear, 0.45}, {fem::BodyLaw::neo_hookean, 0.45}};
  /// That the most probable law is tried with after that; the most probable of all is kept.
  std::vector<double> poisson_ratios{0.41, 0.48};
  /// Standard deviations of the cloud across the surface, stage by stage. The stage under which the cloud is
  /// most probable is the last: the noise is not known. Without a prior it goes on while it moves by more
  /// than its deviation and becomes more probable, five stages at most; and a law that was still moving
  /// begins again where the most probable one has ended. Where the cloud tells deviations of its points these
  /// are the least.
  std::vector<double> sigmas{8e-3, 4e-3, 2e-3, 1e-3, 0.5e-3};
  /// Independent information in what the reference density's one point stands for (ShapeFitOptions): the
  /// error of a patient's surface is shared by neighbours. Empty: each point of the cloud is independent.
  std::optional<double> information;
  /// What a force has to add to the log evidence, over the logarithm of the number of patches: 1 is a prior
  /// under which one of all patches acts. 0: as many act as make the cloud most probable.
  double patch_price = 0.0;
  std::vector<int> fixed_nodes;   ///< stay where the start puts them
  std::vector<double> stiffness;  ///< of each tetrahedron relative to the others; empty: all alike
  bool pose_known = false;        ///< the start is where the model is, not a guess
  /// Where no node is fixed the pose is found, too (unless it is known), and springs to the ground stand for
  /// supports that nobody knows: stiffness of each node's over (its volume times E / (0.1 m)^2). The most
  /// probable one under the last of the laws is kept, and all laws are tried with it.
  std::vector<double> grounds{0.01, 0.045, 0.2, 0.9};
  /// What operations do to this organ; null: not known. The body's shape without contact forces is then a
  /// shape that the prior makes probable, found together with them: y ~ N(0, Sigma + A Gamma A^T + B B^T).
  std::shared_ptr<const OperationPrior> prior;
  Eigen::VectorXd amplitudes;  ///< of the prior's modes to start with; empty: none
  LookMotions looks;           ///< of a joined cloud to start with; found together with the pose
  /// Where the pose is found: other places where the organ may be. Each is tried under the law that was most
  /// probable from the first one; the most probable of all is kept.
  struct Place {
    CameraFromCt camera_from_ct;
    Eigen::VectorXd amplitudes;  ///< as above; empty: at rest
    LookMotions looks;
  };
  std::vector<Place> other_places;
  double patch_spacing = 12.5e-3, patch_radius = 20e-3;
  double patch_reach = 8e-3;  ///< of patches from what is seen
  int iterations = 4;         ///< a stage, each with new closest points
  /// At which a point's weight is a half (Cauchy), or two sigmas if that is more.
  double outlier_distance = 3e-3;
  double max_step = 20e-3;  ///< of a node in an iteration
  int most_points = 500;    ///< a larger cloud is thinned evenly
  int threads = 2;          ///< 1 or 2: the same bits
  /// @throws InputError naming the option.
  void validate() const;
};

/// One law's fit.
struct LawFit {
  fem::BodyMaterial material;
  double ground = 0.0;
  std::size_t place = 0;  ///< where it began: 0 the start, k the k-th of the other places
  /// Of the last stage, ln, less the price of its forces; minus infinity: the mechanics failed.
  double log_evidence = 0.0;
  double sigma = 0.0;     ///< of the most probable stage, m
  double residual = 0.0;  ///< mean distance of the cloud along the normals, m
  /// Mean distance of the nodes from where the chosen law puts them, m.
  double away = 0.0;
  Termination termination = Termination::diverged;  ///< converged: the last step was under sigma
};

/// A patch on which a force acts.
struct ContactForce {
  int node = -1;                                    ///< at its centre
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N for E = 1 Pa, CT frame
  double deviation = 0.0;                           ///< of each component, posterior, likewise
};

/// The fit under the most probable law, with what the other laws say of it.
struct ContactForceFit {
  CameraFromCt camera_from_ct;
  Points nodes_in_camera;
  std::vector<LawFit> laws;          ///< as tried
  int chosen = -1;                   ///< of laws
  std::vector<ContactForce> forces;  ///< those over 2 % of the strongest, which comes first
  int patches = 0;                   ///< offered
  Eigen::VectorXd amplitudes;        ///< of the prior's modes, standard deviations
  LookMotions looks;                 ///< of a joined cloud; empty: it is of one look
  /// Root mean square of each node's error that the posterior of forces and pose expects, m, with the spread
  /// between laws, each as probable as the cloud makes it. It knows of the noise and of forces where
  /// something is seen, not of forces elsewhere.
  Eigen::VectorXd expected_error;
  std::vector<OtherFit> others;  ///< under other laws or from other places
  double residual = 0.0;         ///< mean distance along the normals, m
  double outlier_share = 0.0;    ///< of the points, those that weigh less than a half
  int inverted = 0;              ///< tetrahedra
  /// Share of the volume that is stretched to more than twice its length or pressed to less than half of it.
  double torn = 0.0;
  int iterations = 0;
  Termination termination = Termination::diverged;
};

/// Whether no tissue is so: more than one in a thousand elements, and more than five, are turned inside out,
/// or more than a fiftieth of the volume is torn; liver tears at about 1.4 times its length (Brunon 2010).
/// Right fits have little of either, where a force acts on a place smaller than the elements; the cloud of
/// something else is often explained by much. Elements of a coarse mesh are turned by right fits, too, where
/// a force acts on one or two of them.
/// @param elements of the model's mesh.
bool is_beyond_tissue(const ContactForceFit& fit, int elements);

/// Whether another elastic law explains the cloud nearly as well (e^5 in the odds) and puts the nodes 5 mm
/// away on average. Not the same law on other supports or in another place: of these rivals and expected
/// errors tell.
/// @pre a law was chosen.
bool is_law_ambiguous(const ContactForceFit& fit);

}  // namespace glisson::registration
