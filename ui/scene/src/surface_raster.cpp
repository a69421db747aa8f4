// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/surface_raster.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::scene {
namespace {

constexpr float kLongestEdge = 48.0F;  ///< pixels; the bow of a line so short stays below a fifth of a pixel
constexpr double kSmallestDivided = 2e-3;  ///< metres; smaller triangles at the border are dropped whole
constexpr int kDeepest = 7;                ///< divisions of one triangle

/// |cosine| between the surface and the line of sight at each vertex, smooth over the surface.
void set_facings(const Points& vertices, const Triangles& triangles, std::vector<RasterCorner>& corners) {
  Points normals = Points::Zero(vertices.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Eigen::RowVector3d a = vertices.row(triangles(t, 0));
    const Eigen::RowVector3d normal =
        (vertices.row(triangles(t, 1)) - a).cross(vertices.row(triangles(t, 2)) - a);
    for (int k = 0; k < 3; ++k) normals.row(triangles(t, k)) += normal;
  }
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    const double lengths = std::sqrt(normals.row(i).squaredNorm() * vertices.row(i).squaredNorm());
    corners[static_cast<std::size_t>(i)].facing =
        lengths > 0.0 ? static_cast<float>(std::abs(normals.row(i).dot(vertices.row(i))) / lengths) : 0.0F;
  }
}

/// Whether straight edges on the picture are near enough to the lens's.
bool is_short(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
  const auto squared = [](const ScreenCorner& from, const ScreenCorner& to) {
    return (from.x - to.x) * (from.x - to.x) + (from.y - to.y) * (from.y - to.y);
  };
  return std::max(std::max(squared(a, b), squared(b, c)), squared(c, a)) <= kLongestEdge * kLongestEdge;
}

// Without a call into the library for each, as the common processor needs for std::ceil and std::floor.
/// @pre the value fits into an int, here and below.
int up(float value) {
  const int whole = static_cast<int>(value);
  return whole + static_cast<int>(static_cast<float>(whole) < value);
}
int down(float value) {
  const int whole = static_cast<int>(value);
  return whole - static_cast<int>(static_cast<float>(whole) > value);
}

float least(float a, float b, float c) { return std::min(std::min(a, b), c); }
float most(float a, float b, float c) { return std::max(std::max(a, b), c); }

ScreenCorner on_screen(const RasterCorner& corner) {
  if (!corner.visible) return {0.0F, 0.0F, 0.0F, corner.facing};
  return {corner.pixel.x(), corner.pixel.y(), static_cast<float>(1.0 / corner.p.z()), corner.facing};
}

