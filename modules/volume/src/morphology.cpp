// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/morphology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/volume/voxel_neighbours.h"

namespace glisson {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// Room for one line of the distance transform.
struct Line {
  std::vector<float> in, out;
  std::vector<int> vertex;
  std::vector<double> bound;
  explicit Line(int length)
      : in(static_cast<std::size_t>(length)),
        out(static_cast<std::size_t>(length)),
        vertex(static_cast<std::size_t>(length)),
        bound(static_cast<std::size_t>(length) + 1) {}
};

/// Lower envelope of the parabolas in[q] + (h (p - q))^2, into out; above `cap` infinite.
void transform_line(Line& line, int length, double h, float cap) {
  const double h2 = h * h;
  int top = -1;
  for (int q = 0; q < length; ++q) {
    const double f = line.in[static_cast<std::size_t>(q)];
    if (!std::isfinite(f)) continue;
    double s = -std::numeric_limits<double>::infinity();
    while (top >= 0) {
      const int v = line.vertex[static_cast<std::size_t>(top)];
      s = ((f + h2 * q * q) - (line.in[static_cast<std::size_t>(v)] + h2 * v * v)) / (2.0 * h2 * (q - v));
      if (s > line.bound[static_cast<std::size_t>(top)]) break;
      --top;
      s = -std::numeric_limits<double>::infinity();
    }
    ++top;
    line.vertex[static_cast<std::size_t>(top)] = q;
    line.bound[static_cast<std::size_t>(top)] = s;
  }
  if (top < 0) {
    std::fill(line.out.begin(), line.out.begin() + length, kFar);
    return;
  }
  int k = 0;
  for (int p = 0; p < length; ++p) {
    while (k < top && line.bound[static_cast<std::size_t>(k) + 1] < p) ++k;
    const int v = line.vertex[static_cast<std::size_t>(k)];
    const auto square = static_cast<float>(line.in[static_cast<std::size_t>(v)] + h2 * (p - v) * (p - v));
    line.out[static_cast<std::size_t>(p)] = square <= cap ? square : kFar;
  }
}

/// The first pass, along i, from a mask: to the nearest voxel that is `wanted` in each row, there and back.
std::vector<float> squared_distance_in_rows(const Mask& mask, std::uint8_t wanted, float cap) {
  const int length = mask.size.x();
  const double h2 = mask.spacing_mm.x() * mask.spacing_mm.x();
  std::vector<float> field(mask.voxels.size());
  const auto row = [&](std::size_t start) {
    const std::uint8_t* in = mask.voxels.data() + start;
    float* out = field.data() + start;
    int nearest = -1;
    for (int p = 0; p < length; ++p) {
      if ((in[p] != 0) == (wanted != 0)) nearest = p;
      out[p] = nearest < 0 ? kFar : static_cast<float>(h2 * (p - nearest) * (p - nearest));
    }
    nearest = -1;
    for (int p = length - 1; p >= 0; --p) {
      if (out[p] == 0.0F) nearest = p;
      if (nearest >= 0) out[p] = std::min(out[p], static_cast<float>(h2 * (nearest - p) * (nearest - p)));
      if (out[p] > cap) out[p] = kFar;
    }
  };
  const auto step = static_cast<std::size_t>(std::max(1, length));
  share_out_runs(field.size() / step, least_run(step), [&](std::size_t first, std::size_t end) {
    for (std::size_t n = first; n < end; ++n) row(n * step);
  });
  return field;
}

/// One pass along j or k. Sixteen neighbouring lines are taken at a time, so that memory is read in runs.
void transform_axis(std::vector<float>& field, const Eigen::Vector3i& size, int axis, double h, float cap) {
  constexpr int kLines = 16;
  const std::size_t row = static_cast<std::size_t>(size.x());
  const std::size_t slice = row * static_cast<std::size_t>(size.y());
  const std::size_t stride = axis == 1 ? row : slice, apart = axis == 1 ? slice : row;
  const int length = size[axis];
  const auto lines_of = [&](std::size_t other, std::vector<Line>& lines) {
    for (int first = 0; first < size.x(); first += kLines) {
      const int count = std::min(kLines, size.x() - first);
      float* const start = field.data() + static_cast<std::size_t>(first) + other * apart;
      const auto all_are = [&](float value) {
        bool same = true;
        for (int p = 0; p < length && same; ++p) {
          const float* run = start + static_cast<std::size_t>(p) * stride;
          for (int n = 0; n < count; ++n) same &= run[n] == value;
        }
        return same;
      };
      if (all_are(0.0F) || all_are(kFar)) continue;
      std::array<float*, kLines> in{}, out{};
      for (std::size_t n = 0; n < lines.size(); ++n) in[n] = lines[n].in.data(), out[n] = lines[n].out.data();
      for (int p = 0; p < length; ++p) {
        const float* run = start + static_cast<std::size_t>(p) * stride;
        for (int n = 0; n < count; ++n) in[static_cast<std::size_t>(n)][p] = run[n];
      }
      for (int n = 0; n < count; ++n) transform_line(lines[static_cast<std::size_t>(n)], length, h, cap);
      for (int p = 0; p < length; ++p) {
        float* run = start + static_cast<std::size_t>(p) * stride;
        for (int n = 0; n < count; ++n) run[n] = out[static_cast<std::size_t>(n)][p];
      }
    }
  };
  share_out_runs(static_cast<std::size_t>(size[3 - axis]), least_run(row * static_cast<std::size_t>(length)),
                 [&](std::size_t from, std::size_t end) {
                   std::vector<Line> lines(kLines, Line(length));
                   for (std::size_t other = from; other < end; ++other) lines_of(other, lines);
                 });
}

/// @param cap what is farther (mm^2) is infinitely far: there is less to be done.
std::vector<float> squared_distance_to(const Mask& mask, std::uint8_t wanted, float cap) {
  std::vector<float> field = squared_distance_in_rows(mask, wanted, cap);
  for (const int axis : {1, 2}) transform_axis(field, mask.size, axis, mask.spacing_mm[axis], cap);
  return field;
}

/// Where in the mask's box and `margin_mm` around it something `wanted` lies within the radius, or where not
/// (`within` false). Not set elsewhere.
Mask judged_near(const Mask& mask, double margin_mm, std::uint8_t wanted, double radius_mm, bool within) {
  // A distance of the radius does not exceed it by rounding.
  const auto limit = static_cast<float>(radius_mm * radius_mm * (1.0 + 1e-6));
  Mask result(mask.size, mask.spacing_mm);
  const VoxelBox box = bounding_box(mask.size, mask.spacing_mm, mask.voxels, margin_mm);
  if (box.empty()) return result;
  Mask part = crop(mask.size, mask.spacing_mm, mask.voxels, box);
  const std::vector<float> distance = squared_distance_to(part, wanted, limit);
  std::transform(distance.begin(), distance.end(), part.voxels.begin(),
                 [&](float d) { return (d <= limit) == within ? std::uint8_t{1} : std::uint8_t{0}; });
  paste(part, box, mask.size, result.voxels);
  return result;
}

/// Floods from `seed` through faces over voxels that satisfy `open`, and calls take(offset) once for each.
template <class Open, class Take>
void flood(const Eigen::Vector3i& size, std::size_t seed, std::vector<std::size_t>& stack, Open&& open,
           Take&& take) {
  stack.assign(1, seed);
  take(seed);
  const auto visit = [&](std::size_t at, int) {
    if (!open(at)) return;
    take(at);
    stack.push_back(at);
  };
  while (!stack.empty()) {
    const std::size_t at = stack.back();
    stack.pop_back();
    each_face_neighbour(size, at, visit);
  }
}

/// Fills the holes of one slice (nu x nv voxels, `su` and `sv` apart) into `filled`.
void fill_slice(const std::vector<std::uint8_t>& voxels, std::vector<std::uint8_t>& filled, std::size_t start,
                int nu, int nv, std::size_t su, std::size_t sv) {
  std::vector<std::uint8_t> outside(static_cast<std::size_t>(nu) * static_cast<std::size_t>(nv), 0);
  std::vector<std::pair<int, int>> stack;
  const auto at = [&](int u, int v) {
    return start + static_cast<std::size_t>(u) * su + static_cast<std::size_t>(v) * sv;
  };
  const auto visit = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= nu || v >= nv) return;
    std::uint8_t& seen =
        outside[static_cast<std::size_t>(u) + static_cast<std::size_t>(nu) * static_cast<std::size_t>(v)];
    if (seen != 0 || voxels[at(u, v)] != 0) return;
    seen = 1;
    stack.emplace_back(u, v);
  };
  for (int u = 0; u < nu; ++u) visit(u, 0), visit(u, nv - 1);
  for (int v = 0; v < nv; ++v) visit(0, v), visit(nu - 1, v);
  while (!stack.empty()) {
    const auto [u, v] = stack.back();
    stack.pop_back();
    visit(u - 1, v), visit(u + 1, v), visit(u, v - 1), visit(u, v + 1);
  }
  for (int v = 0; v < nv; ++v)
    for (int u = 0; u < nu; ++u)
      if (outside[static_cast<std::size_t>(u) + static_cast<std::size_t>(nu) * static_cast<std::size_t>(v)] ==
          0)
        filled[at(u, v)] = 1;
}

}  // namespace

