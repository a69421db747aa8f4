// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/tracker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "anchored_points.h"
#include "cloud_follower.h"
#include "few_points.h"
#include "followed_body.h"
#include "frame_clock.h"
#include "glisson/core/error.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/refusal.h"
#include "hand_corrections.h"
#include "held_out.h"
#include "holding.h"
#include "judge.h"
#include "look_again.h"
#include "point_memory.h"
#include "reduced_views.h"
#include "relocator.h"
#include "stereo_follower.h"

namespace glisson::guidance {
namespace {

/// A new point must lie this near the model to be taken for one of the organ's, metres.
constexpr double kBindRadius = 8e-3;
/// New points are looked for when this share is missing.
constexpr double kMissing = 0.1;
/// A gap counts as consistent up to this difference from its neighbours' median: metres across the line of
/// sight, or scaled MADs of all differences, whichever is more.
constexpr double kConsistentFloor = 1.5e-3, kConsistentDeviations = 4.0;
/// Metres. Where the organ is found this near, it was not lost.
constexpr double kFoundElsewhere = 2e-3;
constexpr int kLeastLooks = 3;          ///< of fresh stereo at the tissue, before they say anything together
constexpr double kKeyFrameEvery = 3.0;  ///< seconds of valid frames
constexpr double kGentle = 1.0;         ///< seconds in which the picture goes over to another registration

double mean_norm(const std::vector<Eigen::Vector3d>& vectors) {
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += v.norm();
  return vectors.empty() ? 0.0 : sum / static_cast<double>(vectors.size());
}

}  // namespace

struct Tracker::Impl {
  Impl(const PatientModel& model, const Registration& start, const TrackerOptions& given)
      : options(checked(model, start, given)),
        patient(model),
        body(model, start.nodes_in_camera, options),
        clouds(model, start, options),
        lesions(model, start, options.lesions),
        doubtful(registration::is_in_doubt(start)) {}

  static void check(const PatientModel& model, const Registration& start) {
    if (start.nodes_in_camera.rows() != model.mesh.vertex_count())
      throw InputError("start", "nodes",
                       "there are " + std::to_string(start.nodes_in_camera.rows()) + ", the model has " +
                           std::to_string(model.mesh.vertex_count()),
                       "Give a registration of this model");
    if (!start.nodes_in_camera.allFinite())
      throw InputError("start", "nodes", "a coordinate is not a finite number", "Register again");
  }

  static TrackerOptions checked(const PatientModel& model, const Registration& start,
                                const TrackerOptions& options) {
    options.validate();
    check(model, start);
    for (const int node : options.fixed_nodes)
      if (node < 0 || node >= model.mesh.vertex_count())
        throw InputError("fixed nodes", "node " + std::to_string(node),
                         "the mesh has nodes 0 to " + std::to_string(model.mesh.vertex_count() - 1),
                         "Give 0-based node numbers of this mesh");
    return options;
  }

  void begin(const StereoRig& whole, const StereoFrame& whole_first, const Picture& whole_mask) {
    const ReducedViews reduced(whole);
    reduced.require_frame(whole_first);
    const StereoRig& rig = reduced.rig();
    const StereoFrame first = reduced.reduced(whole_first);
    FollowerOptions follow;
    follow.points = options.points;
    follow.forward_backward_px = options.forward_backward_px;
    follow.epipolar_px = options.epipolar_px;
    follow.window_px = options.window_px;
    follow.levels = options.levels;
    if (options.hold_start) body.rest_here();
    parts = seen_parts(first, rig, reduced.reduced_mask(whole_mask));
    views = reduced;
    followed_mask = reduced.reduced(given_mask);
    follower.emplace(rig, follow);
    follower->begin(first, parts);
    anchors.clear();
    memory.emplace(rig);
    hand.emplace(patient, whole, options.hold_start ? body.composite() : body.resting_in(body.positions()),
                 body.surface());
    frames = last_valid = 0;
    last = {};
    going_over.reset();
    tissue.reset();
    camera = rig.left;
    seen = seen_area(body.surface().mesh(), camera);
    held_out.emplace(rig, options.window_px, options.most_masked);
    held_out->take(followed_mask, first.seconds, body.surface().mesh());
    replenish();
    held_out->remember(first.index, first.seconds, follower->points());
    relocator = std::make_unique<Relocator>(rig, parts.tissue);
    relocator->remember(first.left, body.surface());
    clock = {};
    clock.tick(first.seconds);
    holding.emplace(patient, body.positions(), rig);
    look_for_scenery();
    since_key_frame = 0.0;
    look_again = {};
    judge.reset();
    is_believed = true;
    few_points = std::make_unique<FewPoints>(rig, first, options.judge);
    if (!options.judge.enabled) return;
    judge = std::make_unique<Judge>(patient, rig, parts.tissue, options.judge);
    judge->begin(first, body.positions());
    is_believed = !judge->refutes();
  }