/// On the picture, whose rows run downwards: positive when it is walked around with the clock.
float twice_the_area(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

/// One edge of a triangle: where it bounds a row.
struct RowBound {
  /// @param right, down how the opposite corner's share grows a pixel to the right and down. Zero at (x, y).
  RowBound(float right, float down, float x, float y) : y_(y), down_(down), side_(right) {
    if (right == 0.0F) return;
    const float columns = 1.0F / right;  // to walk until the share has grown by one
    start_ = x + kRim * columns;
    step_ = down * columns;
  }
  /// Narrows a row to where the share is not negative.
  void bound(float row, float& from, float& to) const {
    const float rows = row - y_;
    if (side_ > 0.0F)
      from = std::max(from, start_ - rows * step_);
    else if (side_ < 0.0F)
      to = std::min(to, start_ - rows * step_);
    else if (kRim - rows * down_ > 0.0F)
      to = from - 1.0F;
  }

 private:
  static constexpr float kRim = -1e-4F;  // neighbours share their edges: no gaps
  float y_, down_, side_, start_ = 0.0F, step_ = 0.0F;
};

/// Fills a band's rows of one small triangle. Pixel centres are whole numbers.
void fill_small(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c, std::uint8_t kind,
                const RowBand& band, SurfaceLayer& layer, PixelBox& touched) {
  const float area = twice_the_area(a, b, c);
  if (!(std::abs(area) > 1e-6F)) return;
  // Limited before they are whole numbers: a corner may lie far beside the picture.
  const int left = up(std::max(0.0F, least(a.x, b.x, c.x)));
  const int right = down(std::min(static_cast<float>(layer.width - 1), most(a.x, b.x, c.x)));
  const int top = up(std::max(static_cast<float>(band.first), least(a.y, b.y, c.y)));
  const int bottom = down(std::min(static_cast<float>(band.end - 1), most(a.y, b.y, c.y)));
  if (left > right || top > bottom) return;
  touched.add(left, right, top, bottom);
  const float scale = 1.0F / area;
  // Each corner's share is linear over the picture, and so is what corners have.
  const float a_right = (b.y - c.y) * scale, a_down = (c.x - b.x) * scale;
  const float b_right = (c.y - a.y) * scale, b_down = (a.x - c.x) * scale;
  const float c_right = (a.y - b.y) * scale, c_down = (b.x - a.x) * scale;
  const std::array<RowBound, 3> edges = {RowBound(a_right, a_down, b.x, b.y),
                                         RowBound(b_right, b_down, c.x, c.y),
                                         RowBound(c_right, c_down, a.x, a.y)};
  const auto slope = [](float of_a, float of_b, float of_c, float at_a, float at_b, float at_c) {
    return of_a * at_a + of_b * at_b + of_c * at_c;
  };
  const float inverse_right =
                  slope(a_right, b_right, c_right, a.inverse_depth, b.inverse_depth, c.inverse_depth),
              inverse_down = slope(a_down, b_down, c_down, a.inverse_depth, b.inverse_depth, c.inverse_depth),
              facing_right = slope(a_right, b_right, c_right, a.facing, b.facing, c.facing),
              facing_down = slope(a_down, b_down, c_down, a.facing, b.facing, c.facing);
  for (int y = top; y <= bottom; ++y) {
    const auto row = static_cast<float>(y);
    float from = static_cast<float>(left), to = static_cast<float>(right);
    for (const RowBound& edge : edges) edge.bound(row, from, to);
    if (!(from <= to)) continue;
    const int first = up(from), last = down(to);
    const float columns = static_cast<float>(first) - a.x, rows = row - a.y;
    float inverse = a.inverse_depth + columns * inverse_right + rows * inverse_down;
    float facing = a.facing + columns * facing_right + rows * facing_down;
    std::size_t pixel = layer.at(y, first);
    for (int x = first; x <= last; ++x, ++pixel, inverse += inverse_right, facing += facing_right) {
      if (inverse <= layer.inverse_depth[pixel]) continue;
      layer.inverse_depth[pixel] = inverse;
      layer.kind[pixel] = kind;
      layer.facing[pixel] = static_cast<std::uint8_t>(255.0F * std::clamp(facing, 0.0F, 1.0F));
    }
  }
}

}  // namespace

void PixelBox::add(int from, int to, int first, int last) {
  const bool is_first = empty();
  const int new_left = is_first ? from : std::min(left, from),
            new_top = is_first ? first : std::min(top, first);
  width = (is_first ? to + 1 : std::max(right(), to + 1)) - new_left;
  height = (is_first ? last + 1 : std::max(bottom(), last + 1)) - new_top;
  left = new_left;
  top = new_top;
}

void PixelBox::add(const PixelBox& other) {
  if (!other.empty()) add(other.left, other.right() - 1, other.top, other.bottom() - 1);
}

PixelBox PixelBox::around(int pixels, int picture_width, int picture_height) const {
  if (empty()) return {};
  PixelBox box;
  box.left = std::max(0, left - pixels);
  box.top = std::max(0, top - pixels);
  box.width = std::min(picture_width, right() + pixels) - box.left;
  box.height = std::min(picture_height, bottom() + pixels) - box.top;
  return box;
}

