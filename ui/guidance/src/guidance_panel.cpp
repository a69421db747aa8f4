// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/guidance_panel.h"

#include <QPushButton>
#include <QShortcut>
#include <QVBoxLayout>

#include "glisson/engine/parts/registration.h"
#include "glisson/ui/guidance/again_box.h"
#include "glisson/ui/guidance/correction_box.h"
#include "glisson/ui/guidance/lesion_box.h"
#include "glisson/ui/guidance/look_box.h"
#include "glisson/ui/guidance/mask_box.h"
#include "glisson/ui/guidance/moments_box.h"
#include "glisson/ui/guidance/openigtlink_box.h"
#include "glisson/ui/guidance/organ_view.h"
#include "glisson/ui/guidance/playback_box.h"
#include "glisson/ui/guidance/recording_box.h"
#include "glisson/ui/guidance/registration_box.h"
#include "glisson/ui/guidance/tool_box.h"

namespace glisson::ui {

GuidancePanel::GuidancePanel(EngineBridge& engine, DrawableSource& drawables, QWidget* parent)
    : Panel(engine, tr("Guidance"), tr("The model brought to what the laparoscope sees, and kept there."),
            parent),
      registration_(engine),
      placing_(engine),
      playback_(engine),
      review_(engine, playback_),
      correction_(engine, playback_, review_),
      again_(engine, playback_),
      mask_(engine, playback_),
      recording_(worker_, playback_, correction_, again_),
      live_(engine, drawables, playback_, review_, worker_),
      moments_(engine, playback_, review_, live_),
      openigtlink_(engine, drawables),
      tool_(engine, drawables, playback_, review_, live_),
      view_(new GuidanceView(new LiveView(live_, review_, correction_, again_, moments_),
                             new OrganView(engine, drawables, registration_, live_))) {
  setObjectName(QStringLiteral("guidance_panel"));
  add_section(tr("1. Initial registration"),
              tr("Rigid start from the labelled features; then the shape that simulated operations on "
                 "this liver make most probable, drawn to the points."))
      ->addWidget(new RegistrationBox(engine, registration_, placing_, this));
  QVBoxLayout* live =
      add_section(tr("2. Live tracking"), tr("Plays the case's stereo video as a live laparoscope."));
  auto* playback = new PlaybackBox(engine, playback_, this);
  auto* recording = new RecordingBox(recording_, this);
  playback->add_beside_stop(recording->button());
  live->addWidget(playback);
  live->addWidget(recording);
  live->addWidget(new MomentsBox(moments_, this));
  live->addWidget(new CorrectionBox(correction_, this));
  live->addWidget(new AgainBox(again_, this));
  live->addWidget(new MaskBox(mask_, this));
  auto* figures = new FiguresTable(this);
  live->addWidget(figures);
  couplings_.add(live_.figures, [figures](const FigureRows& rows) { figures->set_rows(rows); });
  live->addWidget(new LesionBox(live_, registration_, this));
  add_section(tr("Overlay"))->addWidget(new LookBox(live_, this));
  QVBoxLayout* others =
      add_section(tr("Other programs"), tr("3D Slicer, CustusX or PLUS may follow what is tracked here."));
  others->addWidget(new OpenIgtLinkBox(openigtlink_, this));
  others->addWidget(new ToolBox(tool_, this));
  watch(part::registration);
  // After the recording itself, which says by then how it went.
  connect(&worker_, &OverlayWorker::recording_ended, this, [this] {
    emit wound_up(recording_.tone.value() == QLatin1String("good") ? QString() : recording_.said.value());
  });

  join_hands();
  couplings_.add(correction_.is_correcting, [this](bool is) { live_.show_refuted(is); });
  couplings_.add(registration_.method, [this](registration::Method method) { again_.set_method(method); });
  for (QWidget* place : {static_cast<QWidget*>(this), static_cast<QWidget*>(view_.data())}) {
    auto* undo = new QShortcut(QKeySequence::Undo, place, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    undo->setAutoRepeat(false);
    connect(undo, &QShortcut::activated, &registration_, &RegistrationModel::undo);
    // While the organ is followed the keys take back what hands have set; over its last picture they would
    // put away all that can be looked at again.
    const auto enable = [this, undo](bool) {
      undo->setEnabled(registration_.can_undo && !playback_.is_tracking && !playback_.is_frozen);
    };
    couplings_.add(registration_.can_undo, enable);
    couplings_.add(playback_.is_tracking, enable);
    couplings_.add(playback_.is_frozen, enable);
  }
  couplings_.add(registration_.shown_rival, [this](int rival) {
    if (rival >= 0 && !playback_.is_tracking) leave_former();
    show_proposed();
  });
}

void GuidancePanel::join_hands() {
  auto* picture = view_->findChild<LivePicture*>();
  connect(picture, &LivePicture::dragged, &placing_, [this](const auto& from, const auto& to, auto keys) {
    placing_.drag(from, to,
                  keys.testFlag(Qt::ShiftModifier)     ? PlacingModel::Move::turn
                  : keys.testFlag(Qt::ControlModifier) ? PlacingModel::Move::roll
                                                       : PlacingModel::Move::along);
  });
  connect(picture, &LivePicture::wheeled, &placing_, &PlacingModel::bring_nearer);
  connect(&placing_, &PlacingModel::moved, this, &GuidancePanel::show_proposed);
  couplings_.add(placing_.is_placing, [this, picture](bool is) {
    if (is) leave_former();  // hands move what is drawn
    picture->set_placing(can_drag());
    if (is) view_->show_picture();
  });
  couplings_.add(moments_.shown, [this, picture](int number) {
    picture->set_placing(can_drag());
    if (number != 0) view_->show_picture();
  });
  couplings_.add(review_.is_reviewing, [this, picture](bool) { picture->set_placing(can_drag()); });
}

QString GuidancePanel::wind_up() {
  if (!recording_.is_recording) return {};
  recording_.stop();
  return tr("The recording is being brought to its end. If all went well, the window closes then.");
}

void GuidancePanel::leave_former() {
  review_.go_live();
  moments_.go_live();
}

bool GuidancePanel::can_drag() const {
  return placing_.is_placing && moments_.shown == 0 && !review_.is_reviewing;
}

void GuidancePanel::show_proposed() {
  if (placing_.is_placing)
    return live_.propose({{placing_.nodes(), tr("Placed by hand: not registered. Refine, or put it back.")}});
  if (const Points* rival = registration_.rival_nodes())
    return live_.propose(
        {{*rival,
          tr("Other place %1, to be compared: not the registration.").arg(registration_.shown_rival + 1)}});
  live_.propose({});
}

GuidancePanel::~GuidancePanel() {
  if (view_ && view_->parent() == nullptr) delete view_;  // nobody hosted it
}

}  // namespace glisson::ui
