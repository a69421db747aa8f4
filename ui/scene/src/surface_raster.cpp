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

/// The largest slope up to which Brown's radial polynomial grows: beyond, the picture would fold back.
double largest_slope(const Eigen::Matrix<double, 5, 1>& distortion) {
  constexpr double kStep = 0.01, kWidest = 4.0;
  const double k1 = distortion[0], k2 = distortion[1], k3 = distortion[4];
  double slope = 0.0;
  while (slope < kWidest) {
    const double s = (slope + kStep) * (slope + kStep);
    if (1.0 + 3.0 * k1 * s + 5.0 * k2 * s * s + 7.0 * k3 * s * s * s <= 0.0) break;
    slope += kStep;
  }
  return slope;
}

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

float longest_edge(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
  return std::sqrt(std::max(std::max((a - b).squaredNorm(), (b - c).squaredNorm()), (c - a).squaredNorm()));
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

struct ScreenCorner {
  float x, y, inverse_depth, facing;
};

/// A corner's share in a point of the triangle: 0 on the opposite edge, through (x, y).
struct Weight {
  Weight(float right, float down, float zero_x, float zero_y)
      : step_x(right), step_y(down), x(zero_x), y(zero_y), columns(right != 0.0F ? 1.0F / right : 0.0F) {}
  float step_x, step_y, x, y;
  float columns;  ///< to walk until the share has grown by one

  float at(float column, float row) const { return (column - x) * step_x + (row - y) * step_y; }
  /// Narrows a row to where the share is not negative.
  void bound(float row, float& from, float& to) const {
    constexpr float kRim = -1e-4F;  // neighbours share their edges: no gaps
    const float rest = kRim - (row - y) * step_y;
    if (step_x > 0.0F)
      from = std::max(from, x + rest * columns);
    else if (step_x < 0.0F)
      to = std::min(to, x + rest * columns);
    else if (rest > 0.0F)
      to = from - 1.0F;
  }
};

/// Fills a band's rows of one small triangle. Pixel centres are whole numbers.
void fill_small(const std::array<ScreenCorner, 3>& corners, std::uint8_t kind, const RowBand& band,
                SurfaceLayer& layer, PixelBox& touched) {
  const auto& [a, b, c] = corners;
  const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (!(std::abs(area) > 1e-6F)) return;
  // Limited before they are whole numbers: a corner may lie far beside the picture.
  const int left = up(std::max(0.0F, least(a.x, b.x, c.x)));
  const int right = down(std::min(static_cast<float>(layer.width - 1), most(a.x, b.x, c.x)));
  const int top = up(std::max(static_cast<float>(band.first), least(a.y, b.y, c.y)));
  const int bottom = down(std::min(static_cast<float>(band.end - 1), most(a.y, b.y, c.y)));
  if (left > right || top > bottom) return;
  touched.add(left, right, top, bottom);
  const float scale = 1.0F / area;
  // The corners' weights are linear over the picture.
  const Weight weight_a((b.y - c.y) * scale, (c.x - b.x) * scale, b.x, b.y);
  const Weight weight_b((c.y - a.y) * scale, (a.x - c.x) * scale, a.x, a.y);
  const Weight weight_c((a.y - b.y) * scale, (b.x - a.x) * scale, a.x, a.y);
  for (int y = top; y <= bottom; ++y) {
    const auto row = static_cast<float>(y);
    float from = static_cast<float>(left), to = static_cast<float>(right);
    for (const Weight* weight : {&weight_a, &weight_b, &weight_c}) weight->bound(row, from, to);
    if (!(from <= to)) continue;
    const int first = up(from), last = down(to);
    if (first > last) continue;
    const auto start = static_cast<float>(first);
    const float at_a = weight_a.at(start, row), at_b = weight_b.at(start, row),
                at_c = weight_c.at(start, row);
    const auto mix = [&](float of_a, float of_b, float of_c) {
      return std::pair(at_a * of_a + at_b * of_b + at_c * of_c,
                       weight_a.step_x * of_a + weight_b.step_x * of_b + weight_c.step_x * of_c);
    };
    auto [inverse, inverse_step] = mix(a.inverse_depth, b.inverse_depth, c.inverse_depth);
    auto [facing, facing_step] = mix(a.facing, b.facing, c.facing);
    std::size_t pixel = layer.at(y, first);
    for (int x = first; x <= last; ++x, ++pixel, inverse += inverse_step, facing += facing_step) {
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
  const double slope = largest_slope(camera.distortion);
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
  set_facings(vertices, triangles, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i].p = vertices.row(static_cast<Eigen::Index>(i)).transpose();
    project(corners[i]);
  }
}

/// Fills what of a surface lies in a band.
class SurfaceRaster::BandFiller {
 public:
  BandFiller(const SurfaceRaster& raster, std::uint8_t kind, const RowBand& band, SurfaceLayer& layer)
      : raster_(raster), kind_(kind), band_(band), layer_(layer) {}

  void add(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c) { add(a, b, c, 0); }
  const PixelBox& touched() const { return touched_; }

 private:
  void add(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c, int depth) {
    const bool whole = a.visible && b.visible && c.visible;
    if (whole && (depth == kDeepest || longest_edge(a.pixel, b.pixel, c.pixel) <= kLongestEdge)) {
      if (is_beside(a, b, c)) return;
      fill_small({on_screen(a), on_screen(b), on_screen(c)}, kind_, band_, layer_, touched_);
      return;
    }
    if (!whole) {
      const double size = std::max({(a.p - b.p).norm(), (b.p - c.p).norm(), (c.p - a.p).norm()});
      if (depth == kDeepest || !(size > kSmallestDivided)) return;
    }
    const RasterCorner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    add(a, ab, ca, depth + 1);
    add(ab, b, bc, depth + 1);
    add(ca, bc, c, depth + 1);
    add(ab, bc, ca, depth + 1);
  }
  bool is_beside(const RasterCorner& a, const RasterCorner& b, const RasterCorner& c) const {
    return least(a.pixel.y(), b.pixel.y(), c.pixel.y()) > static_cast<float>(band_.end - 1) ||
           most(a.pixel.y(), b.pixel.y(), c.pixel.y()) < static_cast<float>(band_.first);
  }
  static ScreenCorner on_screen(const RasterCorner& corner) {
    return {corner.pixel.x(), corner.pixel.y(), static_cast<float>(1.0 / corner.p.z()), corner.facing};
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

PixelBox SurfaceRaster::fill(const ProjectedSurface& surface, const Triangles& triangles, std::uint8_t kind,
                             const RowBand& band, SurfaceLayer& layer) const {
  require(kind != 0, "kind 0 stands for nothing");
  require(layer.width == camera_.width && layer.height == camera_.height, "a layer has the camera's size");
  require(band.first >= 0 && band.end <= layer.height, "a band lies in its picture");
  BandFiller filler(*this, kind, band, layer);
  const std::vector<RasterCorner>& corners = surface.corners;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    filler.add(corners[static_cast<std::size_t>(triangles(t, 0))],
               corners[static_cast<std::size_t>(triangles(t, 1))],
               corners[static_cast<std::size_t>(triangles(t, 2))]);
  return filler.touched();
}

void SurfaceRaster::draw(const Points& vertices, const Triangles& triangles, std::uint8_t kind,
                         SurfaceLayer& layer) const {
  ProjectedSurface surface;
  project(vertices, triangles, surface);
  layer.touched.add(fill(surface, triangles, kind, {0, layer.height}, layer));
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
