// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/timeline_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>
#include <array>

#include "glisson/ui/guidance/timeline_track.h"

namespace glisson::ui {
namespace {

constexpr std::array<double, 4> kSpeeds = {0.25, 0.5, 1.0, 2.0};
constexpr int kNormalSpeed = 2, kManyFrames = 10;

QToolButton* make_button(QWidget* parent, const char* name, const QString& sign, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QString::fromLatin1(name));
  button->setText(sign);
  if (sign.size() <= 2) button->setProperty("role", "sign");  // the track has the room
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::NoFocus);  // space and arrows belong to the bar
  return button;
}

}  // namespace

TimelineBar::TimelineBar(ReviewModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName(QStringLiteral("timeline_bar"));
  setProperty("role", "viewbar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 2, 8, 2);
  row->setSpacing(4);
  QToolButton* back = make_button(this, "step_back", QStringLiteral("❮"), tr("One frame back (left arrow)"));
  QToolButton* play = make_button(this, "play", QStringLiteral("▶"), tr("Play or pause (space)"));
  QToolButton* on = make_button(this, "step_on", QStringLiteral("❯"), tr("One frame on (right arrow)"));
  auto* track = new TimelineTrack(this);
  track->setObjectName(QStringLiteral("timeline_track"));
  auto* place = new QLabel(this);
  place->setObjectName(QStringLiteral("timeline_place"));
  auto* speed = new QComboBox(this);
  speed->setObjectName(QStringLiteral("playing_speed"));
  speed->setFocusPolicy(Qt::NoFocus);
  speed->setToolTip(tr("Speed"));
  speed->setFixedWidth(72);
  for (const double factor : kSpeeds) speed->addItem(tr("%1 ×").arg(factor), factor);
  speed->setCurrentIndex(kNormalSpeed);
  QToolButton* loop = make_button(this, "loop", QStringLiteral("⟳"), tr("Begin again at the end"));
  loop->setCheckable(true);
  QToolButton* live = make_button(this, "go_live", tr("Live"), tr("Back to the live video (End)"));
  for (QWidget* part : std::initializer_list<QWidget*>{back, play, on}) row->addWidget(part);
  row->addWidget(track, 1);
  for (QWidget* part : std::initializer_list<QWidget*>{place, speed, loop, live}) row->addWidget(part);

  connect(back, &QToolButton::clicked, &model, [&model] { model.step(-1); });
  connect(on, &QToolButton::clicked, &model, [&model] { model.step(1); });
  connect(play, &QToolButton::clicked, &model, &ReviewModel::toggle);
  connect(live, &QToolButton::clicked, &model, &ReviewModel::go_live);
  connect(loop, &QToolButton::toggled, &model, [&model](bool is) { model.loops = is; });
  connect(track, &TimelineTrack::wanted, &model, &ReviewModel::seek);
  connect(speed, &QComboBox::currentIndexChanged, &model,
          [&model, speed](int) { model.set_speed(speed->currentData().toDouble()); });
  const auto show_place = [track, place, &model] {
    // A live frame can be looked at again a moment after it was shown.
    const int last = std::max(model.last.value(), model.position.value());
    track->set_range(model.first, last);
    track->set_position(model.position);
    place->setText(model.is_offered ? tr("%1 / %2").arg(model.position.value()).arg(last) : QString());
  };
  couplings_.add(model.first, [show_place](int) { show_place(); });
  couplings_.add(model.last, [show_place](int) { show_place(); });
  couplings_.add(model.position, [show_place](int) { show_place(); });
  couplings_.add(model.marks, [track](const std::vector<LevelMark>& marks) { track->set_marks(marks); });
  couplings_.add(model.is_offered, [this, show_place](bool is) {
    setVisible(is);
    show_place();
  });
  couplings_.add(model.runs,
                 [play](bool is) { play->setText(is ? QStringLiteral("❚❚") : QStringLiteral("▶")); });
  couplings_.add(model.is_reviewing, [live](bool is) { live->setEnabled(is); });
}

bool TimelineBar::press(int key, Qt::KeyboardModifiers modifiers) {
  const int frames = modifiers.testFlag(Qt::ShiftModifier) ? kManyFrames : 1;
  const auto go = [this, frames](int by) {
    if (frames == 1)
      model_.step(by);
    else
      model_.seek(model_.position + by * frames);
  };
  switch (key) {
    case Qt::Key_Space:
      model_.toggle();
      return true;
    case Qt::Key_Left:
      go(-1);
      return true;
    case Qt::Key_Right:
      go(1);
      return true;
    case Qt::Key_Home:
      model_.seek(model_.first);
      return true;
    case Qt::Key_End:
      model_.go_live();
      return true;
    default:
      return false;
  }
}

void TimelineBar::add_at_end(QWidget* control) { layout()->addWidget(control); }

}  // namespace glisson::ui
