// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/frame.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "ranged.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

/// frame/left.png, frame/right.png, frame/mask.png.
json save(const CaseState& state, const CaseFolder& folder) {
  const StereoInput& input = *state[part::frame];
  fs::create_directory(folder.path / "frame");
  stereo::write_picture(folder.path / "frame/left.png", input.frame.left);
  stereo::write_picture(folder.path / "frame/right.png", input.frame.right);
  if (!input.mask.empty()) stereo::write_picture(folder.path / "frame/mask.png", input.mask);
  return {{"index", input.frame.index}, {"seconds", input.frame.seconds}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  StereoInput input;
  input.frame.index = ranged<int>(folder.path, entry, "index", 0.0, 1e9);
  input.frame.seconds = ranged<double>(folder.path, entry, "seconds", 0.0, 1e6);
  stereo::PictureReader pictures;
  input.frame.left = pictures.read(folder.path / "frame/left.png");
  input.frame.right = pictures.read(folder.path / "frame/right.png");
  const fs::path mask = folder.path / "frame/mask.png";
  if (fs::exists(mask)) input.mask = pictures.read(mask);
  state[part::frame] = std::make_shared<const StereoInput>(std::move(input));
}

bool same_picture(const Picture& a, const Picture& b) {
  if (a.empty() || b.empty()) return a.empty() == b.empty();
  return a.width == b.width && a.height == b.height && a.channels == b.channels && *a.bytes == *b.bytes;
}

bool same(const CaseState& written, const CaseState& read) {
  const StereoInput &a = *written[part::frame], &b = *read[part::frame];
  return a.frame.index == b.frame.index && std::abs(a.frame.seconds - b.frame.seconds) < 1e-9 &&
         same_picture(a.frame.left, b.frame.left) && same_picture(a.frame.right, b.frame.right) &&
         same_picture(a.mask, b.mask);
}

}  // namespace

const PartOf<StereoInput> part::frame{{.code = "frame",
                                       .made_of = {part::video},
                                       .remedy = "Load a stereo pair first",
                                       .files = {"frame/*.png"},
                                       .save = save,
                                       .load = load,
                                       .same = same,
                                       .outlives = {part::video}}};

}  // namespace glisson::engine
