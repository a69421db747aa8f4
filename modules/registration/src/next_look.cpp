// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/next_look.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "farthest_first.h"
#include "force_rows.h"
#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

namespace glisson::registration {
namespace {

constexpr double kSpacing = 10e-3;     ///< m, of the places
constexpr double kBehind = 0.5;        ///< of the normal's component towards the patient's back
constexpr double kAroundCava = 25e-3;  ///< m
constexpr double kMarked = 10e-3;      ///< m: of the margin, this near to points that are marked
constexpr double kMarginPiece = 5e-3;  ///< m, as the cloud's reference spacing along the margin

/// Places that stand for the surface around them.
struct Places {
  Spread spread;             ///< over the boundary surface's vertices
  std::vector<double> area;  ///< m2 that each stands for

  explicit Places(const TriangleMesh& surface) : spread(farthest_first(surface.vertices, kSpacing)) {
    const Eigen::VectorXd areas = vertex_areas(surface);
    area.assign(spread.chosen.size(), 0.0);
    for (std::size_t v = 0; v < spread.nearest.size(); ++v)
      area[spread.nearest[v]] += areas[static_cast<Eigen::Index>(v)];
  }
};

/// Whether a laparoscope may come to see it.
bool is_offered(const PatientModel& model, const Eigen::RowVector3d& at, const Eigen::RowVector3d& normal) {
  if (normal.y() > kBehind) return false;  // LPS: y points to the back
  const Points& cava = model.landmarks.vena_cava;
  return cava.rows() == 0 || (cava.rowwise() - at).rowwise().norm().minCoeff() > kAroundCava;
}

/// Points of the model that carry numbers: `rows` gets one in each given direction.
void add_rows(ForceRows& rows, const Carrier& carrier, const Points& directions, double sigma) {
  const Eigen::Index first = rows.size(), count = directions.rows();
  rows.directions.conservativeResize(first + count, 3);
  rows.gap.conservativeResize(first + count);
  rows.sigma.conservativeResize(first + count);
  rows.directions.bottomRows(count) = directions;
  rows.gap.tail(count).setZero();
  rows.sigma.tail(count).setConstant(sigma);
  rows.carriers.insert(rows.carriers.end(), static_cast<std::size_t>(count), carrier);
}

/// What could be seen, as rows of the linear model.
struct Look {
  Eigen::MatrixXd answers;   ///< B, m x K
  Eigen::VectorXd variance;  ///< V
};

/// Of a point of these deviations (3 x K) once the look has been taken.
Eigen::Matrix3d covariance_after(const Eigen::MatrixXd& deviations, const Look& look) {
  Eigen::MatrixXd m = look.answers * look.answers.transpose();
  m.diagonal() += look.variance;
  const Eigen::MatrixXd across = deviations * look.answers.transpose();  // 3 x m
  return deviations * deviations.transpose() - across * m.llt().solve(across.transpose());
}

Look look_along(const ErrorModel& error, const ForceRows& rows) {
  return {error.answers(rows), rows.sigma.cwiseAbs2()};
}

/// Of an ordered line the points a piece apart, resampled evenly.
Points pieces_of(const Points& line) {
  std::vector<Eigen::RowVector3d> points;
  double left = 0.0;
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
    const Eigen::RowVector3d step = line.row(i + 1) - line.row(i);
    const double length = step.norm();
    for (; left < length; left += kMarginPiece) points.push_back(line.row(i) + left / length * step);
    left -= length;
  }
  Points all(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) all.row(static_cast<Eigen::Index>(i)) = points[i];
  return all;
}

/// What marking a landmark where the cloud shows it would tell; no rows where it is marked, or not seen.
class LandmarkLooks {
 public:
  LandmarkLooks(const PatientModel& model, const LabelledCloud& cloud, const Registration& registration)
      : model_(model), cloud_(cloud), seen_(cloud.points), registration_(registration) {}

  ForceRows margin() const {
    const Points pieces = pieces_of(model_.landmarks.anterior_margin);
    return rows_of(pieces, Feature::anterior_margin, kMarked, [&](Eigen::Index i) {
      return std::max(kMarginSigma, margin_deviation_at(model_.landmarks, pieces.row(i))) /
             std::sqrt(kMarginInformation);
    });
  }
  ForceRows notch() const {
    const Points& notch = model_.landmarks.umbilical_notch;
    return rows_of(notch.rows() > 0 ? Points(notch.colwise().mean()) : notch, Feature::umbilical_notch,
                   std::numeric_limits<double>::infinity(),
                   [this](Eigen::Index) { return std::max(kNotchSigma, model_.landmarks.notch_deviation); });
  }

