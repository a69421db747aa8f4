// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/guidance/registration_model.h"
#include "glisson/ui/scene/registration_actors.h"

namespace glisson::ui {

/// The registered organ in three dimensions, as the laparoscope sees it and from all sides: the error that is
/// expected at each place, each lesion with the region that holds it in 95 of 100 cases, where forces act,
/// the points, and the place that is compared with it. Of one that is out of date or refused the shape alone,
/// grey. Drawn when it is looked at.
class OrganView : public QWidget {
  Q_OBJECT
 public:
  /// All outlive the view.
  OrganView(EngineBridge& engine, DrawableSource& drawables, RegistrationModel& model,
            QWidget* parent = nullptr);
  ~OrganView() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();

  EngineBridge& engine_;
  DrawableSource& drawables_;
  RegistrationModel& model_;
  RenderView* view_;
  QWidget* scale_;
  std::unique_ptr<scene::RegistrationActors> actors_;
  std::shared_ptr<const scene::DrawableModel> drawn_;
  std::shared_ptr<const Registration> looked_at_;  ///< that the view was turned to
  Couplings couplings_;
};

}  // namespace glisson::ui
