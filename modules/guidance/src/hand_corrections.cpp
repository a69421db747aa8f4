// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_corrections.h"

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"

namespace glisson::guidance {
namespace {

constexpr double kFarthest = 40e-3;  ///< metres; a start that is farther off is registered again
/// Metres: tissue beyond this from the corrected surface is not the organ's, and one beside its rim has no
/// place on it.
constexpr double kBindRadius = 8e-3, kBeside = 2e-3;

/// One of the two cameras, in the left one's frame.
struct OneView {
  OneView(const StereoRig& rig, StereoView view) : camera(view == StereoView::left ? rig.left : rig.right) {
    if (view == StereoView::left) return;
    right_from_left = {rig.right_from_left.rotation, rig.right_from_left.translation};
    eye = -right_from_left.rotation.transpose() * right_from_left.translation;
  }
  Eigen::Vector3d from_left(const Eigen::Vector3d& p) const {
    return right_from_left.rotation * p + right_from_left.translation;
  }
  /// Unit; empty where the lens maps nothing to the pixel.
  std::optional<Eigen::Vector3d> sight(const Eigen::Vector2d& pixel) const {
    const auto ray = camera.mapped_ray(pixel);
    if (!ray) return std::nullopt;
    return (right_from_left.rotation.transpose() * *ray).normalized();
  }

