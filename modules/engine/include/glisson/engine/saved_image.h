// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "glisson/engine/case_state.h"
#include "glisson/volume/image.h"

namespace glisson::engine {

/// Which file holds the image: by far the largest part of a case and the one that never changes while
/// somebody works. Remembers the very image (not its revision, which two cases may share), where its file is
/// and the file's sum, so that the next save can take that file over instead of compressing the image again.
class SavedImage {
 public:
  /// Whether a file of this state's image is remembered.
  bool knows(const CaseState& state) const;
  /// Puts the file that is remembered into `fresh` when it holds the image of this state, to the byte: by a
  /// second name for it where the case is to stand where that file is, else as a copy.
  /// @param place where the case will stand.
  /// @return the parts whose files stand in `fresh` now: the image, or none.
  Parts take_over(const CaseState& state, const std::filesystem::path& place,
                  const std::filesystem::path& fresh) const;
  /// The case in `folder` holds the state's image: it has just been read from there, or written and read
  /// back. Nothing is remembered where its file is not the one that case.json lists.
  /// @param place where that folder will stand.
  void remember(const CaseState& state, const std::filesystem::path& folder,
                const std::filesystem::path& place);

 private:
  bool put_file(const std::filesystem::path& place, const std::filesystem::path& fresh) const;

  std::weak_ptr<const Image> image_;
  std::filesystem::path place_;
  std::string sum_;  ///< empty: nothing is remembered
};

}  // namespace glisson::engine