 private:
  bool is_marked(const Eigen::RowVector3d& p, Feature feature, double reach) const {
    for (int i = 0; i < cloud_.size(); ++i)
      if (cloud_.feature(i) == feature && (cloud_.points.row(i) - p).norm() < reach) return true;
    return false;
  }

  /// @param sigma of a point of the landmark, by its number, metres.
  template <class Sigma>
  ForceRows rows_of(const Points& landmark, Feature feature, double marked, const Sigma& sigma) const {
    ForceRows rows;
    if (landmark.rows() == 0) return rows;
    const Binding binding = bind_points(model_.mesh, landmark, false);
    const Points now = binding.apply(model_.mesh, registration_.nodes_in_camera);
    for (Eigen::Index i = 0; i < now.rows(); ++i) {
      if (!seen_.is_seen(now.row(i)) || is_marked(now.row(i), feature, marked)) continue;
      Carrier carrier;
      const auto tetrahedron = model_.mesh.tetrahedra.row(binding.tetrahedron[static_cast<std::size_t>(i)]);
      for (int k = 0; k < 4; ++k) {
        carrier.nodes[static_cast<std::size_t>(k)] = tetrahedron[k];
        carrier.weights[static_cast<std::size_t>(k)] = binding.weights(i, k);
      }
      add_rows(rows, carrier, Eigen::Matrix3d::Identity(), sigma(i));
    }
    return rows;
  }

  const PatientModel& model_;
  const LabelledCloud& cloud_;
  const SeenPlaces seen_;
  const Registration& registration_;
};

/// A look at each place; without rows where none is offered. Only surface that is not seen yet gives rows:
/// what is uncertain where it is seen is the model's own error, which stays.
std::vector<Look> surface_looks(const PatientModel& model, const LabelledCloud& cloud,
                                const Registration& registration, const ErrorModel& error,
                                const Places& places, const RunContext& context) {
  const std::vector<int>& nodes = model.surface.node_of_vertex;
  TriangleMesh now = model.surface.mesh;
  for (Eigen::Index i = 0; i < now.vertices.rows(); ++i)
    now.vertices.row(i) = registration.nodes_in_camera.row(nodes[static_cast<std::size_t>(i)]);
  const Points normals = vertex_normals(now), normals_at_rest = vertex_normals(model.surface.mesh);
  const SeenPlaces seen(cloud.points);
  ForceRows all;
  std::vector<char> offered, is_new;
  for (std::size_t p = 0; p < places.spread.chosen.size(); ++p) {
    const Eigen::Index v = places.spread.chosen[p];
    Carrier carrier;
    carrier.nodes[0] = nodes[static_cast<std::size_t>(v)];
    carrier.weights[0] = 1.0;
    add_rows(all, carrier, normals.row(v), std::sqrt(error.variance_of_area(places.area[p])));
    offered.push_back(is_offered(model, model.surface.mesh.vertices.row(v), normals_at_rest.row(v)));
    is_new.push_back(offered.back() && !seen.is_seen(now.vertices.row(v)));
  }
  const Look everything = look_along(error, all);
  const auto is_shown = [&](Eigen::Index v, Eigen::Index middle) {
    return (now.vertices.row(v) - now.vertices.row(middle)).norm() < kLookReach &&
           normals.row(v).dot(normals.row(middle)) > kLookFacing;
  };
  std::vector<Look> looks(places.spread.chosen.size());
  for (std::size_t p = 0; p < looks.size(); ++p) {
    if (!offered[p] || context.cancelled()) continue;
    std::vector<Eigen::Index> shown;
    for (std::size_t q = 0; q < looks.size(); ++q)
      if (is_new[q] && is_shown(places.spread.chosen[q], places.spread.chosen[p]))
        shown.push_back(static_cast<Eigen::Index>(q));
    looks[p] = {everything.answers(shown, Eigen::all), everything.variance(shown)};
  }
  return looks;
}

constexpr std::array<const char*, 3> kLobes = {"left", "right", "liver"};
constexpr std::array<const char*, 5> kFaces = {"dome", "underside", "front", "side", "back"};

/// LPS: x to the patient's left, y to the back, z to the head.
const char* face_of(const Eigen::RowVector3d& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  if (axis == 0) return kFaces[3];
  if (axis == 1) return normal.y() < 0.0 ? kFaces[2] : kFaces[4];
  return normal.z() > 0.0 ? kFaces[0] : kFaces[1];
}

const char* lobe_of(const Landmarks& landmarks, const Eigen::RowVector3d& at) {
  if (landmarks.umbilical_notch.rows() == 0 || landmarks.vena_cava.rows() == 0) return kLobes[2];
  const Eigen::RowVector3d notch = landmarks.umbilical_notch.colwise().mean(),
                           cava = landmarks.vena_cava.colwise().mean();
  // To the left of the way from the cava to the notch, seen from the head.
  const Eigen::RowVector2d way = (notch - cava).head<2>(), to = (at - cava).head<2>();
  return way.x() * to.y() - way.y() * to.x() > 0.0 ? kLobes[0] : kLobes[1];
}

}  // namespace

