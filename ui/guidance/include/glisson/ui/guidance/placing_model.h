// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QProperty>

#include "glisson/geometry/rigid.h"
#include "glisson/ui/common/engine_bridge.h"

namespace glisson::model {
struct BuiltModel;
}

namespace glisson::ui {

/// The model while a person holds it before the registered picture, to start a registration from there. Ends
/// by itself when what it belongs to changes.
class PlacingModel : public QObject {
  Q_OBJECT
 public:
  explicit PlacingModel(EngineBridge& engine, QObject* parent = nullptr);

  /// From where the registration has put it, else upright on the points. Nothing while there is an obstacle.
  void start();
  void stop();
  /// In pixels of the left picture: the organ goes along, turns under the hand, or rolls about the sight.
  enum class Move { along, turn, roll };
  void drag(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Move move);
  /// Nearer (positive) or farther, by notches of the wheel.
  void bring_nearer(double notches);
  const CameraFromCt& pose() const { return pose_; }
  /// The undeformed model's nodes there, camera's frame, metres. @pre is_placing.
  Points nodes() const;

  QProperty<bool> is_placing;
  QProperty<QString> obstacle;  ///< the step to do before it can be placed; empty: it can

 signals:
  void moved();

 private:
  void read_case();
  void put(const CameraFromCt& pose);

  EngineBridge& engine_;
  CameraFromCt pose_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  ///< of the organ, CT frame
  std::shared_ptr<const model::BuiltModel> model_;    ///< that is held; the case may have another by now
  std::shared_ptr<const void> frame_, cloud_;
};

}  // namespace glisson::ui
