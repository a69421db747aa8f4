// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/label_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

constexpr int kBricksOfBlock = 2;
constexpr int kBlock = kBricksOfBlock * LabelVolume::kSide;  ///< voxels
constexpr int kRelaxations = 2;
/// Cells around a block that its surface depends on: one for a face, one for its normals, one more for where
/// a vertex starts, one for each time that it is drawn towards its neighbours, and one beyond the volume.
constexpr int kHalo = 4 + kRelaxations;
constexpr int kLargestStride = 4;

/// A copy of the voxels of a box that may reach beyond the volume.
struct Region {
  Eigen::Vector3i low, size;
  std::vector<Label> voxels;

  Region(const LabelVolume& labels, const Eigen::Vector3i& from, const Eigen::Vector3i& to)
      : low(from), size(to - from) {
    voxels.assign(static_cast<std::size_t>(size.prod()), Label{0});
    const Eigen::Vector3i first = from.cwiseMax(0), last = to.cwiseMin(labels.grid().size);
    if ((first.array() >= last.array()).any()) return;
    constexpr int kSide = LabelVolume::kSide;
    for (int k = first.z(); k < last.z(); ++k)
      for (int j = first.y(); j < last.y(); ++j)
        for (int i = first.x(); i < last.x();) {
          const Eigen::Vector3i place(i / kSide, j / kSide, k / kSide);
          const int end = std::min(last.x(), (place.x() + 1) * kSide);
          const auto& brick = labels.brick(static_cast<std::size_t>(
              place.x() + labels.brick_counts().x() * (place.y() + labels.brick_counts().y() * place.z())));
          if (brick)
            std::copy_n(brick->begin() + i % kSide + kSide * (j % kSide + kSide * (k % kSide)), end - i,
                        voxels.begin() + offset(i, j, k));
          i = end;
        }
  }
  std::ptrdiff_t offset(int i, int j, int k) const {
    return (i - low.x()) + static_cast<std::ptrdiff_t>(size.x()) *
                               ((j - low.y()) + static_cast<std::ptrdiff_t>(size.y()) * (k - low.z()));
  }
  Label at(int i, int j, int k) const { return voxels[static_cast<std::size_t>(offset(i, j, k))]; }
};

bool is_liver_body(Label label) {
  return label == structure::kParenchyma || label == structure::kPortalVein ||
         label == structure::kHepaticVeins || label == structure::kArtery || is_lesion(label);
}

/// Voxels that one cell takes along each axis.
Eigen::Vector3i stride_of(const VolumeGrid& grid, Label label) {
  const double cell_mm = label == structure::kParenchyma ? 1.6 : 0.8;
  Eigen::Vector3i stride;
  for (int k = 0; k < 3; ++k) {
    int s = 1;
    while (2 * s <= kLargestStride && 2 * s * grid.spacing_mm[k] <= cell_mm) s *= 2;
    stride[k] = s;
  }
  return stride;
}

/// Surface nets of one label in one block.
class Net {
 public:
  Net(const Region& region, const Eigen::Vector3i& block, Label label, const Eigen::Vector3i& stride)
      : stride_(stride) {
    for (int k = 0; k < 3; ++k) {
      count_[k] = kBlock / stride[k] + 2 * kHalo;
      first_[k] = block[k] * (kBlock / stride[k]) - kHalo;
      own_from_[k] = block[k] == 0 ? kHalo - 1 : kHalo;  // nobody else closes it at the volume's end
    }
    fill(region, label);
  }

  BlockSurface surface(const VolumeGrid& grid) {
    place_vertices();
    for (int turn = 0; turn < kRelaxations; ++turn) relax();
    return collect(grid);
  }
  bool has_faces() const { return inside_cells_ > 0 && inside_cells_ < full_.size(); }

 private:
  std::size_t cell(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(count_.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(count_.y()) * static_cast<std::size_t>(k));
  }
  std::size_t step(int axis) const {
    return axis == 0   ? 1
           : axis == 1 ? static_cast<std::size_t>(count_.x())
                       : static_cast<std::size_t>(count_.x()) * static_cast<std::size_t>(count_.y());
  }
  bool inside(std::size_t c) const { return inside_[c] != 0; }

