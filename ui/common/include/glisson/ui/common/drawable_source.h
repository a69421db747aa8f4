// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "glisson/model/build.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/newest_wins.h"
#include "glisson/ui/scene/drawable_model.h"

namespace glisson::ui {

/// The case's model, made ready to be drawn on a thread of its own: light surfaces take seconds to make.
class DrawableSource : public QObject {
  Q_OBJECT
 public:
  explicit DrawableSource(EngineBridge& engine, QObject* parent = nullptr);

  /// Of the case's present model; null while there is none or it is being made.
  const std::shared_ptr<const scene::DrawableModel>& drawable() const { return drawable_; }
  bool is_preparing() const { return wanted_ != nullptr && drawable_ == nullptr; }

 signals:
  /// Another one, or none any more.
  void changed();

 private:
  void show_case();
  void accept(const std::shared_ptr<const scene::DrawableModel>& made);

  EngineBridge& engine_;
  std::shared_ptr<const model::BuiltModel> wanted_;
  std::shared_ptr<const scene::DrawableModel> drawable_;
  NewestWins<std::shared_ptr<const model::BuiltModel>> maker_;
};

}  // namespace glisson::ui