  /// Points that are not on the liver go. Their places come back as others do (PointMemory), but for those
  /// that never were on it.
  void hold_out(const StereoFrame& frame, OverlayFrame& overlay) {
    held_out->remember(frame.index, frame.seconds, follower->points());
    held_out->take(followed_mask, frame.seconds, body.surface().mesh());
    follower->keep(held_out->free(follower->points()));
    memory->forget(held_out->never_liver());
    overlay.mask = held_out->use();
  }

  void replenish() {
    const auto expected = [&](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector3d> {
      const auto ray = camera.mapped_ray(pixel);
      if (!ray || !held_out->is_free(pixel)) return std::nullopt;
      const ClosestPoint hit = body.surface().first_hit(Eigen::Vector3d::Zero(), *ray, 0.0,
                                                        std::numeric_limits<double>::infinity());
      if (hit.triangle < 0) return std::nullopt;
      return hit.point;
    };
    const int missing = options.points - static_cast<int>(follower->points().size());
    memory->recall(*follower, anchors, body.surface(), missing, follower->spacing(), frames);
    follower->keep(held_out->free(follower->points()));
    const int added = follower->replenish(expected);
    std::vector<char> kept(follower->points().size(), 1);
    for (std::size_t i = kept.size() - static_cast<std::size_t>(added); i < kept.size(); ++i) {
      const FollowedPoint& point = follower->points()[i];
      kept[i] = anchors.bind(point, body.surface(), kBindRadius);
      if (kept[i] != 0) memory->remember(point, anchors.anchor(point.id), *follower, body.surface(), frames);
    }
    follower->keep(kept);
    anchors.retain(follower->points());
  }

  /// The motion of what holds the organ is taken over at once, by it and the organ: mechanics would lag.
  void follow_camera() {
    if (has_scope_in_hand()) body.move(holding->follow(*follower, anchors, body.surface()));
  }
  bool has_scope_in_hand() const { return options.scope_moves && options.fixed_nodes.empty(); }

  void look_for_scenery() {
    if (has_scope_in_hand())
      holding->scenery().replenish(*follower, body.surface().mesh(), held_out->masked(), clock);
  }

  void look_for_organ(const StereoFrame& frame, Validity validity) {
    // In views that are lost or swapped nothing can be found; a farther or dimmer one may still show the
    // organ.
    const bool is_lost = validity == Validity::too_few_points || validity == Validity::picture_lost ||
                         validity == Validity::masked_out || validity == Validity::inconsistent_motion ||
                         validity == Validity::residual_too_large || validity == Validity::surface_apart;
    // What was found is not looked for again before surfaces have said whether it is right.
    const bool is_examined = judge && judge->is_undecided() && validity == Validity::surface_apart;
    since_key_frame += validity == Validity::valid ? clock.passed() : 0.0;
    if (validity == Validity::valid && since_key_frame >= kKeyFrameEvery) {
      relocator->remember(frame.left, body.surface());
      since_key_frame = 0.0;
    }
    // A start that was refuted binds the texture to wrong places: it would be found there again.
    if (!look_again.is_time(clock, is_lost && !is_examined) || !is_believed) return;
    const auto found = relocator->find(frame.left, body.surface());
    if (!found) return;
    const TriangleMesh& mesh = body.surface().mesh();
    const Points there =
        (mesh.vertices * found->rotation.transpose()).rowwise() + found->translation.transpose();
    if ((there - mesh.vertices).rowwise().norm().mean() < kFoundElsewhere &&
        validity == Validity::surface_apart)
      return;
    body.move(*found);
    holding->found(*found);
    follower->begin(frame, parts);
    anchors.clear();
    memory->forget_since(last_valid);
    replenish();
    if (judge) judge->distrust();
  }

  /// The registered shape is another one: mechanics, springs and all that is bound go along, and the tissue
  /// that is followed stays where it is.
  void take_shape(const Points& shape, const BindingChange& change) {
    take_shape(shape, change,
               options.hold_start ? body.resting_in(shape, "correction", "Drag less far, or register again")
                                  : body.composite());
  }
  void take_shape(const Points& shape, const BindingChange& change,
                  std::shared_ptr<const fem::CompositeModel> resting) {
    const Points motion = hand->carried(shape - hand->shape(), body.positions());
    const registration::MovingSurface before = body.surface();
    body.take(std::move(resting), motion);
    holding->take(shape);
    follower->keep(anchors.rebind(follower->points(), change.of_followed));
    anchors.retain(follower->points());
    memory->rebind(change.of_remembered, before, body.surface());
    seen = seen_area(body.surface().mesh(), camera);
    if (judge) judge->keep_tissue_in(shape);
  }

  OverlayFrame corrected() {
    last.nodes_in_camera = body.positions();
    last.lesions = lesions.judge(last, places_seen(last.validity));
    return last;
  }

  void require_followed(const char* what) const {
    if (!follower || !is_followed(last.validity))
      throw InputError(what, "the organ", "is not followed in the last frame",
                       "Wait until it is followed again");
  }

  OverlayFrame correct(const Correction& correction) {
    require_followed("correction");
    const HandCorrections::Proposal proposal = hand->propose(correction, body.positions(), anchors.anchors());
    HandCorrections::Step former{hand->shape(),     body.positions(),  body.velocities(), body.springs(),
                                 anchors.anchors(), memory->anchors(), relocator->save(), frames};
    const BindingChange change = hand->change_to(proposal.shape);
    take_shape(proposal.shape, change);
    going_over.reset();  // what a hand has set does not go on moving
    relocator->rebind(change.of_surface);
    hand->accept(proposal, std::move(former), last);
    return corrected();
  }

  OverlayFrame undo_correction() {
    if (!hand || hand->made().empty())
      throw InputError("correction", "the last one", "is none", "Correct first");
    const HandCorrections::Step& former = hand->last();
    const BindingChange change = hand->change_back();
    take_shape(former.shape, change);
    relocator->restore(*former.keys, change.of_surface);
    if (former.frame == frames)  // nothing has moved since
      body.restore(former.positions, former.velocities, former.springs);
    hand->take_back();
    return corrected();
  }

  OverlayFrame take(const Registration& registration) {
    require_followed("registration");
    check(patient, registration);
    const auto resting = body.resting_in(registration.nodes_in_camera, "registration");
    HandCorrections::Renewal renewal =
        hand->renewed(resting, registration.nodes_in_camera, anchors.anchors());
    const Points former = hand->shape();
    const BindingChange change = hand->change_to(renewal.shape);
    if (options.hold_start && renewal.shape == registration.nodes_in_camera)
      take_shape(renewal.shape, change, resting);
    else
      take_shape(renewal.shape, change);
    relocator->rebind(change.of_surface);
    hand->accept(std::move(renewal));
    lesions.take(registration);
    doubtful = registration::is_in_doubt(registration);
    going_over.reset();
    // Evidence against a refuted place says nothing of the new one; evidence for a shown one goes on
    // counting.
    if (judge && judge->refutes()) judge->distrust();
    if (last.level() != Level::withdrawn) going_over = GoingOver{former - hand->shape(), clock.now()};
    return drawn(corrected());
  }

  /// The overlay as it is drawn while the picture goes over to another registration. Judged is the new one.
  OverlayFrame drawn(OverlayFrame overlay) {
    if (!going_over) return overlay;
    const double share = 1.0 - (clock.now() - going_over->since) / kGentle;
    if (share <= 0.0 || overlay.nodes_in_camera.rows() == 0) {
      going_over.reset();
      return overlay;
    }
    overlay.nodes_in_camera += share * hand->carried(going_over->way_back, body.positions());
    lesions.carry(overlay);
    return overlay;
  }

  std::shared_ptr<const LabelledCloud> tissue_at_start() {
    if (!judge || judge->tissue().looks() < kLeastLooks) return nullptr;
    if (!tissue || tissue_looks != judge->tissue().looks()) {
      tissue_looks = judge->tissue().looks();
      tissue = std::make_shared<const LabelledCloud>(judge->tissue().places());
    }
    return tissue;
  }

  Validity follow_points(OverlayFrame& overlay) {
    follower->keep(memory->confirm(*follower, body.surface()));
    std::vector<Eigen::Vector3d> gaps = anchors.gaps(follower->points(), body.surface());
    const std::vector<char> good =
        consistent(follower->points(), gaps, kConsistentDeviations, kConsistentFloor);
    const auto agreeing = std::count(good.begin(), good.end(), char{1});
    if (static_cast<double>(agreeing) < options.minimum_consistent_share * static_cast<double>(good.size()))
      return Validity::inconsistent_motion;
    if (agreeing < options.minimum_pairs) return Validity::too_few_points;
    follower->keep(good);
    overlay.pairs = static_cast<int>(agreeing);
    follow_camera();
    const double reference_area = 1e-4 / options.cloud.reference_density_per_cm2;
    const double stiffness = options.point_stiffness * options.materials.parenchyma.young_modulus * seen /
                             (reference_area * static_cast<double>(agreeing));
    const auto pull = [&](auto& loads) { anchors.add(follower->points(), body.surface(), stiffness, loads); };
    if (!body.advance(options.steps_per_frame, pull)) return Validity::mechanics_failed;
    overlay.residual = mean_norm(anchors.gaps(follower->points(), body.surface()));
    if (overlay.residual > options.maximum_residual) return Validity::residual_too_large;
    if (static_cast<int>(follower->points().size()) < (1.0 - kMissing) * options.points) replenish();
    look_for_scenery();
    return Validity::valid;
  }

  /// Of the organ, in this frame.
  Points places_seen(Validity validity) const {
    if (!follower || !is_followed(validity)) return {};
    Points places(static_cast<Eigen::Index>(follower->points().size()), 3);
    for (Eigen::Index i = 0; i < places.rows(); ++i)
      places.row(i) = follower->points()[static_cast<std::size_t>(i)].p_in_camera.transpose();
    return places;
  }

  OverlayFrame follow(const StereoFrame& whole) {
    const StereoFrame frame = views ? views->reduced(whole) : whole;
    ++frames;
    clock.tick(frame.seconds);
    OverlayFrame overlay;
    overlay.index = frame.index;
    overlay.seconds = frame.seconds;
    bool has_pictures = true;
    if (follower) {
      try {
        const StereoFollower::Counts counts = follower->follow(frame);
        overlay.tracked_left = counts.left;
        overlay.tracked_right = counts.right;
        hold_out(frame, overlay);
        overlay.pairs = static_cast<int>(follower->points().size());
        overlay.validity =
            overlay.pairs < options.minimum_pairs ? Validity::too_few_points : follow_points(overlay);
        held_out->remember(frame.index, frame.seconds, follower->points());
        if (overlay.validity == Validity::too_few_points &&
            held_out->explains_few(overlay.pairs, options.minimum_pairs))
          overlay.validity = Validity::masked_out;
      } catch (const InputError&) {
        overlay.validity = Validity::too_few_points;
        has_pictures = false;  // of the camera's size
      }
      // What could not be used is followed again from the last frame that could.
      if (overlay.validity == Validity::too_few_points || overlay.validity == Validity::masked_out ||
          overlay.validity == Validity::inconsistent_motion) {
        if (has_pictures) follower->forget_last();
        body.stop();
      }
    }
    overlay.nodes_in_camera = body.positions();
    if (judge && overlay.validity == Validity::valid)
      overlay.validity = judge->judge(frame, follower->points(), overlay, held_out->masked());
    if (overlay.validity == Validity::valid && held_out && held_out->is_most())
      overlay.validity = Validity::mostly_masked;
    if (overlay.validity == Validity::valid || overlay.validity == Validity::mostly_masked) {
      last_valid = frames;
      is_believed = true;
    }
    overlay.lesions = lesions.judge(overlay, places_seen(overlay.validity));
    last = overlay;
    if (few_points && overlay.validity == Validity::too_few_points)
      last.validity = overlay.validity = few_points->reason(frame, clock);
    if (follower && has_pictures) look_for_organ(frame, overlay.validity);
    return drawn(std::move(overlay));
  }

  OverlayFrame follow(const LabelledCloud& cloud, int index, double seconds, int steps) {
    OverlayFrame overlay;
    overlay.index = index;
    overlay.seconds = seconds;
    overlay.validity = clouds.follow(cloud, steps, body, overlay);
    overlay.nodes_in_camera = body.positions();
    overlay.lesions = lesions.judge(overlay, overlay.level() == Level::withdrawn ? Points() : clouds.seen());
    return overlay;
  }

  TrackerOptions options;
  PatientModel patient;
  FollowedBody body;
  CloudFollower clouds;
  std::optional<StereoFollower> follower;
  AnchoredPoints anchors;
  std::optional<PointMemory> memory;
  std::optional<Holding> holding;                                ///< from begin() on
  std::optional<HandCorrections> hand;                           ///< from begin() on
  std::optional<ReducedViews> views;                             ///< from begin() on
  std::shared_ptr<const PictureMask> given_mask, followed_mask;  ///< as it came; of the reduced views
  std::optional<HeldOut> held_out;                               ///< from begin() on
  struct GoingOver {
    Points way_back;  ///< to the former shape, metres, as registered
    double since = 0.0;
  };
  std::optional<GoingOver> going_over;
  std::shared_ptr<const LabelledCloud> tissue;  ///< of so many looks:
  int tissue_looks = 0;
  OverlayFrame last;               ///< of pictures, as it was judged
  int frames = 0, last_valid = 0;  ///< since begin(); the last that was valid
  LesionJudge lesions;
  std::unique_ptr<Judge> judge;           ///< none while clouds are followed
  std::unique_ptr<FewPoints> few_points;  ///< likewise
  std::unique_ptr<Relocator> relocator;   ///< likewise
  SeenParts parts;
  bool is_believed = true;       ///< surfaces did not refute the start, or a frame was valid since
  FrameClock clock;              ///< since begin()
  double since_key_frame = 0.0;  ///< seconds of valid frames
  LookAgain look_again;
  Camera camera;
  bool doubtful = false;
  double seen = 0.0;  ///< area of the model in the picture, square metres
};

namespace {

/// Runs and times one frame.
template <class Follow>
OverlayFrame timed(bool doubtful, const Follow& follow) {
  const auto start = std::chrono::steady_clock::now();
  OverlayFrame overlay = follow();
  overlay.doubtful = doubtful;
  overlay.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return overlay;
}

}  // namespace

Tracker::Tracker(const PatientModel& model, const Registration& start, const TrackerOptions& options)
    : impl_(std::make_unique<Impl>(model, start, options)) {}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

void Tracker::begin(const StereoRig& rig, const StereoFrame& first, const Picture& mask) {
  impl_->begin(rig, first, mask);
}

void Tracker::see(std::shared_ptr<const PictureMask> not_liver) {
  impl_->given_mask = std::move(not_liver);
  if (impl_->views) impl_->followed_mask = impl_->views->reduced(impl_->given_mask);
}

OverlayFrame Tracker::follow(const StereoFrame& frame) {
  return timed(impl_->doubtful, [&] { return impl_->follow(frame); });
}

double Tracker::evidence_strength() const { return impl_->judge ? impl_->judge->strength() : 0.0; }

OverlayFrame Tracker::correct(const Correction& correction) {
  return timed(impl_->doubtful, [&] { return impl_->correct(correction); });
}

OverlayFrame Tracker::undo_correction() {
  return timed(impl_->doubtful, [&] { return impl_->undo_correction(); });
}

OverlayFrame Tracker::take(const Registration& registration) {
  return timed(registration::is_in_doubt(registration), [&] { return impl_->take(registration); });
}

std::shared_ptr<const LabelledCloud> Tracker::tissue_at_start() const { return impl_->tissue_at_start(); }

const std::vector<CorrectionMade>& Tracker::corrections() const {
  static const std::vector<CorrectionMade> kNone;
  return impl_->hand ? impl_->hand->made() : kNone;
}

OverlayFrame Tracker::follow(const LabelledCloud& cloud, int index, double seconds, int steps) {
  return timed(impl_->doubtful, [&] { return impl_->follow(cloud, index, seconds, steps); });
}

}  // namespace glisson::guidance
