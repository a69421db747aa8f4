// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/slice_drawing.h"

#include "glisson/core/error.h"
#include "glisson/ui/scene/colours.h"
#include "slice_layers.h"

namespace glisson::scene {
namespace {

constexpr QColor kPreviewEdge(255, 235, 120);  ///< as a lasso: no structure has it

bool same_slice(const SliceGeometry& a, const SliceGeometry& b) {
  return a.plane == b.plane && a.width == b.width && a.height == b.height && a.origin == b.origin &&
         a.right == b.right && a.down == b.down;
}

bool same_style(const SliceStyle& a, const SliceStyle& b) {
  return a.level == b.level && a.width == b.width && a.slab == b.slab && a.label_opacity == b.label_opacity &&
         a.hidden == b.hidden;
}

const LabelVolume* voxels_of(const std::shared_ptr<const LabelMap>& labels) {
  return labels && !labels->voxels.empty() ? &labels->voxels : nullptr;
}

std::size_t pixel_count(const SliceGeometry& slice) {
  return static_cast<std::size_t>(slice.width) * static_cast<std::size_t>(slice.height);
}

/// Whether one of a pixel's four neighbours is another.
template <class Of>
bool is_edge(const SliceGeometry& slice, int u, int v, const Of& of) {
  const auto here = of(u, v);
  return (u > 0 && of(u - 1, v) != here) || (u + 1 < slice.width && of(u + 1, v) != here) ||
         (v > 0 && of(u, v - 1) != here) || (v + 1 < slice.height && of(u, v + 1) != here);
}

QImage transparent(const SliceGeometry& slice) {
  QImage image(slice.width, slice.height, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  return image;
}

}  // namespace

void SliceDrawing::clear() { *this = {}; }

QRect SliceDrawing::draw(const std::shared_ptr<const Image>& image,
                         const std::shared_ptr<const LabelMap>& labels, const SliceGeometry& geometry,
                         const SliceStyle& style) {
  require(image && !image->empty(), "a slice is cut from an image that has voxels");
  if (!(style.width > 0.0))
    throw InputError("slice style", "width", "is " + std::to_string(style.width),
                     "Give a window width above 0.");
  const bool same_place = !picture_.empty() && image == image_ && same_slice(geometry, geometry_);
  const bool same_greys =
      same_place && style.level == style_.level && style.width == style_.width && style.slab == style_.slab;
  const LabelVolume* now = voxels_of(labels);
  const LabelVolume* former = voxels_of(labels_);
  const bool comparable = same_place && now != nullptr && former != nullptr &&
                          now->brick_count() == former->brick_count() && now->grid().same_as(former->grid());
  PixelBox box = PixelBox::all(geometry);
  if (comparable) {
    const PixelBox other = pixels_that_may_differ(*now, *former, geometry);
    if (!other.empty()) sample_labels(*now, geometry, other, found_);
    // An edge is drawn on both of its sides: it may change one pixel outside the box.
    if (same_greys && same_style(style, style_)) box = other.grown(1, geometry);
  } else if (same_place && now == nullptr && former == nullptr && same_style(style, style_)) {
    box = {};
  } else {
    found_.assign(pixel_count(geometry), Label{0});
    if (now != nullptr) sample_labels(*now, geometry, box, found_);
  }
  if (!same_greys) {
    grey_.assign(3 * pixel_count(geometry), std::uint8_t{0});
    draw_grey(*image, geometry, style, grey_);
  }
  image_ = image;
  labels_ = labels;
  geometry_ = geometry;
  style_ = style;
  if (box.empty()) return {};
  const bool whole = box.count() == static_cast<long>(geometry.width) * geometry.height;
  // A copy: whoever holds the former picture keeps it.
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(whole ? grey_ : *picture_.bytes);
  if (!whole)
    for (int v = box.top; v < box.bottom; ++v) {
      const std::ptrdiff_t from = 3 * (static_cast<std::ptrdiff_t>(v) * geometry.width + box.left);
      std::copy_n(grey_.begin() + from, 3 * (box.right - box.left), bytes->begin() + from);
    }
  blend_labels(found_, geometry, style, box, *bytes);
  picture_ = {geometry.width, geometry.height, 3, bytes};
  return {box.left, box.top, box.right - box.left, box.bottom - box.top};
}

QImage change_overlay(const LabelVolume& before, const LabelVolume& after, const SliceGeometry& slice) {
  const PixelBox box = pixels_that_may_differ(before, after, slice);
  if (box.empty()) return {};
  std::vector<Label> was(pixel_count(slice), Label{0}), will(was);
  sample_labels(before, slice, box, was);
  sample_labels(after, slice, box, will);
  constexpr Label kSame = 0xffff;
  const auto becomes = [&](int u, int v) {
    const auto at =
        static_cast<std::size_t>(v) * static_cast<std::size_t>(slice.width) + static_cast<std::size_t>(u);
    return was[at] == will[at] ? kSame : will[at];
  };
  QImage image;
  constexpr int kHatch = 5;  // pixels from line to line
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u) {
      const Label label = becomes(u, v);
      if (label == kSame) continue;
      if (image.isNull()) image = transparent(slice);
      const bool edge = is_edge(slice, u, v, becomes);
      const QColor colour = label == structure::kBackground ? QColor(Qt::white)
                            : edge                          ? kPreviewEdge
                                                            : colour_of(label);
      const bool drawn = edge || (u + v) % kHatch == 0;
      const int alpha = drawn ? 255 : 50;
      auto* line = reinterpret_cast<QRgb*>(image.scanLine(v));
      line[u] = qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), alpha));
    }
  return image;
}

QImage outline_overlay(const LabelVolume& labels, const SliceGeometry& slice) {
  std::vector<Label> found(pixel_count(slice), Label{0});
  sample_labels(labels, slice, PixelBox::all(slice), found);
  const auto of = [&](int u, int v) {
    return found[static_cast<std::size_t>(v) * static_cast<std::size_t>(slice.width) +
                 static_cast<std::size_t>(u)];
  };
  QImage image;
  for (int v = 0; v < slice.height; ++v)
    for (int u = 0; u < slice.width; ++u) {
      if (!is_edge(slice, u, v, of)) continue;
      // The line lies on both sides of the edge: outside it has the colour of what is inside.
      Label label = of(u, v);
      if (label == 0 && u > 0) label = of(u - 1, v);
      if (label == 0 && u + 1 < slice.width) label = of(u + 1, v);
      if (label == 0 && v > 0) label = of(u, v - 1);
      if (label == 0 && v + 1 < slice.height) label = of(u, v + 1);
      if (image.isNull()) image = transparent(slice);
      reinterpret_cast<QRgb*>(image.scanLine(v))[u] = colour_of(label).rgb();
    }
  return image;
}

}  // namespace glisson::scene