  /// How many of a cell's voxels are the label's, and whether its surface is drawn there.
  void fill(const Region& region, Label label) {
    const bool whole = label == structure::kParenchyma;
    full_.assign(static_cast<std::size_t>(count_.prod()), 0);
    own_.assign(full_.size(), 0);
    for (int k = 0; k < count_.z() * stride_.z(); ++k)
      for (int j = 0; j < count_.y() * stride_.y(); ++j) {
        const std::size_t line = cell(0, j / stride_.y(), k / stride_.z());
        const Eigen::Vector3i from = first_.cwiseProduct(stride_);
        const Label* voxel = region.voxels.data() + region.offset(from.x(), from.y() + j, from.z() + k);
        for (int i = 0; i < count_.x(); ++i)
          for (int n = 0; n < stride_.x(); ++n, ++voxel) {
            if (*voxel == 0) continue;
            const std::size_t c = line + static_cast<std::size_t>(i);
            const bool is_own = *voxel == label;
            if (is_own || (whole && is_liver_body(*voxel))) ++full_[c];
            if (is_own) own_[c] = 1;
          }
      }
    inside_.assign(full_.size(), 0);
    low_ = count_;
    high_.setZero();
    for (int k = 0; k < count_.z(); ++k)
      for (int j = 0; j < count_.y(); ++j)
        for (int i = 0; i < count_.x(); ++i) {
          const std::size_t c = cell(i, j, k);
          if (2 * full_[c] < stride_.prod()) continue;
          inside_[c] = 1;
          ++inside_cells_;
          low_ = low_.cwiseMin(Eigen::Vector3i(i, j, k));
          high_ = high_.cwiseMax(Eigen::Vector3i(i, j, k));
        }
    // Cubes begin a cell before what they hold.
    low_ = (low_.array() - 1).max(0).matrix();
  }

  /// One vertex in each cube of eight cells that the surface crosses: the mean of the crossings.
  void place_vertices() {
    vertex_of_.assign(full_.size(), -1);
    const double half = 0.5 * stride_.prod();
    for (int k = low_.z(); k <= std::min(high_.z(), count_.z() - 2); ++k)
      for (int j = low_.y(); j <= std::min(high_.y(), count_.y() - 2); ++j)
        for (int i = low_.x(); i <= std::min(high_.x(), count_.x() - 2); ++i) {
          const std::size_t c = cell(i, j, k);
          unsigned mask = 0;
          for (unsigned corner = 0; corner < 8; ++corner)
            if (inside(corner_of(c, corner))) mask |= 1U << corner;
          if (mask == 0 || mask == 255) continue;
          Eigen::Vector3f sum = Eigen::Vector3f::Zero();
          int crossings = 0;
          for (unsigned corner = 0; corner < 8; ++corner)
            for (unsigned axis = 0; axis < 3; ++axis) {
              const unsigned other = corner | (1U << axis);
              if (other == corner || ((mask >> corner) & 1U) == ((mask >> other) & 1U)) continue;
              const double a = full_[corner_of(c, corner)], b = full_[corner_of(c, other)];
              Eigen::Vector3f p(static_cast<float>(corner & 1U), static_cast<float>((corner >> 1U) & 1U),
                                static_cast<float>((corner >> 2U) & 1U));
              // Half full counts as inside; a cell's value never equals its outer neighbour's.
              p[static_cast<int>(axis)] += static_cast<float>(std::clamp((half - a) / (b - a), 0.05, 0.95));
              sum += p;
              ++crossings;
            }
          vertex_of_[c] = static_cast<int>(places_.size());
          places_.push_back(sum / static_cast<float>(crossings));
          cubes_.push_back({i, j, k});
        }
  }
  std::size_t corner_of(std::size_t c, unsigned corner) const {
    return c + (corner & 1U) + step(1) * ((corner >> 1U) & 1U) + step(2) * ((corner >> 2U) & 1U);
  }

