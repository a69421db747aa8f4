// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/saved_image.h"

#include <unistd.h>

#include "case_manifest.h"
#include "glisson/engine/parts/image.h"
#include "image_entry.h"

namespace glisson::engine {
namespace fs = std::filesystem;

bool SavedImage::link(const CaseState& state, const fs::path& former, const fs::path& fresh) {
  const std::shared_ptr<const Image> image = image_.lock();
  if (!image || image != state[part::image]) return false;
  const fs::path from = former / kImageFile, to = fresh / kImageFile;
  std::error_code failure;
  const bool is_ours = fs::is_regular_file(fs::symlink_status(from, failure)) && sum_of(from) == sum_;
  // Summed before it is linked: what is changed in between is changed under both names, and found by the
  // next copy. Without a second name (another file system) it is written as ever.
  return is_ours && !sum_.empty() && ::link(from.c_str(), to.c_str()) == 0;
}

void SavedImage::remember(const CaseState& state, const fs::path& folder) {
  image_ = state[part::image];
  sum_ = state[part::image] ? sum_of(folder / kImageFile) : std::string();
}

}  // namespace glisson::engine
