// SPDX-License-Identifier: GPL-3.0-or-later
// How a person mends vessels by hand: looks where the labels are most wrong, and draws over it in a slice.
#include <algorithm>
#include <cmath>
#include <queue>

#include "glisson/core/error.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/insilico/operator.h"
#include "glisson/volume/morphology.h"
#include "operator_hand.h"

namespace glisson::insilico {
namespace {

using Voxel = Eigen::Vector3i;

constexpr double kThinnestMm = 1.0, kThickestMm = 8.0;  // brushes that a person would take
constexpr std::size_t kLookedAt = 12;                   // places of each kind that are thought about
constexpr double kStepMm = 2.0;                         // between two places of the pointer
constexpr std::size_t kFewestPixels = 6;

/// The liver's surroundings: what is there, and what should be.
struct Sheet {
  VolumeGrid grid;
  Voxel low = Voxel::Zero(), size = Voxel::Zero();
  std::vector<Label> now, truth;

  std::size_t at(const Voxel& v) const {
    return static_cast<std::size_t>(v.x()) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(v.y()) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(v.z()));
  }
  bool holds(const Voxel& v) const { return (v.array() >= 0).all() && (v.array() < size.array()).all(); }
};

Sheet sheet_of(const LabelMap& labels, const LabelMap& truth) {
  Sheet sheet;
  sheet.grid = truth.voxels.grid();
  const VoxelBox box = bounding_box(sheet.grid.size, sheet.grid.spacing_mm, inside_liver(truth), 3.0);
  if (box.empty())
    throw InputError("labels", "parenchyma", "there is no liver", "Give the truth of a patient");
  sheet.low = box.low;
  sheet.size = box.size();
  for (int k = 0; k < sheet.size.z(); ++k)
    for (int j = 0; j < sheet.size.y(); ++j)
      for (int i = 0; i < sheet.size.x(); ++i) {
        sheet.now.push_back(labels.voxels.at(sheet.low + Voxel(i, j, k)));
        sheet.truth.push_back(truth.voxels.at(sheet.low + Voxel(i, j, k)));
      }
  return sheet;
}

/// One kind of mistake: voxels of `label` that are missing, or are there and should not be.
struct Mistake {
  Label label;
  bool missing;
  bool is(Label now, Label truth) const {
    return missing ? truth == label && now != label : now == label && truth != label;
  }
  /// By how many voxels a brush over this one mends the labels: 1, 0 or -1.
  int worth(Label now, Label truth) const {
    if (is(now, truth)) return 1;
    if (missing) return now == truth && now != label ? -1 : 0;
    return now == label ? -1 : 0;  // the brush takes this label only
  }
  Label painted() const { return missing ? label : structure::kParenchyma; }
};

struct Stroke {
  Mistake mistake{};
  int axis = 2;
  std::vector<Voxel> path;
  double radius_mm = 0.0;
  long worth = 0;
};

/// The pixels of a slice that hang together (through corners, too), one list each.
std::vector<std::vector<Voxel>> pieces(const std::vector<Voxel>& pixels, int axis, const Sheet& sheet,
                                       std::vector<int>& scratch) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto place = [&](const Voxel& p) { return static_cast<std::size_t>(p[u] + sheet.size[u] * p[v]); };
  for (std::size_t n = 0; n < pixels.size(); ++n) scratch[place(pixels[n])] = static_cast<int>(n) + 1;
  std::vector<std::vector<Voxel>> found;
  for (const Voxel& pixel : pixels) {
    if (scratch[place(pixel)] == 0) continue;
    std::vector<Voxel> piece{pixel};
    scratch[place(pixel)] = 0;
    for (std::size_t n = 0; n < piece.size(); ++n)
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) {
          Voxel next = piece[n];
          next[u] += du;
          next[v] += dv;
          if (!sheet.holds(next) || scratch[place(next)] == 0) continue;
          scratch[place(next)] = 0;
          piece.push_back(next);
        }
    found.push_back(std::move(piece));
  }
  return found;
}

