// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "glisson/engine/case_state.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// The image that an earlier copy holds: by far the largest part of a case and the one that never changes
/// while somebody works. Remembers the very image (not its revision, which two cases may share) and the sum
/// of its file, so that the next copy can take that file over by a second name for it.
class SavedImage {
 public:
  /// Puts `former`'s file of the image into `fresh` when it holds the image of this state, to the byte.
  /// False: it is to be written.
  bool link(const CaseState& state, const std::filesystem::path& former, const std::filesystem::path& fresh);
  /// The folder holds the state's image: it has just been written and read back.
  void remember(const CaseState& state, const std::filesystem::path& folder);

 private:
  std::weak_ptr<const Image> image_;
  std::string sum_;
};

/// save_case for copies that are made over and over at one place, by one program.
bool save_copy(const std::filesystem::path& path, const CaseState& state, const RunContext& context,
               SavedImage& saved);

}  // namespace glisson::engine
