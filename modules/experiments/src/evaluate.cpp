// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/evaluate.h"

#include <limits>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/film.h"
#include "glisson/stereo/evaluate.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

Points lesion_points(const PatientModel& model) {
  const auto centres = lesion_centres(model);
  Points points(static_cast<Eigen::Index>(centres.size()), 3);
  for (std::size_t i = 0; i < centres.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = centres[i].second.transpose();
  return points;
}

void add_targets(Figures& figures, const Points& estimated, const Points& truth) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const DistanceSummary errors = point_errors(estimated, truth);
  figures["tre_target_mean_mm"] = errors.count > 0 ? 1e3 * errors.mean : unknown;
  figures["tre_target_max_mm"] = errors.count > 0 ? 1e3 * errors.maximum : unknown;
}

stereo::CloudErrors cloud_errors(const LabelledCloud& cloud, const Camera& left, const fs::path& truth,
                                 LengthUnit unit) {
  if (truth.extension() != ".pfm") return stereo::cloud_errors(cloud, read_triangle_mesh(truth, unit));
  int width = 0, height = 0;
  const std::vector<float> depth = insilico::read_depth(truth, width, height);
  if (width != left.width || height != left.height)
    throw InputError(truth.string(), "size", "is not that of the pictures",
                     "Give the depth map of the left picture");
  return stereo::cloud_errors(cloud, left, depth);
}

}  // namespace

Figures target_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_nodes,
                      const std::string& name) {
  if (true_nodes.rows() != estimated_nodes.rows())
    throw InputError(name, "nodes",
                     "has " + std::to_string(true_nodes.rows()) + " positions, the model " +
                         std::to_string(estimated_nodes.rows()),
                     "Give the truth of this model's nodes, in its order");
  Figures figures;
  const DistanceSummary volume = point_errors(estimated_nodes, true_nodes);
  figures["tre_volume_mean_mm"] = 1e3 * volume.mean;
  figures["tre_volume_max_mm"] = 1e3 * volume.maximum;
  const std::vector<int>& surface = model.surface.node_of_vertex;
  const DistanceSummary outside =
      point_errors(estimated_nodes(surface, Eigen::all), true_nodes(surface, Eigen::all));
  figures["tre_surface_mean_mm"] = 1e3 * outside.mean;
  figures["tre_surface_max_mm"] = 1e3 * outside.maximum;
  const Binding targets = bind_points(model.mesh, lesion_points(model));
  add_targets(figures, targets.apply(model.mesh, estimated_nodes), targets.apply(model.mesh, true_nodes));
  return figures;
}

Figures motion_figures(const PatientModel& model, const Points& start_nodes, const Points& true_nodes) {
  const auto best = fit_rigid<CameraFrame, CtFrame>(model.mesh.vertices, true_nodes);
  return {{"motion_mean_mm", 1e3 * point_errors(start_nodes, true_nodes).mean},
          {"rigid_best_mean_mm", 1e3 * point_errors(best.apply(model.mesh.vertices), true_nodes).mean}};
}

Figures lesion_errors(const PatientModel& model, const Points& estimated_nodes, const Points& true_centres) {
  Figures figures;
  add_targets(figures, bind_points(model.mesh, lesion_points(model)).apply(model.mesh, estimated_nodes),
              true_centres);
  return figures;
}

Points read_true_nodes(const fs::path& path, LengthUnit unit) {
  const std::string extension = lower_extension(path);
  if (extension == ".xyz" || extension == ".txt") return read_node_list(path, unit);
  return is_tetrahedral(path) ? read_tet_mesh(path, unit, MeshShape::deformed).vertices
                              : read_triangle_mesh(path, unit).vertices;
}

Figures cloud_figures(const LabelledCloud& cloud, const Camera& left, const fs::path& truth,
                      LengthUnit unit) {
  const stereo::CloudErrors errors = cloud_errors(cloud, left, truth, unit);
  const double millimetre = errors.distance.count > 0 ? 1e3 : std::numeric_limits<double>::quiet_NaN();
  return {{"cloud_error_median_mm", millimetre * errors.distance.median},
          {"cloud_error_mean_mm", millimetre * errors.distance.mean},
          {"cloud_error_p95_mm", millimetre * errors.distance.percentile_95},
          {"cloud_bias_mm", millimetre * errors.bias},
          {"cloud_points_without_truth", errors.without_truth}};
}

Figures surface_figures(const TriangleMesh& surface, const TriangleMesh& truth) {
  const SurfaceDistance distance = surface_distance(surface, truth);
  return {{"surface_to_truth_mean_mm", 1e3 * distance.forward.mean},
          {"truth_to_surface_mean_mm", 1e3 * distance.backward.mean},
          {"truth_to_surface_max_mm", 1e3 * distance.backward.maximum}};
}

}  // namespace glisson::experiments