SurfaceRaster::SurfaceRaster(const Camera& camera) : camera_(camera) {
  require(camera.width > 0 && camera.height > 0 && camera.matrix(0, 0) > 0.0 && camera.matrix(1, 1) > 0.0,
          "a camera has a picture size and focal lengths");
  const double slope = camera.widest_slope();
  largest_slope_squared_ = slope * slope;
}

SurfaceLayer SurfaceRaster::layer() const {
  SurfaceLayer layer;
  layer.width = camera_.width;
  layer.height = camera_.height;
  const auto pixels = static_cast<std::size_t>(layer.width) * static_cast<std::size_t>(layer.height);
  layer.kind.assign(pixels, 0);
  layer.facing.assign(pixels, 0);
  layer.inverse_depth.assign(pixels, 0.0F);
  return layer;
}

void SurfaceRaster::clear(SurfaceLayer& layer) const {
  if (layer.empty() || layer.width != camera_.width || layer.height != camera_.height) {
    layer = this->layer();
    return;
  }
  const PixelBox& box = layer.touched;
  for (int row = box.top; row < box.bottom(); ++row) {
    const auto first = static_cast<std::ptrdiff_t>(layer.at(row, box.left));
    std::fill_n(layer.kind.begin() + first, box.width, std::uint8_t{0});
    std::fill_n(layer.facing.begin() + first, box.width, std::uint8_t{0});
    std::fill_n(layer.inverse_depth.begin() + first, box.width, 0.0F);
  }
  layer.touched = {};
}

void SurfaceRaster::project(RasterCorner& corner) const {
  const double z = corner.p.z();
  corner.visible =
      z > kNear && corner.p.head<2>().squaredNorm() < largest_slope_squared_ * z * z && corner.p.allFinite();
  if (corner.visible) corner.pixel = camera_.project(corner.p).cast<float>();
}

void SurfaceRaster::project(const Points& vertices, const Triangles& triangles,
                            ProjectedSurface& surface) const {
  std::vector<RasterCorner>& corners = surface.corners;
  corners.resize(static_cast<std::size_t>(vertices.rows()));
  surface.on_screen.resize(corners.size());
  surface.is_whole = true;
  set_facings(vertices, triangles, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i].p = vertices.row(static_cast<Eigen::Index>(i)).transpose();
    project(corners[i]);
    surface.on_screen[i] = on_screen(corners[i]);
    surface.is_whole = surface.is_whole && corners[i].visible;
  }
}

/// Fills what of a surface lies in a band.
class SurfaceRaster::BandFiller {
 public:
  BandFiller(const SurfaceRaster& raster, std::uint8_t kind, const RowBand& band, SurfaceLayer& layer)
      : raster_(raster), kind_(kind), band_(band), layer_(layer) {}

  /// @param one_sided it is not drawn when it is turned away.
  void add(const ProjectedSurface& surface, std::size_t i, std::size_t j, std::size_t k, bool one_sided) {
    const ScreenCorner &a = surface.on_screen[i], &b = surface.on_screen[j], &c = surface.on_screen[k];
    if (one_sided && is_turned_away(a, b, c)) return;
    if (is_visible(a, b, c) && is_short(a, b, c)) return fill(a, b, c);
    divide(surface.corners[i], surface.corners[j], surface.corners[k], 0);
  }
  const PixelBox& touched() const { return touched_; }

