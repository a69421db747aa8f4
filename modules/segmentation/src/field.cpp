// SPDX-License-Identifier: GPL-3.0-or-later
#include "field.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/share_out.h"

namespace glisson::segmentation {
namespace {

/// Weighted sources of one output sample along an axis.
struct Tap {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Tap> triangle_taps(int low, int high, double first, double step, int count) {
  const double half = std::max(1.0, step);
  std::vector<Tap> taps(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) {
    Tap& tap = taps[static_cast<std::size_t>(n)];
    const double centre = first + step * n;
    const int from = std::clamp(static_cast<int>(std::ceil(centre - half)), low, high - 1);
    const int to = std::clamp(static_cast<int>(std::floor(centre + half)), from, high - 1);
    tap.first = from;
    double sum = 0.0;
    for (int i = from; i <= to; ++i) {
      const double w = std::max(1e-6, 1.0 - std::abs(i - centre) / half);
      tap.weights.push_back(static_cast<float>(w));
      sum += w;
    }
    for (float& w : tap.weights) w = static_cast<float>(w / sum);
  }
  return taps;
}

/// Neighbouring samples that weigh their sources alike, each a source further than the one before it.
struct TapRun {
  std::size_t first = 0, count = 0;
};

std::vector<TapRun> runs_of(const std::vector<Tap>& taps) {
  std::vector<TapRun> runs;
  for (std::size_t n = 0; n < taps.size(); ++n) {
    const bool goes_on =
        n > 0 && taps[n].first == taps[n - 1].first + 1 && taps[n].weights == taps[n - 1].weights;
    if (goes_on)
      ++runs.back().count;
    else
      runs.push_back({n, 1});
  }
  return runs;
}

/// Applies taps along `axis` of a volume; taps index from `base`.
std::vector<float> apply_taps(const std::vector<float>& in, const Eigen::Vector3i& size, int axis, int base,
                              const std::vector<Tap>& taps) {
  Eigen::Vector3i out_size = size;
  out_size[axis] = static_cast<int>(taps.size());
  const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
  const auto row = static_cast<std::size_t>(out_size.x()), rows = static_cast<std::size_t>(out_size.y()),
             slices = static_cast<std::size_t>(out_size.z());
  std::vector<float> out(row * rows * slices);
  const std::vector<TapRun> runs = runs_of(taps);
  const auto add = [](float* to, const float* from, float weight, std::size_t count) {
    const auto length = static_cast<Eigen::Index>(count);
    Eigen::Map<Eigen::ArrayXf>(to, length) += weight * Eigen::Map<const Eigen::ArrayXf>(from, length);
  };
  /// One row of the result, from the first of its sources.
  const auto along = [&](float* to, const float* from) {
    for (const TapRun& run : runs) {
      const Tap& tap = taps[run.first];
      const float* source = from + (tap.first - base);
      for (const float w : tap.weights) add(to + run.first, source++, w, run.count);
    }
  };
  /// The same across rows that lie `stride` apart.
  const auto across = [&](float* to, const float* from, const Tap& tap, std::size_t stride) {
    from += static_cast<std::size_t>(tap.first - base) * stride;
    for (const float w : tap.weights) {
      add(to, from, w, row);
      from += stride;
    }
  };
  share_out_runs(rows * slices, least_run(row), [&](std::size_t first, std::size_t end) {
    for (std::size_t n = first; n < end; ++n) {
      const std::size_t j = n % rows, k = n / rows;
      float* to = out.data() + n * row;
      if (axis == 0)
        along(to, in.data() + nx * (j + ny * k));
      else if (axis == 1)
        across(to, in.data() + nx * ny * k, taps[j], nx);
      else
        across(to, in.data() + nx * j, taps[k], nx * ny);
    }
  });
  return out;
}

}  // namespace

Field Field::filled(float value) const {
  Field field = *this;
  field.values.assign(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
                          static_cast<std::size_t>(size.z()),
                      value);
  return field;
}

Field Field::cropped(const VoxelBox& box) const {
  Field part = *this;
  part.size = box.size();
  part.first_index += box.low.cast<double>().cwiseProduct(step);
  part.values.clear();
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j) {
      const auto row = values.begin() + static_cast<std::ptrdiff_t>(offset(box.low.x(), j, k));
      part.values.insert(part.values.end(), row, row + part.size.x());
    }
  return part;
}

Field resampled(const Image& image, const VoxelBox& box, double spacing_mm) {
  Field field;
  Eigen::Vector3i size = box.size();
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
                 static_cast<std::size_t>(size.z()));
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j) {
      const auto row = image.voxels->begin() + image.grid.offset({box.low.x(), j, k});
      values.insert(values.end(), row, row + size.x());
    }
  for (int axis = 0; axis < 3; ++axis) {
    const double step = spacing_mm / image.grid.spacing_mm[axis];
    const int count = std::max(1, static_cast<int>(std::floor((size[axis] - 1) / step)) + 1);
    const double first = box.low[axis] + 0.5 * ((size[axis] - 1) - step * (count - 1));
    values = apply_taps(values, size, axis, box.low[axis],
                        triangle_taps(box.low[axis], box.high[axis], first, step, count));
    size[axis] = count;
    field.first_index[axis] = first;
    field.step[axis] = step;
    field.spacing_mm[axis] = spacing_mm;
  }
  field.size = size;
  field.values = std::move(values);
  return field;
}

