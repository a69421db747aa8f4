// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/guidance/live_picture.h"
#include "glisson/ui/guidance/live_view_model.h"

namespace glisson::ui {

/// The augmented picture, with what is said of it above and below.
class LiveView : public QWidget {
  Q_OBJECT
 public:
  explicit LiveView(LiveViewModel& model, QWidget* parent = nullptr);
  const LivePicture& picture() const { return *picture_; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  LiveViewModel& model_;
  LivePicture* picture_;
  Couplings couplings_;
};

}  // namespace glisson::ui