std::vector<LesionLooks> looks_of(const PatientModel& model, const LabelledCloud& cloud,
                                  const Registration& registration, const ErrorModel& error,
                                  const RunContext& context) {
  std::vector<LesionLooks> all;
  const auto centres = lesion_centres(model);
  if (centres.empty()) return all;
  const Places places(model.surface.mesh);
  const std::vector<Look> looks = surface_looks(model, cloud, registration, error, places, context);
  const LandmarkLooks landmarks(model, cloud, registration);
  const ForceRows margin = landmarks.margin(), notch = landmarks.notch();
  const Look of_margin = look_along(error, margin), of_notch = look_along(error, notch);
  for (const auto& [lesion, centre] : centres) {
    if (context.cancelled()) return {};
    const Binding binding = bind_points(model.mesh, centre.transpose());
    const Eigen::MatrixXd deviations = error.deviations(
        model.mesh.tetrahedra.row(binding.tetrahedron[0]).transpose(), binding.weights.row(0).transpose());
    const auto after = [&](const Look& look) { return mean_error(covariance_after(deviations, look)); };
    LesionLooks told;
    told.lesion = lesion;
    told.now = mean_error(deviations * deviations.transpose());
    told.margin = of_margin.variance.size() > 0 ? after(of_margin) : told.now;
    told.notch = of_notch.variance.size() > 0 ? after(of_notch) : told.now;
    std::vector<double> of_places;
    of_places.reserve(looks.size());
    for (const Look& look : looks) {
      if (context.cancelled()) return {};
      of_places.push_back(look.variance.size() > 0 ? after(look) : told.now);
    }
    told.seen = Eigen::VectorXd::Constant(model.mesh.vertex_count(), told.now);
    for (std::size_t v = 0; v < places.spread.nearest.size(); ++v)
      told.seen[model.surface.node_of_vertex[v]] = of_places[places.spread.nearest[v]];
    all.push_back(std::move(told));
  }
  return all;
}

std::optional<NextLook> best_look(const LesionLooks& looks) {
  constexpr double kShare = 1.0 / 7.0, kLeast = 0.5e-3;  // m
  NextLook best{NextLook::Kind::surface, -1, looks.now, looks.now};
  const auto offer = [&](NextLook::Kind kind, int node, double after) {
    if (after < best.after) best = {kind, node, looks.now, after};
  };
  if (looks.seen.size() > 0) {
    Eigen::Index node = 0;
    const double after = looks.seen.minCoeff(&node);
    offer(NextLook::Kind::surface, static_cast<int>(node), after);
  }
  offer(NextLook::Kind::margin, -1, looks.margin);
  offer(NextLook::Kind::notch, -1, looks.notch);
  if (!(best.now - best.after >= std::max(kLeast, kShare * best.now))) return {};
  return best;
}

std::string look_note(const PatientModel& model, const LesionLooks& looks) {
  const std::optional<NextLook> best = best_look(looks);
  if (!best) return {};
  std::ostringstream note;
  note << std::fixed << std::setprecision(1);
  switch (best->kind) {
    case NextLook::Kind::surface:
      note << "look.surface " << structure_name(looks.lesion) << ' ' << place_on_liver(model, best->node);
      break;
    case NextLook::Kind::margin:
      note << "look.margin " << structure_name(looks.lesion);
      break;
    case NextLook::Kind::notch:
      note << "look.notch " << structure_name(looks.lesion);
      break;
  }
  note << ' ' << 1e3 * best->now << ' ' << 1e3 * best->after;
  return note.str();
}

std::vector<std::string> look_notes(const PatientModel& model, const Registration& registration) {
  std::vector<std::string> notes;
  for (const LesionLooks& looks : registration.looks)
    if (std::string note = look_note(model, looks); !note.empty()) notes.push_back(std::move(note));
  return notes;
}

std::string place_on_liver(const PatientModel& model, int node) {
  const std::vector<int>& nodes = model.surface.node_of_vertex;
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), node);
  require(found != nodes.end() && *found == node, "the node is of the surface");
  const Points normals = vertex_normals(model.surface.mesh);
  return std::string(lobe_of(model.landmarks, model.mesh.vertices.row(node))) + "_" +
         face_of(normals.row(found - nodes.begin()));
}

std::vector<std::string> places_on_liver() {
  std::vector<std::string> all;
  for (const char* lobe : kLobes)
    for (const char* face : kFaces) all.push_back(std::string(lobe) + "_" + face);
  return all;
}

}  // namespace glisson::registration
