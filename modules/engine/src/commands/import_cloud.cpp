// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_cloud.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/rig.h"

namespace glisson::engine {

CommandTraits ImportCloud::traits() const {
  // It was seen by the camera, and in the frame, of the case: with others it is not to be drawn.
  return {.code = "import_cloud",
          .reads = {part::rig, part::frame},
          .writes = {part::cloud},
          .notice = Notice::files};
}

Cancellable<Applied> ImportCloud::apply(const CaseState& state, const RunContext&) const {
  auto cloud = std::make_shared<const LabelledCloud>(read_cloud(path, unit));
  require_liver_sized(*cloud, unit, path.string());
  Applied applied{state};
  applied.figures["cloud_points"] = cloud->size();
  applied.state[part::cloud] = std::move(cloud);
  applied.state[part::points] = nullptr;
  return applied;
}

}  // namespace glisson::engine
