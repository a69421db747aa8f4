// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "glisson/editing/edit.h"
#include "glisson/editing/history.h"
#include "glisson/geometry/camera.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"
#include "glisson/segmentation/segment.h"
#include "glisson/segmentation/statistics.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/reconstruct.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// The parts of a case, in the order in which they come into being.
enum class Part {
  image,
  seeds,
  labels,
  review,   ///< how far a person has come with each label
  preview,  ///< of an edit that nobody has confirmed; not in the files
  model,
  check,  ///< a person's word that the model is right; another model makes it stale
  landmarks,
  rig,
  video,
  frame,
  regions,
  cloud,
  registration,
  live
};
inline constexpr int kPartCount = 15;
/// Code for files and figures: "image", "labels", ...
std::string_view part_code(Part part);

/// A set of parts.
class Parts {
 public:
  constexpr Parts() = default;
  constexpr Parts(std::initializer_list<Part> parts) {  // NOLINT: reads as {Part::a, Part::b}
    for (const Part part : parts) bits_ |= 1U << static_cast<unsigned>(part);
  }
  static constexpr Parts all() {
    Parts parts;
    parts.bits_ = (1U << kPartCount) - 1U;
    return parts;
  }
  constexpr bool has(Part part) const { return ((bits_ >> static_cast<unsigned>(part)) & 1U) != 0; }
  constexpr bool meets(Parts other) const { return (bits_ & other.bits_) != 0; }
  constexpr Parts operator|(Parts other) const {
    Parts parts;
    parts.bits_ = bits_ | other.bits_;
    return parts;
  }
  constexpr bool operator==(const Parts&) const = default;

 private:
  unsigned bits_ = 0;
};

/// Which edition of a part this is, and of which editions of other parts it was made.
struct Stamp {
  std::uint64_t revision = 0;  ///< 0: absent
  std::map<Part, std::uint64_t> made_from;
};

/// Revisions of the parts that a case keeps on the disk; 0 for the live view and the preview.
using Editions = std::array<std::uint64_t, kPartCount>;

/// A stereo pair as it was taken, with what may be used of it.
struct StereoInput {
  StereoFrame frame;
  Picture mask;  ///< one byte a pixel of the left image, non-zero is tissue; empty: everything
};

/// Where the stereo video of the operation lies.
struct VideoSource {
  std::filesystem::path left, right;  ///< `right` empty: `left` holds both views side by side
};

/// What the live view shows. Written by the live lane only.
struct LiveState {
  OverlayFrame overlay;
  StereoFrame frame;
  int frames = 0;          ///< followed since tracking began
  int frames_late = 0;     ///< that took longer than a frame's time
  int frames_dropped = 0;  ///< never followed because a newer one had come
};

/// What an edit would make of the labels.
struct EditPreview {
  editing::Edit edit;
  std::shared_ptr<const LabelMap> base;  ///< the labels that it was made of; null: there were none
  editing::Edited result;
};

/// What a person said of the model after looking at it.
struct ModelCheck {
  bool is_right = false;
};

/// Operations simulated for a registration, and what they were simulated on: the next registration of the
/// same patient needs no others.
struct SimulatedOperations {
  std::shared_ptr<const model::BuiltModel> model;
  std::shared_ptr<const Landmarks> landmarks;
  registration::OperationOptions options;
  std::shared_ptr<const registration::OperationPrior> prior;
};

/// The points of a whole stereo pair, and what they were made of: other regions need no others.
struct PairPoints {
  std::shared_ptr<const StereoInput> frame;  ///< null: one that a case of before knew
  std::shared_ptr<const StereoRig> rig;      ///< the same
  stereo::ReconstructOptions options;
  std::shared_ptr<const stereo::Reconstructed> whole;  ///< made without regions
  double area_cm2 = 0.0;            ///< of the surface that the cloud stands for: within the regions, if any
  double density_per_cm2 = 0.0;     ///< of the cloud
  stereo::DensityMap density;       ///< where in the left picture points are missing
  std::string frame_identity = {};  ///< stereo::frame_identity of the pair
};

/// Everything that is known of one patient. Each part is immutable and shared, so that a copy is cheap;
/// absent parts are null.
struct CaseState {
  std::filesystem::path path;  ///< of the case's folder; empty: never saved
  std::shared_ptr<const Image> image;
  std::shared_ptr<const segmentation::Seeds> seeds;
  std::shared_ptr<const LabelMap> labels;
  std::shared_ptr<const Review> review;
  std::shared_ptr<const EditPreview> preview;
  std::shared_ptr<const model::BuiltModel> model;
  std::shared_ptr<const ModelCheck> check;
  std::shared_ptr<const Landmarks> landmarks;  ///< what a person placed or accepted
  std::shared_ptr<const StereoRig> rig;
  std::shared_ptr<const VideoSource> video;
  std::shared_ptr<const StereoInput> frame;
  std::shared_ptr<const stereo::Regions> regions;
  std::shared_ptr<const LabelledCloud> cloud;
  std::shared_ptr<const Registration> registration;
  std::shared_ptr<const LiveState> live;
  /// Come with the labels: their steps, and their figures on the image.
  std::shared_ptr<const editing::History> history;
  std::shared_ptr<const segmentation::LabelStatistics> statistics;
  std::shared_ptr<const PairPoints> points;               ///< comes with a reconstructed cloud
  std::shared_ptr<const SimulatedOperations> operations;  ///< comes with a registration; not in the files
  std::array<Stamp, kPartCount> stamps;

  bool has(Part part) const;
  const Stamp& stamp(Part part) const { return stamps[static_cast<std::size_t>(part)]; }
  Stamp& stamp(Part part) { return stamps[static_cast<std::size_t>(part)]; }
  /// Copies one part (not its stamp) from another state; with the labels their history
  /// and figures, with the cloud the pair's points, with the registration its simulated operations.
  void take(Part part, const CaseState& from);
  /// Whether this part is the very same object in both.
  bool shares(Part part, const CaseState& with) const;
};

/// What the labels are called, with how far a person has come with each. @pre state.labels
std::vector<LabelInfo> reviewed_infos(const CaseState& state);

Editions editions(const CaseState& state);

enum class StageState { absent, current, stale };
/// A part is stale when anything that it was made from has changed since, or is itself stale.
StageState stage_state(const CaseState& state, Part part);

/// Whether a person has looked at this very model and found it right.
bool is_model_checked(const CaseState& state);

/// The model's own landmarks, with what a person placed instead of them.
/// @pre state.model
Landmarks effective_landmarks(const CaseState& state);
/// The model with its effective landmarks: what registration reads. @pre state.model
PatientModel effective_model(const CaseState& state);

}  // namespace glisson::engine
