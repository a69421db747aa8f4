// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_looks.h"

#include <algorithm>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/core/statistics.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/refusal.h"

namespace glisson::experiments {
namespace {

constexpr double kShare = 0.2;           ///< of the surface that is seen at first
constexpr double kNoise = 1e-3;          ///< m, a coordinate
constexpr double kOffered = 1.0 - 1e-6;  ///< of the present error: a place that is offered leaves less

/// What a look at a node of the model would add, where the handling has carried the surface.
LabelledCloud with_look(const RegistrationStage& stage, std::size_t handling, const LabelledCloud& seen,
                        int node, std::uint64_t seed) {
  TriangleMesh surface = stage.model.surface.mesh;
  surface.vertices = stage.by(handling).carry(surface.vertices);
  const std::vector<int>& nodes = stage.model.surface.node_of_vertex;
  const auto middle = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
  const Eigen::RowVector3d at = surface.vertices.row(middle), facing = vertex_normals(surface).row(middle);
  const Points normals = triangle_normals(surface);
  const Eigen::VectorXd areas = triangle_areas(surface);
  const double per_m2 = 1e4 * insilico::PatchOptions().density_per_cm2;  // as the cloud's
  std::mt19937_64 random(seed);
  std::vector<Eigen::RowVector3d> points;
  for (Eigen::Index t = 0; t < areas.size(); ++t) {
    if (normals.row(t).dot(facing) < registration::kLookFacing) continue;
    for (double left = areas[t] * per_m2 - uniform01(random); left > 0.0; left -= 1.0) {
      double a = uniform01(random), b = uniform01(random);
      if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
      const Eigen::RowVector3d p = (1.0 - a - b) * surface.vertices.row(surface.triangles(t, 0)) +
                                   a * surface.vertices.row(surface.triangles(t, 1)) +
                                   b * surface.vertices.row(surface.triangles(t, 2));
      if ((p - at).norm() > registration::kLookReach) continue;
      const double x = standard_normal(random), y = standard_normal(random), z = standard_normal(random);
      points.push_back(p + kNoise * Eigen::RowVector3d(x, y, z));
    }
  }
  LabelledCloud more = seen;
  more.points.conservativeResize(seen.points.rows() + static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    more.points.row(seen.points.rows() + static_cast<Eigen::Index>(i)) = points[i];
    if (!more.features.empty()) more.features.push_back(Feature::surface);
    if (!more.sigma.empty()) more.sigma.push_back(kNoise);
  }
  return more;
}

/// Nobody is misled where there is no result: refused, or it failed.
std::optional<Registration> registered(StageRegistrar& registrar, const LabelledCloud& cloud) {
  try {
    auto examined = registrar.run(cloud);
    if (!examined || registration::is_refused(examined->registered.registration)) return {};
    return std::move(examined->registered.registration);
  } catch (const Error&) {
    return {};
  }
}

/// Of the stage's lesions the one that is known least, by number; none: the registration tells of none.
std::optional<Eigen::Index> least_known(const RegistrationStage& stage, const Registration& made,
                                        const LesionLooks*& told) {
  std::optional<Eigen::Index> least;
  for (const LesionLooks& looks : made.looks)
    for (Eigen::Index k = 0; k < stage.lesions.rows(); ++k)
      if (looks.lesion == RegistrationStage::lesion_label(k) && (!least || looks.now > told->now))
        least = k, told = &looks;
  return least;
}

/// Any other place that is offered.
int another_place(const LesionLooks& looks, int best, std::mt19937_64& random) {
  std::vector<int> offered;
  for (Eigen::Index i = 0; i < looks.seen.size(); ++i)
    if (i != best && looks.seen[i] < kOffered * looks.now) offered.push_back(static_cast<int>(i));
  return offered.empty() ? best : offered[static_cast<std::size_t>(random() % offered.size())];
}

}  // namespace

std::vector<LookTrial> try_looks(const RegistrationStage& stage, std::size_t number,
                                 const RegistrationProofOptions& options, const RunContext& context) {
  std::vector<LookTrial> trials;
  StageRegistrar registrar(stage, context);
  const Binding lesions = bind_points(stage.model.mesh, stage.lesions, false);
  for (std::size_t handling = 0; handling < stage.handled.size(); ++handling) {
    const std::uint64_t seed = options.seed + 1000 * (number + 1) + 500 + handling;
    std::mt19937_64 random(seed);
    const LabelledCloud cloud = faulty_cloud(stage, stage, handling, kShare, RegistrationFault::none, seed);
    const auto made = registered(registrar, cloud);
    if (!made) continue;
    const LesionLooks* told = nullptr;
    const auto lesion = least_known(stage, *made, told);
    const auto best = lesion ? registration::best_look(*told) : std::nullopt;
    if (!best || best->kind != registration::NextLook::Kind::surface) continue;
    const auto shown = [&](int node) { return with_look(stage, handling, cloud, node, seed); };
    const auto there = registered(registrar, shown(best->node));
    const auto elsewhere = registered(registrar, shown(another_place(*told, best->node, random)));
    if (!there || !elsewhere) continue;
    const Eigen::RowVector3d truth = stage.by(handling).carry(stage.lesions).row(*lesion);
    const auto error_of = [&](const Registration& one) {
      return (lesions.apply(stage.model.mesh, one.nodes_in_camera).row(*lesion) - truth).norm();
    };
    trials.push_back({insilico::handling_code(insilico::kHandlings[handling]), best->now, best->after,
                      error_of(*made), error_of(*there), error_of(*elsewhere), made->doubts});
  }
  return trials;
}

void sum_up(const std::vector<LookTrial>& trials, const std::string& set, RegistrationProof& proof) {
  if (trials.empty()) return;
  const auto line = [&](const char* name, const LookTrial& trial) {
    char text[160];
    std::snprintf(text, sizeof text, "%-10s %9.1f %12.1f %9.1f %11.1f %14.1f", name, 1e3 * trial.expected,
                  1e3 * trial.promised, 1e3 * trial.error, 1e3 * trial.after, 1e3 * trial.after_other);
    proof.table.emplace_back(text);
    for (const std::string& doubt : trial.doubts)
      proof.table.back() += "  " + doubt.substr(0, doubt.find(' '));  // codes alone
  };
  proof.table.push_back(set + ", one more look, the least known lesion, mm");
  proof.table.emplace_back(
      "handled     expected  then expected  error  then error  a look elsewhere  doubts before");
  // A start that is lost altogether would drown all others in a mean.
  const auto middle = [&](double LookTrial::*value) {
    std::vector<double> values;
    values.reserve(trials.size());
    for (const LookTrial& trial : trials) values.push_back(trial.*value);
    return upper_median(std::move(values));
  };
  for (const LookTrial& trial : trials) line(trial.handling.c_str(), trial);
  const LookTrial all{"median",
                      middle(&LookTrial::expected),
                      middle(&LookTrial::promised),
                      middle(&LookTrial::error),
                      middle(&LookTrial::after),
                      middle(&LookTrial::after_other),
                      {}};
  line(all.handling.c_str(), all);
  const std::string prefix = "registration_" + set + "_looks_";
  proof.figures[prefix + "trials"] = static_cast<double>(trials.size());
  proof.figures[prefix + "expected_mm"] = 1e3 * all.expected;
  proof.figures[prefix + "promised_mm"] = 1e3 * all.promised;
  proof.figures[prefix + "error_mm"] = 1e3 * all.error;
  proof.figures[prefix + "after_mm"] = 1e3 * all.after;
  proof.figures[prefix + "after_other_mm"] = 1e3 * all.after_other;
}

}  // namespace glisson::experiments