 private:
  /// Wound outwards, a triangle is walked around against the clock where it is seen from outside.
  static bool is_turned_away(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
    return twice_the_area(a, b, c) > 0.0F;
  }
  static bool is_visible(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
    return a.inverse_depth > 0.0F && b.inverse_depth > 0.0F && c.inverse_depth > 0.0F;
  }
  void fill(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
    const bool is_beside = least(a.y, b.y, c.y) > static_cast<float>(band_.end - 1) ||
                           most(a.y, b.y, c.y) < static_cast<float>(band_.first);
    if (!is_beside) fill_small(a, b, c, kind_, band_, layer_, touched_);
  }
  void add(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c, int depth) {
    const ScreenCorner at_a = on_screen(a), at_b = on_screen(b), at_c = on_screen(c);
    if (is_visible(at_a, at_b, at_c) && (depth == kDeepest || is_short(at_a, at_b, at_c)))
      return fill(at_a, at_b, at_c);
    divide(a, b, c, depth);
  }
  /// @pre too long, or not seen whole
  void divide(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c, int depth) {
    if (!(a.visible && b.visible && c.visible)) {
      const double size = std::max({(a.p - b.p).norm(), (b.p - c.p).norm(), (c.p - a.p).norm()});
      if (depth == kDeepest || !(size > kSmallestDivided)) return;
    }
    const RasterCorner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    add(a, ab, ca, depth + 1);
    add(ab, b, bc, depth + 1);
    add(ca, bc, c, depth + 1);
    add(ab, bc, ca, depth + 1);
  }
  RasterCorner middle(const RasterCorner& one, const RasterCorner& other) const {
    RasterCorner corner;
    corner.p = 0.5 * (one.p + other.p);
    corner.facing = 0.5F * (one.facing + other.facing);
    raster_.project(corner);
    return corner;
  }

  const SurfaceRaster& raster_;
  std::uint8_t kind_;
  RowBand band_;
  SurfaceLayer& layer_;
  PixelBox touched_;
};

PixelBox SurfaceRaster::fill(const ProjectedSurface& surface, const SidedTriangles& sided, std::uint8_t kind,
                             const RowBand& band, SurfaceLayer& layer) const {
  require(kind != 0, "kind 0 stands for nothing");
  require(layer.width == camera_.width && layer.height == camera_.height, "a layer has the camera's size");
  require(band.first >= 0 && band.end <= layer.height, "a band lies in its picture");
  BandFiller filler(*this, kind, band, layer);
  const Triangles& triangles = sided.triangles;
  // Where the camera is inside, or the lens leaves something out, backs are seen.
  const Eigen::Index one_sided = surface.is_whole ? sided.one_sided : 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    filler.add(surface, static_cast<std::size_t>(triangles(t, 0)), static_cast<std::size_t>(triangles(t, 1)),
               static_cast<std::size_t>(triangles(t, 2)), t < one_sided);
  return filler.touched();
}

void SurfaceRaster::draw(const Points& vertices, const Triangles& triangles, std::uint8_t kind,
                         SurfaceLayer& layer) const {
  ProjectedSurface surface;
  project(vertices, triangles, surface);
  layer.touched.add(fill(surface, {triangles, 0}, kind, {0, layer.height}, layer));
}

std::vector<RowBand> row_bands(const std::vector<const ProjectedSurface*>& surfaces, int height, int count) {
  require(height > 0 && count > 0, "a picture has rows, and is cut into bands");
  std::vector<std::size_t> vertices(static_cast<std::size_t>(height), 0);
  std::size_t all = 0;
  for (const ProjectedSurface* surface : surfaces)
    for (const RasterCorner& corner : surface->corners) {
      if (!corner.visible || !(corner.pixel.y() >= 0.0F) || !(corner.pixel.y() < static_cast<float>(height)))
        continue;
      ++vertices[static_cast<std::size_t>(corner.pixel.y())];
      ++all;
    }
  std::vector<RowBand> bands;
  int begin = 0;
  std::size_t before = 0;
  for (int row = 0; row < height; ++row) {
    before += vertices[static_cast<std::size_t>(row)];
    const auto made = bands.size() + 1;
    if (made == static_cast<std::size_t>(count)) break;
    if (before * static_cast<std::size_t>(count) < all * made || before == 0) continue;
    bands.push_back({begin, row + 1});
    begin = row + 1;
  }
  if (begin < height) bands.push_back({begin, height});
  return bands;
}

}  // namespace glisson::scene
