// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/register_again.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/refusal.h"

namespace glisson::registration {
namespace {

constexpr Eigen::Index kLeastTissue = 30;
constexpr double kCube = 15e-3;  ///< metres
constexpr std::uint64_t kEvery = 5;
/// Fewest cubes that can decide; and the standard deviations of their mean beyond which it is not chance.
constexpr double kLeastCubes = 5.0, kDeviations = 2.0;
/// Metres along the ray: the error that remains when tissue was looked at many times, since all looks share
/// it.
constexpr double kTissueSigma = 1.2e-3;

/// A number for the cube around a place, mixed so that which cubes are left out follows no pattern in space.
std::uint64_t cube_of(const Eigen::Vector3d& p) {
  std::uint64_t mixed = 0x9e3779b97f4a7c15ULL;
  for (int k = 0; k < 3; ++k) {
    mixed ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[k] / kCube)));
    mixed *= 0xbf58476d1ce4e5b9ULL;
    mixed ^= mixed >> 29;
  }
  return mixed;
}
bool is_kept_out(const Eigen::Vector3d& p) { return cube_of(p) % kEvery == 0; }

struct Parted {
  LabelledCloud fitted;
  Points kept_out;
};

Parted part(const LabelledCloud& cloud, const LabelledCloud& tissue) {
  std::vector<int> fitted, kept;
  for (int i = 0; i < tissue.size(); ++i)
    (is_kept_out(tissue.points.row(i).transpose()) ? kept : fitted).push_back(i);
  const auto before = static_cast<Eigen::Index>(cloud.size()),
             more = static_cast<Eigen::Index>(fitted.size());
  Parted parted;
  parted.fitted.points.resize(before + more, 3);
  parted.fitted.points.topRows(before) = cloud.points;
  parted.fitted.points.bottomRows(more) = tissue.points(fitted, Eigen::all);
  parted.fitted.seen_from.resize(before + more, 3);
  for (int i = 0; i < cloud.size(); ++i) parted.fitted.seen_from.row(i) = cloud.eye(i).transpose();
  for (Eigen::Index i = 0; i < more; ++i)
    parted.fitted.seen_from.row(before + i) = tissue.eye(fitted[static_cast<std::size_t>(i)]).transpose();
  const auto all = static_cast<std::size_t>(before + more);
  if (!cloud.features.empty()) {
    parted.fitted.features = cloud.features;
    parted.fitted.features.resize(all, Feature::surface);
  }
  if (!cloud.sigma.empty()) {
    parted.fitted.sigma = cloud.sigma;
    parted.fitted.sigma.resize(all, kTissueSigma);
  }
  parted.kept_out = tissue.points(kept, Eigen::all);
  return parted;
}

std::vector<double> gaps_from(MovingSurface& surface, const Points& nodes, const Points& places) {
  surface.move(nodes);
  std::vector<double> gaps;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    gaps.push_back(surface.closest(Feature::surface, places.row(i).transpose()).distance);
  return gaps;
}

/// Whether places lie nearer than before by more than chance. Counted by cubes: points of one cube share
/// errors.
bool is_nearer(const Points& places, const std::vector<double>& before, const std::vector<double>& after) {
  std::map<std::uint64_t, std::pair<double, int>> cubes;
  for (std::size_t i = 0; i < before.size(); ++i) {
    auto& [sum, count] = cubes[cube_of(places.row(static_cast<Eigen::Index>(i)).transpose())];
    sum += before[i] - after[i];
    ++count;
  }
  const auto n = static_cast<double>(cubes.size());
  if (n < kLeastCubes) return false;
  double mean = 0.0, squares = 0.0;
  for (const auto& [key, cube] : cubes) mean += cube.first / cube.second / n;
  for (const auto& [key, cube] : cubes) squares += std::pow(cube.first / cube.second - mean, 2);
  return mean > kDeviations * std::sqrt(squares / (n - 1.0) / n);
}

/// Codes without their values.
std::string_view code_of(std::string_view doubt) { return doubt.substr(0, doubt.find(' ')); }

bool has_new_doubt(const Registration& now, const Registration& former) {
  return std::any_of(now.doubts.begin(), now.doubts.end(), [&](const std::string& doubt) {
    return std::none_of(former.doubts.begin(), former.doubts.end(),
                        [&](const std::string& old) { return code_of(old) == code_of(doubt); });
  });
}

void check(const PatientModel& model, const LabelledCloud& tissue, const Registration& former) {
  if (former.nodes_in_camera.rows() != model.mesh.vertex_count() || !former.nodes_in_camera.allFinite())
    throw InputError("registration", "the former one", "is not of this model", "Register from the start");
  if (tissue.size() < kLeastTissue)
    throw InputError("registration", "tissue",
                     "has been seen at " + std::to_string(tissue.size()) + " places only, where " +
                         std::to_string(kLeastTissue) + " are needed",
                     "Follow the organ for a second and show more of it");
}

}  // namespace

Cancellable<RegisteredAgain> register_again(const PatientModel& model, const LabelledCloud& cloud,
                                            const LabelledCloud& tissue, const Registration& former,
                                            RegisterOptions options, const RunContext& context,
                                            const KnownOperations& known) {
  check(model, tissue, former);
  const Parted parted = part(cloud, tissue);
  options.start = options.fixed_nodes.empty() ? RegisterOptions::Start::near : RegisterOptions::Start::given;
  options.given = former.camera_from_ct;
  auto examined = register_model(model, parted.fitted, options, context, known);
  if (!examined) return {};
  RegisteredAgain again{std::move(*examined)};
  const Registration& now = again.examined.registered.registration;
  again.moved = (now.nodes_in_camera - former.nodes_in_camera).rowwise().norm().mean();
  again.kept_out = static_cast<int>(parted.kept_out.rows());
  if (again.kept_out > 0) {
    MovingSurface surface(model, SurfaceDetail::fine);
    const std::vector<double> before = gaps_from(surface, former.nodes_in_camera, parted.kept_out),
                              after = gaps_from(surface, now.nodes_in_camera, parted.kept_out);
    again.former_gap = upper_median(before);
    again.gap = upper_median(after);
    again.is_better =
        !is_refused(now) && !has_new_doubt(now, former) && is_nearer(parted.kept_out, before, after);
  }
  return again;
}

}  // namespace glisson::registration
