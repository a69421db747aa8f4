// SPDX-License-Identifier: GPL-3.0-or-later
#include "ct_scene.h"

namespace glisson::insilico {

Canvas::Canvas(const VolumeGrid& grid, float hounsfield) : Canvas(grid, hounsfield, {}) {}

Canvas::Canvas(const VolumeGrid& grid, float hounsfield, SignalOf signal)
    : grid_(grid), signal_(std::move(signal)) {
  voxels_.assign(static_cast<std::size_t>(grid.voxel_count()), static_cast<float>(shown(hounsfield)));
}

VolumeGrid ct_grid(const Eigen::Vector3d& spacing_mm) {
  const Vec low(-180, -148, -146), high(180, 152, 174);
  VolumeGrid grid;
  grid.spacing_mm = spacing_mm;
  for (int a = 0; a < 3; ++a)
    grid.size[a] = std::max(2, static_cast<int>(std::lround((high[a] - low[a]) / spacing_mm[a])));
  grid.origin_mm = low + 0.5 * spacing_mm;
  return grid;
}

namespace {

/// Gaussian along one axis, mirrored at the ends.
void blur_along(std::vector<float>& voxels, const VolumeGrid& grid, int axis, double sigma_voxels) {
  const int reach = static_cast<int>(std::ceil(3.0 * sigma_voxels));
  if (reach < 1 || sigma_voxels < 0.15) return;
  std::vector<float> kernel(static_cast<std::size_t>(2 * reach + 1));
  float sum = 0.0F;
  for (int i = -reach; i <= reach; ++i)
    sum += kernel[static_cast<std::size_t>(i + reach)] =
        static_cast<float>(std::exp(-0.5 * i * i / (sigma_voxels * sigma_voxels)));
  for (float& k : kernel) k /= sum;

  const long strides[3] = {1, grid.size.x(), static_cast<long>(grid.size.x()) * grid.size.y()};
  const int n = grid.size[axis];
  // Rows of neighbouring lines together: the inner loop runs along memory.
  const int width = axis == 0 ? 1 : grid.size.x();
  const int other = axis == 2 ? grid.size.y() : grid.size.z();
  const long other_stride = axis == 2 ? strides[1] : strides[2];
  const int inner = axis == 0 ? grid.size.y() : 1;
  std::vector<float> line(static_cast<std::size_t>(n) * static_cast<std::size_t>(width));
  for (int o = 0; o < other; ++o)
    for (int m = 0; m < inner; ++m) {
      float* start = voxels.data() + o * other_stride + m * strides[1];
      for (int s = 0; s < n; ++s)
        std::copy_n(start + s * strides[axis], width, line.data() + static_cast<long>(s) * width);
      for (int s = 0; s < n; ++s) {
        float* out = start + s * strides[axis];
        std::fill_n(out, width, 0.0F);
        for (int i = -reach; i <= reach; ++i) {
          int from = s + i;
          if (from < 0) from = -from - 1;
          if (from >= n) from = 2 * n - from - 1;
          const float* in = line.data() + static_cast<long>(std::clamp(from, 0, n - 1)) * width;
          const float weight = kernel[static_cast<std::size_t>(i + reach)];
          for (int w = 0; w < width; ++w) out[w] += weight * in[w];
        }
      }
    }
}

void blur(std::vector<float>& voxels, const VolumeGrid& grid, double sigma_mm) {
  if (voxels.empty()) return;
  for (int axis = 0; axis < 3; ++axis) blur_along(voxels, grid, axis, sigma_mm / grid.spacing_mm[axis]);
}

}  // namespace

std::vector<std::int16_t> scan(const Canvas& canvas, double blur_mm, double noise_hu, std::uint64_t seed) {
  std::vector<float> image = canvas.voxels();
  blur(image, canvas.grid(), blur_mm);
  std::vector<float> noise(noise_hu > 0.0 ? image.size() : 0);
  for (std::size_t i = 0; i < noise.size(); ++i) {
    // The sum of four uniform numbers is near enough to a Gaussian, and blurring makes it more so.
    const std::uint64_t h = hash_of(seed * 0x9e3779b97f4a7c15ULL + i);
    noise[i] = static_cast<float>((h & 0xffff) + ((h >> 16) & 0xffff) + ((h >> 32) & 0xffff) + (h >> 48)) -
               131070.0F;
  }
  // Reconstruction kernels correlate the noise over a little more than a voxel.
  blur(noise, canvas.grid(), 0.55 * canvas.grid().spacing_mm.x());
  double square = 0.0;
  for (const float value : noise) square += static_cast<double>(value) * value;
  const double scale = noise.empty() ? 0.0 : noise_hu / std::sqrt(square / static_cast<double>(noise.size()));

  std::vector<std::int16_t> voxels(image.size());
  for (std::size_t i = 0; i < image.size(); ++i) {
    const double value = image[i] + (noise.empty() ? 0.0 : scale * noise[i]);
    voxels[i] = static_cast<std::int16_t>(std::lround(std::clamp(value, -1024.0, 3071.0)));
  }
  return voxels;
}

}  // namespace glisson::insilico
