// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "glisson/engine/command.h"
#include "glisson/volume/dicom_source.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// Reads a CT or MR (see read_image).
struct ImportImage {
  std::filesystem::path path;
  std::string series = {};  ///< UID or number, where there are several
  bool new_case = false;    ///< of another patient: nothing of the case stays, nor where it lay
  /// What the image is, where its file does not say. @throws InputError in apply(): DICOM says another one.
  std::optional<Modality> modality = {};
  /// What ReadImage has read of path and series; null: it is read here.
  std::shared_ptr<const Scan> scan = {};

  CommandTraits traits() const;
  Cancellable<Applied> apply(const CaseState& state, const RunContext& context) const;
};

}  // namespace glisson::engine
