// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/mesh.h"
#include "glisson/ui/scene/sided_triangles.h"

namespace glisson::scene {

/// A rectangle of whole pixels; empty when nothing is in it.
struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;
  bool empty() const { return width <= 0 || height <= 0; }
  int right() const { return left + width; }   ///< one beyond
  int bottom() const { return top + height; }  ///< likewise
  /// Grows to hold columns `from` to `to` and rows `first` to `last`, all included.
  void add(int from, int to, int first, int last);
  void add(const PixelBox& other);
  /// Wider by `pixels` on all sides, cut to a picture of this size.
  PixelBox around(int pixels, int picture_width, int picture_height) const;
};

/// What a camera sees of some surfaces: for each pixel (rows from the top) the nearest one.
struct SurfaceLayer {
  int width = 0, height = 0;
  std::vector<std::uint8_t> kind;    ///< as given to SurfaceRaster::draw(); 0: nothing there
  std::vector<std::uint8_t> facing;  ///< 255 where the surface faces the camera, 0 where it is seen edge-on
  std::vector<float> inverse_depth;  ///< 1 / z, per metre; 0: nothing there
  PixelBox touched;                  ///< there is nothing outside of it

  bool empty() const { return kind.empty(); }
  std::size_t at(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
  /// Metres along z. @pre something is there
  float depth(std::size_t pixel) const { return 1.0F / inverse_depth[pixel]; }
};

/// A vertex before the camera.
struct RasterCorner {
  Eigen::Vector3d p;      ///< camera frame, metres
  Eigen::Vector2f pixel;  ///< only when `visible`
  float facing = 0.0F;
  bool visible = false;
};

/// What a triangle of a few pixels needs of a vertex.
struct ScreenCorner {
  float x, y;           ///< pixels
  float inverse_depth;  ///< 1 / z, per metre; 0: not visible
  float facing;
};

/// A surface's vertices before the camera.
struct ProjectedSurface {
  std::vector<RasterCorner> corners;
  bool is_whole = false;                ///< all vertices are visible
  std::vector<ScreenCorner> on_screen;  ///< the same vertices: little memory is walked through
};

/// Some rows of a picture.
struct RowBand {
  int first = 0, end = 0;  ///< one beyond the last
};
/// Cuts a picture's rows into bands that hold about as many vertices each.
/// @pre count is positive
std::vector<RowBand> row_bands(const std::vector<const ProjectedSurface*>& surfaces, int height, int count);

/// Draws triangles into layers with a depth buffer, through the camera's whole model, lens included: vertices
/// go through Camera::project(), and what would be long on the picture is divided, so that straight edges
/// follow the lens within a fraction of a pixel. A live overlay holds tens of thousands of triangles of a few
/// pixels each; for those this takes a few milliseconds, where OpenGL in software takes hundreds. The same
/// input gives the same picture to the bit.
class SurfaceRaster {
 public:
  /// @pre the camera has a size and focal lengths.
  explicit SurfaceRaster(const Camera& camera);

  SurfaceLayer layer() const;
  /// Takes everything away, in the time of what was drawn. A layer of another camera, or a fresh one, is made
  /// anew.
  void clear(SurfaceLayer& layer) const;
  /// @param vertices camera frame, metres. What is closer than 5 mm, or so far off the axis that the lens no
  /// longer keeps directions apart (Camera::maps()), is not drawn. @pre kind is not 0.
  void draw(const Points& vertices, const Triangles& triangles, std::uint8_t kind, SurfaceLayer& layer) const;

  /// The first half of draw(): where the vertices (camera frame) are on the picture. Surfaces may be
  /// projected side by side.
  /// @param surface its memory is used again.
  void project(const Points& vertices, const Triangles& triangles, ProjectedSurface& surface) const;
  /// The second half, of the rows of a band alone: bands of one layer may be filled side by side, and are the
  /// same to the bit as the whole. @param triangles those that were projected. @pre as draw()
  /// @return where something was drawn; the layer's `touched` is left to the caller.
  PixelBox fill(const ProjectedSurface& surface, const SidedTriangles& triangles, std::uint8_t kind,
                const RowBand& band, SurfaceLayer& layer) const;

  static constexpr double kNear = 0.005;  ///< metres
  /// Whether a point (camera frame, metres) has a place on the picture or beside it.
  static bool is_mapped(const Camera& camera, const Eigen::Vector3d& p) {
    return p.z() > kNear && camera.maps(p);
  }

 private:
  class BandFiller;
  void project(RasterCorner& corner) const;

  Camera camera_;
  double largest_slope_squared_ = 0.0;  ///< of a ray that the lens maps one to one
};

}  // namespace glisson::scene