  const Camera& camera;
  RigidMotion right_from_left{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
};

std::optional<Anchor> moved(const Anchor& anchor, const registration::MovingSurface& before,
                            const registration::MovingSurface& after) {
  const Eigen::Vector3d tissue = anchor.place(before);
  const ClosestPoint at = after.closest(Feature::surface, tissue);
  if (at.triangle < 0 || at.distance > kBindRadius) return std::nullopt;
  const Anchor now{at, after.normal(at).dot(tissue - at.point)};
  if ((now.place(after) - tissue).norm() > kBeside) return std::nullopt;
  return now;
}

Rebind with_known(const std::unordered_map<int, Anchor>& known, const Rebind& otherwise) {
  return [&known, otherwise](int id, const Anchor& anchor) -> std::optional<Anchor> {
    const auto found = known.find(id);
    return found == known.end() ? otherwise(id, anchor) : std::optional(found->second);
  };
}

}  // namespace

HandCorrections::HandCorrections(const PatientModel& model, const StereoRig& rig,
                                 std::shared_ptr<const fem::CompositeModel> at_rest,
                                 registration::MovingSurface surface)
    : model_(model),
      rig_(rig),
      corrector_(std::move(at_rest), surface),
      surface_(std::move(surface)),
      shape_(corrector_.registered()) {}

Points HandCorrections::carried(const Points& motions, const Points& present) const {
  return motions * fit_rigid_motion(shape_, present, {}).rotation.transpose();
}

SightPull HandCorrections::pull_of(const Correction& correction, const Points& present) const {
  const auto refuse = [](const char* what, const char* remedy) {
    throw InputError("correction", "the place", what, remedy);
  };
  SightPull pull;
  const Binding binding = bind_points(model_.mesh, correction.place_in_ct.transpose(), false);
  for (int k = 0; k < 4; ++k) {
    pull.nodes[static_cast<std::size_t>(k)] = model_.mesh.tetrahedra(binding.tetrahedron[0], k);
    pull.weights[static_cast<std::size_t>(k)] = binding.weights(0, k);
  }
  const OneView view(rig_, correction.view);
  const Eigen::Vector3d place = pull.place(present), in_view = view.from_left(place);
  if (!(in_view.z() > 0.0)) refuse("is behind the camera", "Correct what the picture shows");
  // The hand saw a picture that may be older than the last one: how far it dragged is what it said.
  const Eigen::Vector2d target = view.camera.project(in_view) + correction.to - correction.from;
  const auto sight = view.sight(target);
  if (!view.camera.maps(in_view) || !view.camera.sees(target) || !sight)
    refuse("would be outside of the picture", "Drag to where the picture shows it");
  const Eigen::Vector3d way = view.eye + *sight * sight->dot(place - view.eye) - place;
  if (way.norm() > kFarthest) refuse("is more than 40 mm from where it is drawn", "Register again");
  const Eigen::Matrix3d back = fit_rigid_motion(present, shape_, {}).rotation;
  pull.target = pull.place(shape_) + back * way;
  pull.sight = back * *sight;
  pull.sigma = correction.sigma_px * in_view.z() / view.camera.matrix(0, 0);
  return pull;
}

Points HandCorrections::places(const std::unordered_map<int, Anchor>& anchors, const Points& shape) const {
  registration::MovingSurface surface = surface_;
  surface.move(shape);
  std::vector<int> ids;  // in an order that repeats
  ids.reserve(anchors.size());
  for (const auto& [id, anchor] : anchors) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  Points places(static_cast<Eigen::Index>(ids.size()), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    places.row(i) = anchors.at(ids[static_cast<std::size_t>(i)]).place(surface).transpose();
  return places;
}

HandCorrections::Proposal HandCorrections::propose(const Correction& correction, const Points& present,
                                                   const std::unordered_map<int, Anchor>& anchors) const {
  correction.validate();
  Proposal proposal;
  proposal.correction = correction;
  proposal.replaces =
      correction.gesture != 0 && !made_.empty() && made_.back().correction.gesture == correction.gesture;
  proposal.pull = pull_of(correction, present);
  // Told as one drag in the last frame, from where the place would be without it.
  const OneView view(rig_, correction.view);
  proposal.correction.to =
      view.camera.project(view.from_left(proposal.pull.place(present))) + correction.to - correction.from;
  const Points before =
      proposal.replaces ? Points(present + carried(last().shape - shape_, present)) : present;
  proposal.correction.from = view.camera.project(view.from_left(proposal.pull.place(before)));
  std::vector<SightPull> pulls = before_;
  pulls.insert(pulls.end(), pulls_.begin(), pulls_.end());
  if (proposal.replaces) pulls.pop_back();
  pulls.push_back(proposal.pull);
  proposal.shape = corrector_.solve(
      pulls, proposal.replaces ? places(last().followed, last().shape) : places(anchors, shape_));
  return proposal;
}

void HandCorrections::accept(const Proposal& proposal, Step former, const OverlayFrame& overlay) {
  if (proposal.replaces) {
    made_.pop_back();
    pulls_.pop_back();
  } else {
    steps_.push_back(std::move(former));
  }
  CorrectionMade made;
  made.correction = proposal.correction;
  made.frame = overlay.index;
  made.seconds = overlay.seconds;
  made.moved = (proposal.shape - last().shape).rowwise().norm().mean();
  made_.push_back(made);
  pulls_.push_back(proposal.pull);
  shape_ = proposal.shape;
  surface_.move(shape_);
}

void HandCorrections::take_back() {
  shape_ = std::move(steps_.back().shape);
  surface_.move(shape_);
  steps_.pop_back();
  made_.pop_back();
  pulls_.pop_back();
}

HandCorrections::Renewal HandCorrections::renewed(std::shared_ptr<const fem::CompositeModel> at_rest,
                                                  const Points& registered,
                                                  const std::unordered_map<int, Anchor>& anchors) const {
  registration::MovingSurface surface = surface_;
  surface.move(registered);
  Renewal renewal{Corrector(std::move(at_rest), std::move(surface)), registered};
  std::vector<SightPull> pulls = before_;
  pulls.insert(pulls.end(), pulls_.begin(), pulls_.end());
  if (!pulls.empty()) renewal.shape = renewal.corrector.solve(pulls, places(anchors, shape_));
  return renewal;
}

void HandCorrections::accept(Renewal renewal) {
  corrector_ = std::move(renewal.corrector);
  shape_ = std::move(renewal.shape);
  surface_.move(shape_);
  before_.insert(before_.end(), pulls_.begin(), pulls_.end());
  pulls_.clear();
  made_.clear();
  steps_.clear();
}

BindingChange HandCorrections::change_to(const Points& shape) const {
  auto after = std::make_shared<registration::MovingSurface>(surface_);
  after->move(shape);
  BindingChange change;
  change.of_followed = change.of_remembered = [this, after](int, const Anchor& anchor) {
    return moved(anchor, surface_, *after);
  };
  change.of_surface = [this, after](const ClosestPoint& at) -> std::optional<ClosestPoint> {
    const std::optional<Anchor> now = moved({at, 0.0}, surface_, *after);
    return now ? std::optional(now->at) : std::nullopt;
  };
  return change;
}

BindingChange HandCorrections::change_back() const {
  BindingChange change = change_to(last().shape);
  change.of_followed = with_known(last().followed, change.of_followed);
  change.of_remembered = with_known(last().remembered, change.of_remembered);
  return change;
}

}  // namespace glisson::guidance