long Mask::count() const {
  return std::count_if(voxels.begin(), voxels.end(), [](std::uint8_t v) { return v != 0; });
}

VoxelBox bounding_box(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm,
                      const std::vector<std::uint8_t>& voxels, double margin_mm) {
  VoxelBox box{size, Eigen::Vector3i::Zero()};
  std::size_t at = 0;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i, ++at)
        if (voxels[at] != 0) {
          box.low = box.low.cwiseMin(Eigen::Vector3i(i, j, k));
          box.high = box.high.cwiseMax(Eigen::Vector3i(i + 1, j + 1, k + 1));
        }
  if (box.empty()) return {};
  for (int axis = 0; axis < 3; ++axis) {
    const int margin = static_cast<int>(std::ceil(margin_mm / spacing_mm[axis]));
    box.low[axis] = std::max(0, box.low[axis] - margin);
    box.high[axis] = std::min(size[axis], box.high[axis] + margin);
  }
  return box;
}

Mask crop(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm,
          const std::vector<std::uint8_t>& voxels, const VoxelBox& box) {
  require(!box.empty() && (box.low.array() >= 0).all() && (box.high.array() <= size.array()).all(),
          "a crop lies inside its volume");
  Mask part(box.size(), spacing_mm);
  Mask whole;
  whole.size = size;  // only for its offset()
  for (int k = 0; k < part.size.z(); ++k)
    for (int j = 0; j < part.size.y(); ++j) {
      const auto from = voxels.begin() + static_cast<std::ptrdiff_t>(
                                             whole.offset(box.low.x(), j + box.low.y(), k + box.low.z()));
      std::copy(from, from + part.size.x(),
                part.voxels.begin() + static_cast<std::ptrdiff_t>(part.offset(0, j, k)));
    }
  return part;
}

