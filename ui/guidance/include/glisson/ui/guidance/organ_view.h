// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/guidance/live_view_model.h"
#include "glisson/ui/guidance/registration_model.h"
#include "glisson/ui/scene/registration_actors.h"

class QBoxLayout;
class QLabel;

namespace glisson::ui {

/// The registered organ in three dimensions, as the laparoscope sees it and from all sides: the error that is
/// expected at each place, each lesion with the region that holds it in 95 of 100 cases, where forces act,
/// the points, and the place that is compared with it. Of one that is out of date or refused the shape alone,
/// grey. While a video is followed it goes with the picture, some times a second: grey where that shows the
/// outline alone, none where it shows no overlay. The chosen lesion is the picture's, and can be chosen here.
/// Drawn when it is looked at.
class OrganView : public QWidget {
  Q_OBJECT
 public:
  /// All outlive the view.
  OrganView(EngineBridge& engine, DrawableSource& drawables, RegistrationModel& model, LiveViewModel& live,
            QWidget* parent = nullptr);
  ~OrganView() override;

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// While there is no registration.
  static QString nothing_words();
  void join_model(QLabel& words);
  void refresh();
  /// Nothing but a few words.
  void put_away(const QString& hint);
  /// As the video's frame on the screen has it. Null: as it was registered.
  void draw(const OverlayFrame* followed);
  /// The lesion at a place in the view; beside all of them: none.
  void choose_at(double x, double y);

  EngineBridge& engine_;
  DrawableSource& drawables_;
  RegistrationModel& model_;
  LiveViewModel& live_;
  RenderView* view_;
  QWidget* scale_;
  QWidget* legend_;
  QBoxLayout *around_, *words_and_legend_;  ///< the organ and what is told of it; of the latter
  QTimer pace_;                             ///< runs from a picture on until the organ has followed it
  std::unique_ptr<scene::RegistrationActors> actors_;
  std::shared_ptr<const scene::DrawableModel> drawn_;
  std::vector<LesionVerdict> lesions_;             ///< that are drawn
  std::shared_ptr<const Registration> looked_at_;  ///< that the view was turned to
  Couplings couplings_;
};

}  // namespace glisson::ui
