// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/edit_tools.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/editing/tools/scissors.h"

namespace glisson::ui {
namespace {

using editing::Edit;
using editing::Paint;
using editing::Scissors;

/// Which layer of voxels a slice shows at a place.
class ShownLayers {
 public:
  ShownLayers(const VolumeGrid& grid, const scene::SliceGeometry& slice)
      : axis_(voxel_axis_across(grid, slice.plane)),
        first_(std::round(grid.index_of(slice.p_in_ct({0.0, 0.0}))[axis_])) {}

  /// The voxel axis across the layers.
  int axis() const { return axis_; }
  /// @param index fractional voxel indices of the place. A slice along the layers is drawn from that of its
  ///   first pixel: where it lies between two, places rounded one by one would follow the last digits of the
  ///   volume's directions into either.
  double at(const Eigen::Vector3d& index) const {
    constexpr double kStray = 4e-3;  // voxels: more than the drawing takes for along the layers
    const double depth = index[axis_];
    return std::abs(depth - first_) <= 0.5 + kStray ? first_ : std::round(depth);
  }

 private:
  int axis_;
  double first_;
};

/// A stretch of a stroke that runs in one layer of voxels.
struct Stretch {
  int layer = 0;
  std::vector<Eigen::Vector3d> indices;  ///< fractional voxel indices
};

/// A stroke cut where the layer changes that the slice shows, as it does in a volume that is askew in the
/// patient. Both sides have the place of the cut, so that there is no gap; what runs outside the volume is
/// left out.
std::vector<Stretch> stretches_of(const VolumeGrid& grid, const ShownLayers& layers, const Points& path) {
  const int axis = layers.axis(), count = grid.size[axis];
  std::vector<Stretch> stretches;
  Eigen::Vector3d former = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(Eigen::Vector3d(path.row(i).transpose())));
    const int layer = static_cast<int>(std::clamp(layers.at(index), -1.0, static_cast<double>(count)));
    if (stretches.empty()) stretches.push_back(Stretch{layer, {}});
    while (stretches.back().layer != layer) {
      const int way = layer > stretches.back().layer ? 1 : -1;
      const double border = stretches.back().layer + 0.5 * way;
      const double t = std::clamp((border - former[axis]) / (index[axis] - former[axis]), 0.0, 1.0);
      const Eigen::Vector3d cut = former + t * (index - former);
      stretches.back().indices.push_back(cut);
      Stretch next{stretches.back().layer + way, {}};
      next.indices.push_back(cut);
      stretches.push_back(std::move(next));
    }
    stretches.back().indices.push_back(index);
    former = index;
  }
  std::erase_if(stretches, [&](const Stretch& s) { return s.layer < 0 || s.layer >= count; });
  return stretches;
}

/// The stretch in the middle of its layer.
Points path_of(const VolumeGrid& grid, int axis, const Stretch& stretch) {
  Points path(static_cast<Eigen::Index>(stretch.indices.size()), 3);
  for (std::size_t n = 0; n < stretch.indices.size(); ++n) {
    Eigen::Vector3d index = stretch.indices[n];
    index[axis] = stretch.layer;
    path.row(static_cast<Eigen::Index>(n)) = grid.p_in_ct(index).xyz.transpose();
  }
  return path;
}

Scissors cut_of(const EditSettings& settings, bool invert) {
  auto cut = settings.of<Scissors>();
  if (invert)
    cut.operation = cut.operation == Scissors::Operation::erase_inside ? Scissors::Operation::fill_inside
                                                                       : Scissors::Operation::erase_inside;
  const bool erases = cut.operation != Scissors::Operation::fill_inside;
  cut.label = erases && settings.of<Cut>().any_label ? structure::kBackground : settings.label;
  return cut;
}

/// Pixels of the slice from points of the CT.
Eigen::Matrix<double, 3, 4> view_of(const scene::SliceGeometry& slice) {
  Eigen::Matrix<double, 3, 4> view = Eigen::Matrix<double, 3, 4>::Zero();
  int row = 0;
  for (const Eigen::Vector3d& axis : {slice.right, slice.down}) {
    const Eigen::Vector3d per_pixel = axis / axis.squaredNorm();
    view.row(row++) << per_pixel.transpose(), -per_pixel.dot(slice.origin);
  }
  view(2, 3) = 1.0;
  return view;
}

}  // namespace