void paste(const Mask& part, const VoxelBox& box, const Eigen::Vector3i& size,
           std::vector<std::uint8_t>& voxels) {
  require(part.size == box.size(), "a crop is pasted into the box that it came from");
  Mask whole;
  whole.size = size;  // only for its offset()
  for (int k = 0; k < part.size.z(); ++k)
    for (int j = 0; j < part.size.y(); ++j) {
      const auto from = part.voxels.begin() + static_cast<std::ptrdiff_t>(part.offset(0, j, k));
      std::copy(from, from + part.size.x(),
                voxels.begin() +
                    static_cast<std::ptrdiff_t>(whole.offset(box.low.x(), j + box.low.y(), k + box.low.z())));
    }
}

std::vector<float> squared_distance_mm2(const Mask& mask) { return squared_distance_to(mask, 1, kFar); }

std::vector<float> squared_depth_mm2(const Mask& mask) { return squared_distance_mm2(complement(mask)); }

Mask complement(Mask mask) {
  for (std::uint8_t& voxel : mask.voxels) voxel = voxel == 0 ? 1 : 0;
  return mask;
}

Mask dilated(const Mask& mask, double radius_mm) { return judged_near(mask, radius_mm, 1, radius_mm, true); }

Mask eroded(const Mask& mask, double radius_mm) {
  // One voxel beside the mask is as good as all that lie beyond it.
  return judged_near(mask, mask.spacing_mm.maxCoeff(), 0, radius_mm, false);
}

Mask opened(const Mask& mask, double radius_mm) { return dilated(eroded(mask, radius_mm), radius_mm); }

