// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/guidance_panel.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/engine/parts/registration.h"
#include "glisson/ui/guidance/lesion_box.h"
#include "glisson/ui/guidance/look_box.h"
#include "glisson/ui/guidance/playback_box.h"
#include "glisson/ui/guidance/recording_box.h"
#include "glisson/ui/guidance/registration_box.h"

namespace glisson::ui {

GuidancePanel::GuidancePanel(EngineBridge& engine, DrawableSource& drawables, QWidget* parent)
    : Panel(engine, tr("Guidance"), tr("The model brought to what the laparoscope sees, and kept there."),
            parent),
      registration_(engine),
      playback_(engine),
      review_(engine, playback_),
      recording_(worker_, playback_),
      live_(engine, drawables, playback_, review_, worker_),
      view_(new LiveView(live_, review_)) {
  setObjectName(QStringLiteral("guidance_panel"));
  add_section(tr("1. Initial registration"),
              tr("Rigid start from the labelled features; then the shape that simulated operations on "
                 "this liver make most probable, drawn to the points."))
      ->addWidget(new RegistrationBox(engine, registration_, this));
  QVBoxLayout* live =
      add_section(tr("2. Live tracking"), tr("Plays the case's stereo video as a live laparoscope."));
  auto* playback = new PlaybackBox(engine, playback_, this);
  auto* recording = new RecordingBox(recording_, this);
  playback->add_beside_stop(recording->button());
  live->addWidget(playback);
  live->addWidget(recording);
  auto* figures = new FiguresTable(this);
  live->addWidget(figures);
  couplings_.add(live_.figures, [figures](const FigureRows& rows) { figures->set_rows(rows); });
  live->addWidget(new LesionBox(live_, this));
  add_section(tr("Overlay"))->addWidget(new LookBox(live_, this));
  watch(part::registration);
}

GuidancePanel::~GuidancePanel() {
  if (view_ && view_->parent() == nullptr) delete view_;  // nobody hosted it
}

}  // namespace glisson::ui
