// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/saved_image.h"

#include <unistd.h>

#include "case_manifest.h"
#include "glisson/engine/parts/image.h"
#include "image_file.h"

namespace glisson::engine {
namespace fs = std::filesystem;
namespace {

bool is_file_with(const fs::path& path, const std::string& sum) {
  std::error_code failure;
  return fs::is_regular_file(fs::symlink_status(path, failure)) && sum_of(path) == sum;
}

}  // namespace

bool SavedImage::knows(const CaseState& state) const {
  const std::shared_ptr<const Image> image = image_.lock();
  return !sum_.empty() && image && image == state[part::image];
}

Parts SavedImage::take_over(const CaseState& state, const fs::path& place, const fs::path& fresh) const {
  return knows(state) && put_file(place, fresh) ? Parts{part::image} : Parts{};
}

bool SavedImage::put_file(const fs::path& place, const fs::path& fresh) const {
  const fs::path from = place_ / kImageFile, to = fresh / kImageFile;
  if (!is_file_with(from, sum_)) return false;
  // Summed before it is linked: what is changed in between is changed under both names, and found by the
  // next save. Without a second name (another file system) it is written as ever.
  if (place == place_) return ::link(from.c_str(), to.c_str()) == 0;
  // The other case keeps its file: what is changed there must not be changed here.
  std::error_code failure;
  if (fs::copy_file(from, to, failure) && !failure && is_file_with(to, sum_)) return true;
  fs::remove(to, failure);
  return false;
}

void SavedImage::remember(const CaseState& state, const fs::path& folder, const fs::path& place) {
  image_ = state[part::image];
  place_ = place;
  sum_ = state[part::image] ? sum_as_listed(folder, kImageFile) : std::string();
}

}  // namespace glisson::engine
