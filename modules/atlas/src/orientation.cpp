// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/orientation.h"

#include <algorithm>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "pose_search.h"

namespace glisson::atlas {
namespace {

std::string axes_code(Axes turned_round) {
  std::string code;
  for (const auto& [axis, name] : {std::pair(kLeftRight, "left_right"), std::pair(kFrontBack, "front_back"),
                                   std::pair(kHeadFeet, "head_feet")})
    if ((turned_round & axis) != 0) code += (code.empty() ? "" : "+") + std::string(name);
  return code;
}

/// The largest closed piece with outward normals; no triangles: there is none.
TriangleMesh closed_liver(const TriangleMesh& surface) {
  if (surface.triangle_count() == 0 || !plausible_liver_size(surface.vertices)) return {};
  std::vector<TriangleMesh> pieces = split_components(surface);
  TriangleMesh largest =
      std::move(*std::ranges::max_element(pieces, {}, [](const TriangleMesh& piece) { return area(piece); }));
  if (!is_closed(largest)) return {};
  if (volume(largest) < 0.0) largest.triangles.col(1).swap(largest.triangles.col(2));
  return largest;
}

}  // namespace

Cancellable<ImageMisfits> image_misfits(const Atlas& atlas, const TriangleMesh& liver,
                                        const RunContext& context) {
  require(liver.triangle_count() > 0, "a liver has a surface");
  const Moving mean = moving_parts(atlas.mean());
  const Target target = target_parts(liver);
  ImageMisfits misfits{};
  for (Axes axes = kNoAxes; axes <= kAllAxes; ++axes) {
    if (context.cancelled()) return {};
    context.progress(axes / 8.0, "atlas.pose");
    misfits[axes] = upright_pose(mean, target, axes).misfit;
  }
  return misfits;
}

Cancellable<std::vector<std::string>> orientation_doubts(const Atlas& atlas, const TriangleMesh& liver,
                                                         const RunContext& context) {
  std::vector<std::string> doubts;
  const TriangleMesh closed = closed_liver(liver);
  if (closed.triangle_count() == 0) return doubts;
  const auto misfits = image_misfits(atlas, closed, context);
  if (!misfits) return {};
  const auto best = std::min_element(misfits->begin() + 1, misfits->end());
  if (*best < kExchanged * misfits->front())
    doubts.push_back("liver.axes_exchanged " + axes_code(static_cast<Axes>(best - misfits->begin())));
  return doubts;
}

}  // namespace glisson::atlas