  /// Draws each vertex to the middle of its neighbours, as far as its cube allows.
  void relax() {
    std::vector<Eigen::Vector3f> next = places_;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      const Eigen::Vector3i& cube = cubes_[v];
      const std::size_t c = cell(cube.x(), cube.y(), cube.z());
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      int neighbours = 0;
      for (int axis = 0; axis < 3; ++axis)
        for (const bool up : {false, true}) {
          if (up ? cube[axis] + 1 >= count_[axis] : cube[axis] == 0) continue;
          const int other = vertex_of_[up ? c + step(axis) : c - step(axis)];
          if (other < 0) continue;
          sum += places_[static_cast<std::size_t>(other)];
          sum[axis] += up ? 1.0F : -1.0F;
          ++neighbours;
        }
      if (neighbours == 0) continue;
      next[v] = (sum / static_cast<float>(neighbours))
                    .cwiseMax(Eigen::Vector3f::Zero())
                    .cwiseMin(Eigen::Vector3f::Ones());
    }
    places_ = std::move(next);
  }

  /// Emits a face for each pair of cells of which one is inside; those of the block itself, and for their
  /// normals those about them.
  BlockSurface collect(const VolumeGrid& grid) const {
    std::vector<Eigen::Vector3f> points(places_.size()), normals(places_.size(), Eigen::Vector3f::Zero());
    for (std::size_t v = 0; v < places_.size(); ++v) {
      // The middle of cell c is voxel (c + 1/2) stride - 1/2.
      const Eigen::Vector3d voxel =
          ((places_[v].cast<double>() + (first_ + cubes_[v]).cast<double>()).array() + 0.5) *
              stride_.cast<double>().array() -
          0.5;
      points[v] = grid.p_in_ct(voxel).xyz.cast<float>();
    }
    const bool mirrored = grid.direction.determinant() < 0.0;
    std::vector<std::array<int, 3>> triangles;
    const auto first = [&](int axis) { return std::max(1, low_[axis]); };
    const auto last = [&](int axis) { return std::min(high_[axis], count_[axis] - 3); };
    for (int k = first(2); k <= last(2); ++k)
      for (int j = first(1); j <= last(1); ++j)
        for (int i = first(0); i <= last(0); ++i)
          for (int axis = 0; axis < 3; ++axis)
            add_face({i, j, k}, axis, mirrored, points, normals, triangles);
    return pack(points, normals, triangles);
  }

  void add_face(const Eigen::Vector3i& at, int axis, bool mirrored,
                const std::vector<Eigen::Vector3f>& points, std::vector<Eigen::Vector3f>& normals,
                std::vector<std::array<int, 3>>& triangles) const {
    const std::size_t c = cell(at.x(), at.y(), at.z());
    const std::size_t other = c + step(axis);
    const bool here = inside(c);
    if (here == inside(other) || own_[here ? c : other] == 0) return;
    const std::size_t u = step((axis + 1) % 3), v = step((axis + 2) % 3);
    std::array<int, 4> quad = {vertex_of_[c - u - v], vertex_of_[c - v], vertex_of_[c], vertex_of_[c - u]};
    if (here == mirrored) std::swap(quad[1], quad[3]);
    const auto p = [&](std::size_t corner) { return points[static_cast<std::size_t>(quad[corner])]; };
    const Eigen::Vector3f normal = (p(2) - p(0)).cross(p(3) - p(1));  // twice the area
    for (const int vertex : quad) normals[static_cast<std::size_t>(vertex)] += normal;
    for (int k = 0; k < 3; ++k)
      if (at[k] < own_from_[k] || at[k] >= count_[k] - kHalo) return;  // a neighbour's face
    // The shorter diagonal.
    const std::size_t turn = (p(2) - p(0)).squaredNorm() <= (p(3) - p(1)).squaredNorm() ? 0 : 1;
    triangles.push_back({quad[turn], quad[turn + 1], quad[turn + 2]});
    triangles.push_back({quad[turn], quad[turn + 2], quad[(turn + 3) % 4]});
  }

  static BlockSurface pack(const std::vector<Eigen::Vector3f>& points,
                           const std::vector<Eigen::Vector3f>& normals,
                           const std::vector<std::array<int, 3>>& triangles) {
    BlockSurface surface;
    std::vector<int> number(points.size(), -1);
    std::vector<std::size_t> kept;
    surface.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(triangles[t][k]);
        if (number[vertex] < 0) {
          number[vertex] = static_cast<int>(kept.size());
          kept.push_back(vertex);
        }
        surface.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) = number[vertex];
      }
    surface.vertices.resize(static_cast<Eigen::Index>(kept.size()), 3);
    surface.normals.resize(surface.vertices.rows(), 3);
    for (std::size_t v = 0; v < kept.size(); ++v) {
      const auto row = static_cast<Eigen::Index>(v);
      surface.vertices.row(row) = points[kept[v]].transpose();
      const float length = normals[kept[v]].norm();
      surface.normals.row(row) = length > 0.0F ? (normals[kept[v]] / length).eval().transpose()
                                               : Eigen::RowVector3f(0.0F, 0.0F, 1.0F);
    }
    return surface;
  }

  Eigen::Vector3i stride_, count_, first_, own_from_;  ///< of cells
  std::vector<std::uint8_t> full_, own_, inside_;
  Eigen::Vector3i low_, high_;  ///< of what is inside
  std::size_t inside_cells_ = 0;
  std::vector<int> vertex_of_;  ///< of the cube that begins at a cell
  /// Within their cubes, [0, 1]: so that two blocks compute a vertex that they share to the bit alike.
  std::vector<Eigen::Vector3f> places_;
  std::vector<Eigen::Vector3i> cubes_;
};

