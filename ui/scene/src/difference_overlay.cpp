// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/difference_overlay.h"

#include <QColor>
#include <vector>

#include "glisson/core/error.h"
#include "slice_layers.h"

namespace glisson::scene {
namespace {

constexpr int kHatch = 5;  ///< pixels from line to line

/// What a pixel shows.
struct Shown {
  Change change = Change::none;
  bool by_hand = false;
  bool operator==(const Shown&) const = default;
};

QColor colour_of(Change change) {
  switch (change) {
    case Change::added:
      return {86, 180, 233};
    case Change::removed:
      return {230, 159, 0};
    case Change::renamed:
      return {240, 228, 66};
    case Change::none:
      break;
  }
  return {};
}

bool is_hatched(Change change, int u, int v) {
  const bool up = (u + v) % kHatch == 0, down = (u - v) % kHatch == 0;
  return change == Change::added ? up : change == Change::removed ? down : up || down;
}

QRgb pixel_of(const Shown& shown, bool edge, int u, int v) {
  const QColor colour = edge && shown.by_hand ? QColor(Qt::white) : colour_of(shown.change);
  const int alpha = edge || is_hatched(shown.change, u, v) ? 255 : shown.by_hand ? 130 : 50;
  return qPremultiply(qRgba(colour.red(), colour.green(), colour.blue(), alpha));
}

/// @param at what the pixel (u, v) shows. Null when none shows anything.
template <class At>
QImage drawn(int width, int height, const PixelBox& box, const At& at) {
  QImage image;
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u) {
      const Shown here = at(u, v);
      if (here.change == Change::none) continue;
      if (image.isNull()) {
        image = QImage(width, height, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
      }
      const auto is_other = [&](int x, int y) {
        return x < 0 || y < 0 || x >= width || y >= height || at(x, y) != here;
      };
      const bool edge = is_other(u - 1, v) || is_other(u + 1, v) || is_other(u, v - 1) || is_other(u, v + 1);
      reinterpret_cast<QRgb*>(image.scanLine(v))[u] = pixel_of(here, edge, u, v);
    }
  return image;
}

}  // namespace

Change change_of(Label was, Label will) {
  if (was == will) return Change::none;
  if (was == structure::kBackground) return Change::added;
  return will == structure::kBackground ? Change::removed : Change::renamed;
}

QImage difference_overlay(const LabelVolume& before, const LabelVolume& after, const LabelVolume& hand,
                          const SliceGeometry& slice) {
  const PixelBox box = pixels_that_may_differ(before, after, slice);
  if (box.empty()) return {};
  const auto width = static_cast<std::size_t>(slice.width);
  std::vector<Label> was(width * static_cast<std::size_t>(slice.height), Label{0}), will(was), marked(was);
  sample_labels(before, slice, box, was);
  sample_labels(after, slice, box, will);
  sample_labels(hand, slice, box, marked);
  return drawn(slice.width, slice.height, box, [&](int u, int v) {
    const std::size_t n = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
    const Change change = change_of(was[n], will[n]);
    return Shown{change, change != Change::none && marked[n] != 0};
  });
}

QImage difference_swatch(Change change, bool by_hand, int width, int height) {
  require(change != Change::none && width > 2 && height > 2, "a swatch shows a change");
  return drawn(width, height, {0, 0, width, height}, [&](int, int) { return Shown{change, by_hand}; });
}

}  // namespace glisson::scene
