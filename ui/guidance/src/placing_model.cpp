// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/placing_model.h"

#include <cmath>

#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/registration/hand_pose.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr double kRadiansAcross = M_PI;  ///< a drag over the picture's width turns it by half a circle
constexpr double kNotch = 0.97;          ///< of the distance that a notch of the wheel leaves

}  // namespace

PlacingModel::PlacingModel(EngineBridge& engine, QObject* parent) : QObject(parent), engine_(engine) {
  connect(&engine_, &EngineBridge::case_changed, this, &PlacingModel::read_case);
  read_case();
}

void PlacingModel::read_case() {
  const engine::CaseState& now = engine_.state();
  auto first = engine::obstacle(*engine_.snapshot(), engine::Register{});
  if (!first) first = engine::obstacle(now, {part::rig, part::frame});  // it is held before the picture
  const QString missing = obstacle_text(first);
  obstacle = missing;
  const bool is_the_same =
      model_ == now[part::model] && frame_ == now[part::frame] && cloud_ == now[part::cloud];
  if (is_placing && (!is_the_same || !missing.isEmpty())) stop();
}

void PlacingModel::start() {
  if (is_placing || !obstacle.value().isEmpty()) return;
  const engine::CaseState& now = engine_.state();
  model_ = now[part::model];
  frame_ = now[part::frame];
  cloud_ = now[part::cloud];
  const PatientModel& patient = now[part::model]->model;
  middle_ = patient.mesh.vertices.colwise().mean().transpose();
  const auto& registered = now[part::registration];
  if (registered && registered->nodes_in_camera.rows() == patient.mesh.vertex_count())
    pose_ = registered->camera_from_ct;
  else
    pose_ = registration::upright_before(middle_, now[part::cloud]->points.colwise().mean().transpose());
  is_placing = true;
  emit moved();
}

void PlacingModel::stop() {
  if (!is_placing) return;
  is_placing = false;
  emit moved();
}

void PlacingModel::put(const CameraFromCt& pose) {
  pose_ = pose;
  emit moved();
}

void PlacingModel::drag(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Move move) {
  if (!is_placing) return;
  const Camera& camera = engine_.state()[part::rig]->left;
  if (move == Move::along) return put(registration::dragged(pose_, middle_, camera, from, to));
  const Eigen::Vector2d way = (kRadiansAcross / camera.width) * (to - from);
  if (move == Move::turn) return put(registration::turned(pose_, middle_, {-way.y(), way.x(), 0.0}));
  const Eigen::Vector2d centre = camera.project(pose_.rotation * middle_ + pose_.translation);
  const Eigen::Vector2d a = from - centre, b = to - centre;
  put(registration::turned(pose_, middle_, {0.0, 0.0, std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))}));
}

void PlacingModel::bring_nearer(double notches) {
  if (is_placing) put(registration::at_distance(pose_, middle_, std::pow(kNotch, notches)));
}

Points PlacingModel::nodes() const { return pose_.apply(model_->model.mesh.vertices); }

}  // namespace glisson::ui
