// SPDX-License-Identifier: GPL-3.0-or-later
#include "entries.h"
#include "incoming.h"
#include "scratch.h"

namespace glisson::fuzz {
namespace {

void look_at(std::string_view content) {
  if (const auto picture = openigtlink::picture_in(content)) {
    must(picture->width > 0 && picture->height > 0, "a picture without a side");
    must(picture->bytes->size() == static_cast<std::size_t>(picture->width) *
                                       static_cast<std::size_t>(picture->height) *
                                       static_cast<std::size_t>(picture->channels),
         "a picture of another size than it says");
  }
  if (const auto pose = openigtlink::pose_in(content)) {
    must(pose->matrix().allFinite(), "a pose that is not finite");
    must((pose->rotation * pose->rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-2,
         "a pose that is no rotation");
  }
}

}  // namespace

void messages(std::string_view bytes) {
  openigtlink::Messages taken([](const openigtlink::Head&) { return true; },
                              [](const openigtlink::Head&, std::string_view content) { look_at(content); });
  const std::size_t half = bytes.size() / 2;
  if (taken.feed(bytes.substr(0, half))) (void)taken.feed(bytes.substr(half));
  // A changed body does not fit its check sum: what stands behind that is looked at, too.
  if (bytes.size() > openigtlink::kHeadSize) look_at(bytes.substr(openigtlink::kHeadSize));
}

}  // namespace glisson::fuzz
