// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glisson/editing/history.h"
#include "glisson/engine/case_state.h"
#include "glisson/patient/label_difference.h"
#include "glisson/patient/label_map.h"
#include "glisson/segmentation/segment.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// A new segmentation that would replace what a hand has corrected, until a person decides. The case's labels
/// are as they were.
struct SegmentationOffer {
  LabelMap labels;
  std::shared_ptr<const LabelMap> base;              ///< the labels that it would replace
  std::shared_ptr<const Image> image;                ///< of which it was made, as the next
  std::shared_ptr<const segmentation::Seeds> seeds;  ///< null: it was made from none
  LabelVolume hand;                                  ///< see hand_corrected()
  std::set<Label> edited;               ///< labels that a hand has corrected and that would be found anew
  LabelDifference difference;           ///< of `labels` from `base`
  bool keeps_labels = false;            ///< see Segment::keeps_labels()
  std::vector<std::string> notes = {};  ///< the segmentation's
  /// What it is in the history where clicks of a hand have made it (see CorrectAround); none: growth.
  std::optional<editing::StepName> clicked = {};

  /// Whether all that it was made of is still the case's.
  bool fits(const CaseState& state) const;
};

namespace part {
/// Not in the files: it can be computed again, the corrections cannot.
extern const PartOf<SegmentationOffer> offer;
}  // namespace part

}  // namespace glisson::engine