Hand hand_of(EditTool tool, const EditSettings& settings) {
  return tool == nullptr ? Hand::crosshair : tool->hand(settings);
}

bool is_previewed(EditTool tool, const EditSettings& settings) {
  return tool != nullptr && hand_of(tool, settings) == Hand::crosshair;
}

double brush_after(double radius, double notches) {
  // A tenth a notch, but a tenth of a millimetre at least, on round tenths.
  const double tenths = 1e4 * radius;
  const double next = tenths * std::pow(1.15, notches);
  const double moved = std::abs(next - tenths) < std::abs(notches) ? tenths + notches : next;
  return std::clamp(1e-4 * std::round(moved), kSmallestBrush, kLargestBrush);
}

std::vector<Edit> brush_edits(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                              const scene::SliceGeometry& slice, const Points& path, bool invert) {
  require(hand_of(tool, settings) == Hand::brush, "a brush paints or erases");
  require(path.allFinite(), "a stroke runs through places");
  Paint paint;
  paint.erase = tool->erases != invert;
  paint.label = paint.erase && settings.erase_any ? structure::kBackground : settings.label;
  paint.brush = settings.ball ? Paint::Brush::ball : Paint::Brush::disc;
  paint.radius = settings.brush_radius;
  const ShownLayers layers(grid, slice);
  paint.normal_axis = layers.axis();
  std::vector<Edit> edits;
  if (settings.ball) {
    paint.path = path;
    edits.push_back(Edit{paint, settings.region});
    return edits;
  }
  // A disc lies in the layer of voxels that the slice shows, also where the slice is between two.
  for (const Stretch& stretch : stretches_of(grid, layers, path)) {
    paint.path = path_of(grid, layers.axis(), stretch);
    edits.push_back(Edit{paint, settings.region});
  }
  return edits;
}

Edit slice_cut(const EditSettings& settings, const VolumeGrid& grid, const scene::SliceGeometry& slice,
               const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& outline, bool invert) {
  Scissors cut = cut_of(settings, invert);
  cut.view_from_ct = view_of(slice);
  cut.outline = outline;
  const auto& how = settings.of<Cut>();
  if (how.depth != CutDepth::through) {
    // The layer of voxels that the slice shows.
    const ShownLayers layers(grid, slice);
    Eigen::Vector3d middle = grid.index_of(slice.p_in_ct({0.5 * slice.width, 0.5 * slice.height}));
    middle[layers.axis()] = layers.at(middle);
    Scissors::Slab slab;
    slab.normal = slice.right.cross(slice.down).normalized();
    slab.offset = slab.normal.dot(grid.p_in_ct(middle).xyz);
    const double layer = 0.5e-3 * grid.spacing_mm[layers.axis()];
    slab.half_thickness = how.depth == CutDepth::slice ? layer : std::max(layer, 0.5 * how.slab);
    cut.slab = slab;
  }
  return {cut, settings.region};
}

Edit volume_cut(const EditSettings& settings, const VolumeLasso& lasso, bool invert) {
  Scissors cut = cut_of(settings, invert);
  cut.view_from_ct = lasso.view_from_ct;
  cut.outline = lasso.outline;
  return {cut, settings.region};
}

std::optional<Edit> click_edit(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                               scene::Plane plane, const Point<CtFrame>& p, Label clicked, bool invert) {
  require(tool != nullptr && tool->click != nullptr, "this tool works where it is clicked");
  auto made = tool->click(settings, {grid, plane, p, clicked, invert});
  if (!made) return std::nullopt;
  return Edit{std::move(*made), settings.region};
}

Edit whole_edit(EditTool tool, const EditSettings& settings, const VolumeGrid& grid,
                const std::vector<Label>& present) {
  require(tool != nullptr && tool->whole != nullptr, "this tool works on the whole volume");
  return {tool->whole(settings, {grid, present}), settings.region};
}

EditObstacle obstacle_of(EditTool tool, const EditSettings& settings, const std::vector<Label>& present) {
  const bool own = tool == nullptr || tool->works_on_label(settings);
  if (own && is_among(settings.region.locked, settings.label)) return EditObstacle::label_locked;
  return tool == nullptr ? EditObstacle::none : tool->obstacle(settings, present);
}

}  // namespace glisson::ui