/// The way along a piece from one of its ends to the other.
std::vector<Voxel> longest_way(const std::vector<Voxel>& piece, int axis, const Sheet& sheet) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto key = [&](const Voxel& p) { return p[u] + sheet.size[u] * p[v]; };
  std::vector<std::pair<int, std::size_t>> book;
  for (std::size_t n = 0; n < piece.size(); ++n) book.emplace_back(key(piece[n]), n);
  std::sort(book.begin(), book.end());
  const auto find = [&](const Voxel& p) -> int {
    const auto entry = std::lower_bound(book.begin(), book.end(), std::pair(key(p), std::size_t{0}));
    return entry != book.end() && entry->first == key(p) ? static_cast<int>(entry->second) : -1;
  };
  std::vector<int> from(piece.size());
  const auto farthest = [&](std::size_t start) {
    std::vector<double> far(piece.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    far[start] = 0.0;
    from[start] = -1;
    queue.emplace(0.0, start);
    std::size_t last = start;
    while (!queue.empty()) {
      const auto [way, n] = queue.top();
      queue.pop();
      if (way > far[n]) continue;
      last = n;
      for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du) {
          Voxel next = piece[n];
          next[u] += du;
          next[v] += dv;
          if ((du == 0 && dv == 0) || !sheet.holds(next)) continue;
          const int m = find(next);
          if (m < 0) continue;
          const double length =
              way + (next - piece[n]).cast<double>().cwiseProduct(sheet.grid.spacing_mm).norm();
          if (length >= far[static_cast<std::size_t>(m)]) continue;
          far[static_cast<std::size_t>(m)] = length;
          from[static_cast<std::size_t>(m)] = static_cast<int>(n);
          queue.emplace(length, static_cast<std::size_t>(m));
        }
    }
    return last;
  };
  std::vector<Voxel> way;
  for (int n = static_cast<int>(farthest(farthest(0))); n >= 0; n = from[static_cast<std::size_t>(n)])
    way.push_back(piece[static_cast<std::size_t>(n)]);
  return way;
}

/// Calls visit(place) once for each voxel under a ball drawn along a path.
template <class Visit>
void under_the_brush(const Sheet& sheet, const std::vector<Voxel>& path, double radius_mm, Visit&& visit) {
  const Voxel reach = (radius_mm * sheet.grid.spacing_mm.cwiseInverse()).cast<int>() + Voxel::Ones();
  std::vector<std::size_t> places;
  for (const Voxel& centre : path)
    for (int k = -reach.z(); k <= reach.z(); ++k)
      for (int j = -reach.y(); j <= reach.y(); ++j)
        for (int i = -reach.x(); i <= reach.x(); ++i) {
          const Voxel v = centre + Voxel(i, j, k);
          if (sheet.holds(v) &&
              Voxel(i, j, k).cast<double>().cwiseProduct(sheet.grid.spacing_mm).norm() <= radius_mm)
            places.push_back(sheet.at(v));
        }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (const std::size_t place : places) visit(place);
}

double length_mm(const std::vector<Voxel>& path, const Eigen::Vector3d& spacing_mm) {
  double length = 0.0;
  for (std::size_t n = 1; n < path.size(); ++n)
    length += (path[n] - path[n - 1]).cast<double>().cwiseProduct(spacing_mm).norm();
  return length;
}

/// The best brush along a piece.
Stroke thought_out(const Sheet& sheet, const Mistake& mistake, int axis, const std::vector<Voxel>& piece) {
  const Eigen::Vector3d& spacing = sheet.grid.spacing_mm;
  Stroke best{mistake, axis, longest_way(piece, axis, sheet), 0.0, 0};
  const double pixel_mm2 = spacing.prod() / spacing[axis];
  const double half_width = 0.5 * pixel_mm2 * static_cast<double>(piece.size()) /
                            (length_mm(best.path, spacing) + std::sqrt(pixel_mm2));
  for (const double factor : {0.8, 1.1, 1.5}) {
    const double radius = std::clamp(factor * half_width, kThinnestMm, kThickestMm);
    long worth = 0;
    under_the_brush(sheet, best.path, radius,
                    [&](std::size_t n) { worth += mistake.worth(sheet.now[n], sheet.truth[n]); });
    if (worth > best.worth) best.worth = worth, best.radius_mm = radius;
  }
  return best;
}

