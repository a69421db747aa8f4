// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/editing/edit.h"
#include "glisson/engine/case_state.h"
#include "glisson/patient/label_map.h"

namespace glisson::engine {

/// What an edit would make of the labels.
struct EditPreview {
  editing::Edit edit;
  std::shared_ptr<const LabelMap> base;  ///< the labels that it was made of; null: there were none
  editing::Edited result;
};

namespace part {
/// Of an edit that nobody has confirmed; not in the files.
extern const PartOf<EditPreview> preview;
}  // namespace part

}  // namespace glisson::engine