std::vector<float> on_image(const Field& field, const VoxelBox& box) {
  const Eigen::Vector3i size = box.size();
  std::array<std::vector<std::pair<int, float>>, 3> places;
  for (int axis = 0; axis < 3; ++axis)
    for (int n = box.low[axis]; n < box.high[axis]; ++n) {
      const double x = std::clamp((n - field.first_index[axis]) / field.step[axis], 0.0,
                                  static_cast<double>(field.size[axis] - 1));
      const int cell = std::min(static_cast<int>(x), std::max(0, field.size[axis] - 2));
      places[static_cast<std::size_t>(axis)].emplace_back(cell, static_cast<float>(x - cell));
    }
  const auto slice = static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y());
  std::vector<float> values(slice * static_cast<std::size_t>(size.z()));
  const std::size_t dx = field.size.x() > 1 ? 1 : 0,
                    dy = field.size.y() > 1 ? static_cast<std::size_t>(field.size.x()) : 0,
                    dz = field.size.z() > 1 ? static_cast<std::size_t>(field.size.x()) *
                                                  static_cast<std::size_t>(field.size.y())
                                            : 0;
  share_out_runs(places[2].size(), least_run(slice), [&](std::size_t first, std::size_t end) {
    float* to = values.data() + first * slice;
    for (std::size_t n = first; n < end; ++n) {
      const auto& [k, c] = places[2][n];
      for (const auto& [j, b] : places[1])
        for (const auto& [i, a] : places[0]) {
          const float* p = field.values.data() + field.offset(i, j, k);
          const float v00 = p[0] + a * (p[dx] - p[0]), v10 = p[dy] + a * (p[dy + dx] - p[dy]);
          const float v01 = p[dz] + a * (p[dz + dx] - p[dz]),
                      v11 = p[dz + dy] + a * (p[dz + dy + dx] - p[dz + dy]);
          const float v0 = v00 + b * (v10 - v00), v1 = v01 + b * (v11 - v01);
          *to++ = v0 + c * (v1 - v0);
        }
    }
  });
  return values;
}

void diffuse(Field& field, double contrast, int iterations) {
  const std::array<std::size_t, 3> stride = {
      1, static_cast<std::size_t>(field.size.x()),
      static_cast<std::size_t>(field.size.x()) * static_cast<std::size_t>(field.size.y())};
  const auto inverse_square = static_cast<float>(1.0 / (contrast * contrast));
  constexpr float kStep = 1.0F / 7.0F;  // below 1/6: stable
  std::vector<float> next = field.values;
  const auto slices = [&](std::size_t first, std::size_t end) {
    std::size_t at = first * stride[2];
    for (int k = static_cast<int>(first); k < static_cast<int>(end); ++k)
      for (int j = 0; j < field.size.y(); ++j)
        for (int i = 0; i < field.size.x(); ++i, ++at) {
          const float centre = field.values[at];
          float flow = 0.0F;
          const auto from = [&](std::size_t neighbour) {
            const float d = field.values[neighbour] - centre;
            flow += d / (1.0F + d * d * inverse_square);
          };
          if (i > 0) from(at - stride[0]);
          if (i + 1 < field.size.x()) from(at + stride[0]);
          if (j > 0) from(at - stride[1]);
          if (j + 1 < field.size.y()) from(at + stride[1]);
          if (k > 0) from(at - stride[2]);
          if (k + 1 < field.size.z()) from(at + stride[2]);
          next[at] = centre + kStep * flow;
        }
  };
  for (int n = 0; n < iterations; ++n) {
    share_out_runs(static_cast<std::size_t>(field.size.z()), least_run(stride[2]), slices);
    field.values.swap(next);
  }
}

void denoise(Field& ct) { diffuse(ct, 15.0, 10); }

void smooth(Field& field, double sigma_mm) {
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = sigma_mm / field.spacing_mm[axis];
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<Tap> taps(static_cast<std::size_t>(field.size[axis]));
    for (int n = 0; n < field.size[axis]; ++n) {
      // Samples beyond the edge repeat the edge: their weight goes to it.
      Tap& tap = taps[static_cast<std::size_t>(n)];
      tap.first = std::max(0, n - radius);
      const int last = std::min(field.size[axis] - 1, n + radius);
      tap.weights.assign(static_cast<std::size_t>(last - tap.first) + 1, 0.0F);
      double sum = 0.0;
      for (int d = -radius; d <= radius; ++d) sum += std::exp(-0.5 * d * d / (sigma * sigma));
      for (int d = -radius; d <= radius; ++d)
        tap.weights[static_cast<std::size_t>(std::clamp(n + d, tap.first, last) - tap.first)] +=
            static_cast<float>(std::exp(-0.5 * d * d / (sigma * sigma)) / sum);
    }
    field.values = apply_taps(field.values, field.size, axis, 0, taps);
  }
}

std::vector<float> gradient_magnitude(const Field& field) {
  std::vector<float> result(field.values.size());
  const Eigen::Vector3i s = field.size;
  std::size_t at = 0;
  for (int k = 0; k < s.z(); ++k)
    for (int j = 0; j < s.y(); ++j)
      for (int i = 0; i < s.x(); ++i, ++at) {
        const auto difference = [&](int a, int low, int high, auto&& value) {
          const float span = static_cast<float>((high - low) * field.spacing_mm[a]);
          return high > low ? (value(high) - value(low)) / span : 0.0F;
        };
        const float x = difference(0, std::max(0, i - 1), std::min(s.x() - 1, i + 1),
                                   [&](int n) { return field.values[field.offset(n, j, k)]; });
        const float y = difference(1, std::max(0, j - 1), std::min(s.y() - 1, j + 1),
                                   [&](int n) { return field.values[field.offset(i, n, k)]; });
        const float z = difference(2, std::max(0, k - 1), std::min(s.z() - 1, k + 1),
                                   [&](int n) { return field.values[field.offset(i, j, n)]; });
        result[at] = std::sqrt(x * x + y * y + z * z);
      }
  return result;
}

}  // namespace glisson::segmentation
