// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/patient/labelled_cloud.h"

namespace glisson::engine {

/// Clouds of the same organ that were seen before the case's cloud, from elsewhere, each in its own left
/// camera's frame. Where they were seen from is found by the registration (registration/looks.h).
struct EarlierLooks {
  std::vector<std::shared_ptr<const LabelledCloud>> clouds;
  std::vector<std::string> pairs;  ///< PairPoints::frame_identity of each; empty: not known
};

namespace part {
extern const PartOf<EarlierLooks> earlier_looks;
}  // namespace part

/// Those that a registration joins to the case's cloud: all but that cloud itself, and
/// those of the pair that it was made of: the same measurement twice is no second one.
std::vector<std::shared_ptr<const LabelledCloud>> looks_to_join(const CaseState& state);

}  // namespace glisson::engine
