// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::stereo {

class StereoVideo;

/// What can be wrong with what comes from the laparoscope.
enum class Fault {
  black,         ///< both views are dark
  left_lost,     ///< the left view is dark or without content, the right one is not
  right_lost,    ///< the reverse
  one_view,      ///< both views are the same picture, but for what coding it twice changes
  swapped,       ///< left is right
  unrelated,     ///< the views show nothing in common
  other_scope,   ///< the views match each other, but not the calibration
  duplicated,    ///< the frame before, once more
  frozen,        ///< for a fifth of a second nothing has changed, not even noise (but for a codec's)
  left_frozen,   ///< the left view stands while the right one moves: they show two moments
  right_frozen,  ///< the reverse
  out_of_order,  ///< two frames have changed places
  interlaced  ///< even and odd rows show two moments, from the first frame on: points are off by its motion
};
/// "black", "left_lost", ...
const char* fault_code(Fault fault);
/// The same as a note: "stereo.black", ...
std::string fault_note(Fault fault);

/// What one pair shows of its own soundness. Without faults, geometry may still be unknown: see `matches`.
struct PairCheck {
  std::vector<Fault> faults;
  int matches = 0;  ///< that one epipolar geometry explains, whichever; below 20 nothing is said of geometry
  double rows_px = 0.0;    ///< median distance of the matches from the calibration's epipolar lines
  double plausible = 0.0;  ///< share of the matches that lies 2 to 50 cm before the cameras

  bool has(Fault fault) const;
};

/// Looks at one pair. Matches are found without the calibration (mutual best SURF over the whole picture, one
/// fundamental matrix by RANSAC) and then held against it: a calibration of another scope whose epipolar
/// lines happen to agree to 0.6 % of the picture's width is not recognised.
/// @throws InputError pictures of another size than the calibration's.
PairCheck check_pair(const Picture& left, const Picture& right, const StereoRig& rig);

/// @throws InputError with a sentence on the first fault of a pair that makes reconstruction pointless.
void require_sound(const PairCheck& check);

/// Whether the calibration is for pictures of the left one's size.
bool is_rig_of(const StereoRig& rig, const Picture& left);
/// @throws InputError it is not (is_rig_of).
void require_rig_of(const StereoRig& rig, const Picture& left);
/// @param mask may be empty. @param mask_name of it in the message.
/// @throws InputError left and right differ in size, or the mask is not of the left one's.
void require_one_size(const StereoFrame& frame, const Picture& mask, const std::string& mask_name);

/// A fault at a frame.
struct FrameFault {
  int frame = 0;
  Fault fault = Fault::black;
  bool operator==(const FrameFault&) const = default;
};

/// Looks at frames one after another: black, lost and same views, duplicates, freezes, changes of order; in
/// lossless and in lossy video. A view stands when it changes far less than in any of its last four changes,
/// and less than a sensor's coded noise; where a codec leaves next to no change at all nothing is said.
/// That a film is interlaced is told once, as soon as enough has moved to know it.
/// Swapping is recognised where it begins and ends, from the frame before; whether the first frame is swapped
/// only check_pair() can tell.
class SequenceCheck {
 public:
  SequenceCheck();
  ~SequenceCheck();
  /// @return the faults found with this frame; an exchange of two frames is known one frame late.
  std::vector<FrameFault> push(const StereoFrame& frame);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How often a whole video is held against its calibration.
struct VideoCheckOptions {
  int every = 30;  ///< each so many frames one is held against the calibration, if it is sound so far
  /// @throws PreconditionError every below 1.
  void validate() const;
};

/// What a whole video has.
struct VideoFaults {
  std::vector<FrameFault> faults;  ///< in the order in which they were found
  int frames = 0;                  ///< read
  int skipped = 0;                 ///< frames of either view that had no partner
};
/// Hears of a fault as soon as it is found.
using FaultTold = std::function<void(const FrameFault&)>;

/// Looks through a video from where it stands to its end: SequenceCheck at every frame, check_pair() at some
/// of them. Progress "check.frame".
/// @param rig of the video's pictures; empty: nothing is held against a calibration.
/// @throws InputError as StereoVideo::read() and check_pair().
Cancellable<VideoFaults> check_video(StereoVideo& video, const std::optional<StereoRig>& rig,
                                     const VideoCheckOptions& options, const RunContext& context,
                                     const FaultTold& told = {});

}  // namespace glisson::stereo