Mask closed(const Mask& mask, double radius_mm) {
  const VoxelBox box = bounding_box(mask.size, mask.spacing_mm, mask.voxels, 0.0);
  if (box.empty()) return mask;
  // Room on all sides: a dilation that the volume's edge cuts off would not be eroded from there.
  Eigen::Vector3i room;
  for (int axis = 0; axis < 3; ++axis)
    room[axis] = static_cast<int>(std::ceil(radius_mm / mask.spacing_mm[axis])) + 2;
  const VoxelBox inside{room, room + box.size()};
  Mask part(box.size() + 2 * room, mask.spacing_mm);
  paste(crop(mask.size, mask.spacing_mm, mask.voxels, box), inside, part.size, part.voxels);
  part = eroded(dilated(part, radius_mm), radius_mm);
  // A closing stays within the box of what it closes.
  Mask result(mask.size, mask.spacing_mm);
  paste(crop(part.size, part.spacing_mm, part.voxels, inside), box, result.size, result.voxels);
  return result;
}

std::vector<int> connected_components(const Mask& mask, std::vector<long>& sizes) {
  std::vector<int> number(mask.voxels.size(), 0);
  std::vector<std::size_t> stack;
  sizes.clear();
  for (std::size_t seed = 0; seed < number.size(); ++seed) {
    if (mask.voxels[seed] == 0 || number[seed] != 0) continue;
    const int current = static_cast<int>(sizes.size()) + 1;
    sizes.push_back(0);
    flood(
        mask.size, seed, stack, [&](std::size_t at) { return mask.voxels[at] != 0 && number[at] == 0; },
        [&](std::size_t at) {
          number[at] = current;
          ++sizes.back();
        });
  }
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  std::vector<int> rank(sizes.size() + 1, 0);
  std::vector<long> sorted(sizes.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    rank[static_cast<std::size_t>(order[r]) + 1] = static_cast<int>(r) + 1;
    sorted[r] = sizes[static_cast<std::size_t>(order[r])];
  }
  for (int& n : number) n = rank[static_cast<std::size_t>(n)];
  sizes = std::move(sorted);
  return number;
}

Mask largest_component(const Mask& mask) {
  std::vector<long> sizes;
  const std::vector<int> number = connected_components(mask, sizes);
  Mask result(mask.size, mask.spacing_mm);
  std::transform(number.begin(), number.end(), result.voxels.begin(), [](int n) { return n == 1 ? 1 : 0; });
  return result;
}

Mask holes_filled(const Mask& mask) {
  std::vector<std::uint8_t> outside(mask.voxels.size(), 0);
  std::vector<std::size_t> stack;
  const auto open = [&](std::size_t at) { return mask.voxels[at] == 0 && outside[at] == 0; };
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j) {
      const bool edge = k == 0 || j == 0 || k + 1 == mask.size.z() || j + 1 == mask.size.y();
      for (int i = 0; i < mask.size.x(); i += edge ? 1 : std::max(1, mask.size.x() - 1)) {
        const std::size_t at = mask.offset(i, j, k);
        if (open(at)) flood(mask.size, at, stack, open, [&](std::size_t v) { outside[v] = 1; });
      }
    }
  Mask result(mask.size, mask.spacing_mm);
  std::transform(outside.begin(), outside.end(), result.voxels.begin(),
                 [](std::uint8_t v) { return v == 0 ? 1 : 0; });
  return result;
}

Mask slice_holes_filled(const Mask& mask) {
  Mask result = mask;
  const std::size_t sx = 1, sy = static_cast<std::size_t>(mask.size.x()),
                    sz = sy * static_cast<std::size_t>(mask.size.y());
  const auto each_slice = [&](int count, std::size_t least, const auto& fill) {
    const auto slices = static_cast<std::size_t>(count);
    share_out_runs(slices, std::max(least, least_run(mask.voxels.size() / std::max(std::size_t{1}, slices))),
                   [&](std::size_t first, std::size_t end) {
                     for (std::size_t n = first; n < end; ++n) fill(n);
                   });
  };
  each_slice(mask.size.z(), 1, [&](std::size_t k) {
    fill_slice(mask.voxels, result.voxels, k * sz, mask.size.x(), mask.size.y(), sx, sy);
  });
  each_slice(mask.size.y(), 1, [&](std::size_t j) {
    fill_slice(mask.voxels, result.voxels, j * sy, mask.size.x(), mask.size.z(), sx, sz);
  });
  // Two threads that write beside each other in memory wait for one another: each has a line of cache at
  // least.
  each_slice(mask.size.x(), 64, [&](std::size_t i) {
    fill_slice(mask.voxels, result.voxels, i * sx, mask.size.y(), mask.size.z(), sy, sz);
  });
  return result;
}

}  // namespace glisson