/// The stroke that mends most; worth 0: nothing is left to mend.
Stroke best_stroke(const Sheet& sheet) {
  Stroke best;
  for (const Label label : {structure::kPortalVein, structure::kHepaticVeins})
    for (const bool missing : {true, false}) {
      const Mistake mistake{label, missing};
      std::vector<Voxel> wrong;
      for (int k = 0; k < sheet.size.z(); ++k)
        for (int j = 0; j < sheet.size.y(); ++j)
          for (int i = 0; i < sheet.size.x(); ++i) {
            const std::size_t n = sheet.at({i, j, k});
            if (mistake.is(sheet.now[n], sheet.truth[n])) wrong.emplace_back(i, j, k);
          }
      std::vector<std::pair<int, std::vector<Voxel>>> found;  // axis, piece
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::vector<Voxel>> slices(static_cast<std::size_t>(sheet.size[axis]));
        for (const Voxel& v : wrong) slices[static_cast<std::size_t>(v[axis])].push_back(v);
        std::vector<int> scratch(static_cast<std::size_t>(sheet.size[(axis + 1) % 3]) *
                                 static_cast<std::size_t>(sheet.size[(axis + 2) % 3]));
        for (const auto& slice : slices)
          for (auto& piece : pieces(slice, axis, sheet, scratch))
            if (piece.size() >= kFewestPixels) found.emplace_back(axis, std::move(piece));
      }
      const auto area = [&](const auto& entry) {
        return static_cast<double>(entry.second.size()) / sheet.grid.spacing_mm[entry.first];
      };
      std::stable_sort(found.begin(), found.end(),
                       [&](const auto& a, const auto& b) { return area(a) > area(b); });
      found.resize(std::min(found.size(), kLookedAt));
      for (const auto& [axis, piece] : found)
        if (Stroke stroke = thought_out(sheet, mistake, axis, piece); stroke.worth > best.worth)
          best = std::move(stroke);
    }
  return best;
}

editing::Edit drawn(const Sheet& sheet, const Stroke& stroke, double tremor_mm, Hand& hand) {
  editing::Paint paint;
  paint.label = stroke.mistake.painted();
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 1e-3 * stroke.radius_mm;
  paint.normal_axis = stroke.axis;
  std::vector<Eigen::Vector3d> places;
  for (const Voxel& v : stroke.path) {
    const Eigen::Vector3d p = sheet.grid.p_in_ct((sheet.low + v).cast<double>()).xyz;
    if (places.empty() || (p - places.back()).norm() > 1e-3 * kStepMm || &v == &stroke.path.back())
      places.push_back(p);
  }
  paint.path.resize(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t n = 0; n < places.size(); ++n)
    paint.path.row(static_cast<Eigen::Index>(n)) =
        (places[n] + 1e-3 * tremor_mm * hand.tremor3()).transpose();
  editing::EditableRegion region;
  if (!stroke.mistake.missing) {
    region.area = editing::EditableRegion::Area::inside_label;
    region.label = stroke.mistake.label;
  }
  return {paint, region};
}

}  // namespace

std::vector<editing::Edit> draw_vessel_strokes(const LabelMap& labels, const LabelMap& truth, int count,
                                               const OperatorOptions& options) {
  options.validate();
  require(count >= 0, "a number of strokes is not negative");
  require(labels.voxels.grid().same_as(truth.voxels.grid()), "labels and their truth have one grid");
  Sheet sheet = sheet_of(labels, truth);
  Hand hand(options.seed + 3);
  std::vector<editing::Edit> edits;
  while (static_cast<int>(edits.size()) < count) {
    const Stroke stroke = best_stroke(sheet);
    if (stroke.worth == 0) break;
    // A hand that follows an edge on the screen trembles less than one that points into the dark.
    edits.push_back(drawn(sheet, stroke, options.click_noise_mm / 3.0, hand));
    under_the_brush(sheet, stroke.path, stroke.radius_mm, [&](std::size_t n) {
      if (stroke.mistake.missing || sheet.now[n] == stroke.mistake.label)
        sheet.now[n] = stroke.mistake.painted();
    });
  }
  return edits;
}

}  // namespace glisson::insilico
