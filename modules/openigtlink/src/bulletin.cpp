// SPDX-License-Identifier: GPL-3.0-or-later
#include "bulletin.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/units.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "messages.h"

namespace glisson::openigtlink {
namespace {

constexpr const char* kLevelName = "GlissonLevel";
constexpr const char* kPoseName = "LeftCameraToCtRas";

bool are_same(const Points& a, const Points& b) { return a.rows() == b.rows() && a == b; }

/// Whether the frame's nodes are this model's and are anywhere.
bool has_nodes(const SentModel& model, const OverlayFrame& frame) {
  constexpr Eigen::Index kFewest = 3;  // that tell a pose
  const Eigen::Index nodes = frame.nodes_in_camera.rows();
  return nodes >= kFewest && nodes == model.model->mesh.vertex_count() && frame.nodes_in_camera.allFinite();
}

/// A frame that says more than it holds is told as withdrawn.
OverlayFrame honest(const SentModel* model, const OverlayFrame& frame) {
  if (frame.level() == Level::withdrawn || (model && has_nodes(*model, frame))) return frame;
  OverlayFrame result = frame;
  result.validity = Validity::mechanics_failed;
  return result;
}

/// The left camera in the CT with RAS axes, millimetres: of the rigid motion that comes nearest to where the
/// nodes are. The CT's own axes are LPS, so that x and y change their signs; the camera's stay OpenCV's.
Eigen::Matrix4d camera_pose(const SentModel& model, const OverlayFrame& frame) {
  const auto camera_from_ct =
      fit_rigid<CameraFrame, CtFrame>(model.model->mesh.vertices, frame.nodes_in_camera);
  Eigen::Matrix4d ras_from_camera = camera_from_ct.inverse().matrix();
  ras_from_camera.topRightCorner<3, 1>() /= metres_per(LengthUnit::millimetre);
  ras_from_camera.topRows<2>() *= -1.0;
  return ras_from_camera;
}

/// As it is drawn: everything in a valid frame but lesions that are less than valid themselves; the organ's
/// outline only in a degraded one.
bool is_shown(Label structure, const OverlayFrame& frame) {
  if (frame.level() == Level::withdrawn) return false;
  if (structure == structure::kParenchyma) return true;
  if (frame.level() == Level::degraded) return false;
  if (!is_lesion(structure)) return true;
  return std::any_of(frame.lesions.begin(), frame.lesions.end(), [&](const LesionVerdict& verdict) {
    return verdict.lesion == structure && verdict.level == Level::valid;
  });
}

std::set<std::string> shown_in(const SentModel* model, const OverlayFrame& frame) {
  std::set<std::string> names;
  if (!model) return names;
  for (const SentSurface& surface : model->surfaces)
    if (is_shown(surface.structure, frame)) names.insert(structure_name(surface.structure));
  return names;
}

/// What STRING and STATUS say.
std::string level_text(const OverlayFrame& frame) {
  return std::string("level=") + level_code(frame.level()) + " reason=" + validity_code(frame.validity) +
         " frame=" + std::to_string(frame.index) + " doubtful=" + (frame.doubtful ? "yes" : "no");
}

}  // namespace

void Bulletin::compose(const SentModel* model, const OverlayFrame& told, double epoch) {
  const OverlayFrame frame = honest(model, told);
  const double stamp = epoch + frame.seconds;
  std::string bytes = status_message(kLevelName, stamp, frame.level(), level_text(frame)) +
                      string_message(kLevelName, stamp, level_text(frame));
  if (frame.level() != Level::withdrawn)
    bytes += transform_message(kPoseName, stamp, camera_pose(*model, frame));
  level_ = std::make_shared<const std::string>(std::move(bytes));
  ++level_number_;

  const std::set<std::string> shown = shown_in(model, frame);
  const bool is_corrected =
      !shown.empty() && told_at_ == frame.seconds && !are_same(told_, frame.nodes_in_camera);
  told_ = frame.nodes_in_camera;
  told_at_ = frame.seconds;
  if (model == shown_of_ && !is_corrected && !are_due(shown, frame.seconds)) return;
  surfaces_ = std::make_shared<const std::string>(surface_messages(model, frame, shown, stamp));
  ++surfaces_number_;
  shown_ = shown;
  shown_at_ = frame.seconds;
  shown_of_ = model;
}

bool Bulletin::are_due(const std::set<std::string>& shown, double seconds) const {
  constexpr double kRounding = 1e-6;
  return !shown_at_ || shown != shown_ || std::abs(seconds - *shown_at_) + kRounding >= 1.0 / rate_;
}

std::string Bulletin::surface_messages(const SentModel* model, const OverlayFrame& frame,
                                       const std::set<std::string>& shown, double stamp) {
  std::string bytes;
  if (model)
    for (const SentSurface& surface : model->surfaces) {
      const std::string name = structure_name(surface.structure);
      named_.insert(name);
      if (!shown.contains(name)) continue;
      const Points vertices = surface.binding.apply(model->model->mesh, frame.nodes_in_camera);
      bytes += poly_data_message(name, stamp, vertices, surface.triangles);
    }
  for (const std::string& name : named_)
    if (!shown.contains(name)) bytes += poly_data_message(name, stamp, Points(0, 3), Triangles(0, 3));
  return bytes;
}

}  // namespace glisson::openigtlink