std::set<Label> labels_in(const Region& region) {
  std::set<Label> found;
  Label last = 0;
  for (const Label label : region.voxels)
    if (label != last) {
      last = label;
      if (label != 0) found.insert(label);
    }
  return found;
}

}  // namespace

Cancellable<LabelSurfaces> LabelSurfaces::of(const LabelVolume& labels, const LabelSurfaces* former,
                                             const std::function<bool()>& cancelled) {
  LabelSurfaces surfaces;
  surfaces.labels_ = labels;
  if (labels.empty()) return surfaces;
  const bool comparable = former != nullptr && former->labels_.brick_count() == labels.brick_count() &&
                          former->labels_.grid().same_as(labels.grid());
  if (comparable) surfaces.blocks_ = former->blocks_;
  const Eigen::Vector3i bricks = labels.brick_counts();
  const Eigen::Vector3i blocks = (bricks.array() + kBricksOfBlock - 1) / kBricksOfBlock;
  const auto brick_number = [&](int i, int j, int k) {
    return static_cast<std::size_t>(i + bricks.x() * (j + bricks.y() * k));
  };
  /// The block's bricks and those about it: all empty, and all as before?
  const auto look = [&](const Eigen::Vector3i& block) {
    std::pair<bool, bool> empty_and_same(true, comparable);
    const Eigen::Vector3i from = (kBricksOfBlock * block.array() - 1).cwiseMax(0),
                          to = (kBricksOfBlock * (block.array() + 1)).cwiseMin(bricks.array() - 1);
    for (int k = from.z(); k <= to.z(); ++k)
      for (int j = from.y(); j <= to.y(); ++j)
        for (int i = from.x(); i <= to.x(); ++i) {
          const std::size_t n = brick_number(i, j, k);
          if (labels.brick(n)) empty_and_same.first = false;
          if (comparable && labels.brick(n) != former->labels_.brick(n)) empty_and_same.second = false;
        }
    return empty_and_same;
  };
  Eigen::Vector3i halo = Eigen::Vector3i::Zero();
  for (const Label label : {structure::kParenchyma, structure::kPortalVein})
    halo = halo.cwiseMax(kHalo * stride_of(labels.grid(), label));
  std::size_t number = 0;
  for (int k = 0; k < blocks.z(); ++k)
    for (int j = 0; j < blocks.y(); ++j)
      for (int i = 0; i < blocks.x(); ++i, ++number) {
        const Eigen::Vector3i block(i, j, k);
        const auto [empty, same] = look(block);
        if (same) continue;
        if (cancelled && cancelled()) return {};
        std::erase_if(surfaces.blocks_, [&](const auto& entry) { return entry.first.second == number; });
        if (empty) continue;
        ++surfaces.blocks_made_;
        const Region region(labels, kBlock * block - halo, kBlock * (block.array() + 1).matrix() + halo);
        for (const Label label : labels_in(region)) {
          Net net(region, block, label, stride_of(labels.grid(), label));
          if (!net.has_faces()) continue;
          auto surface = std::make_shared<BlockSurface>(net.surface(labels.grid()));
          if (surface->triangles.rows() > 0) surfaces.blocks_[{label, number}] = std::move(surface);
        }
      }
  return surfaces;
}

}  // namespace glisson::scene
