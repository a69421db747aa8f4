// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/playback_box.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>

#include "box_layout.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/ui/common/task_button.h"

namespace glisson::ui {

PlaybackBox::PlaybackBox(EngineBridge& engine, PlaybackModel& model, QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout) {
  QVBoxLayout* box = make_box_layout(this);
  auto* start = new TaskButton(
      engine, tr("Start tracking"), [&model] { return engine::Command(model.command()); }, this);
  start->setObjectName(QStringLiteral("start_tracking"));
  start->reserve_lines();  // what stands below is wanted in a hurry
  box->addWidget(start);
  auto* stop = new QPushButton(tr("Stop"), this);
  stop->setObjectName(QStringLiteral("stop_tracking"));
  row_->addWidget(stop);
  box->addLayout(row_);
  auto* repeat = new QCheckBox(tr("Repeat the video"), this);
  repeat->setObjectName(QStringLiteral("repeat_video"));
  repeat->setToolTip(tr("At its end, track again from the registered frame."));
  box->addWidget(repeat);

  connect(start, &TaskButton::done, &model, &PlaybackModel::begin);
  connect(&model, &PlaybackModel::start_wanted, start, &TaskButton::trigger);
  connect(stop, &QPushButton::clicked, &model, &PlaybackModel::stop);
  connect(repeat, &QCheckBox::toggled, &model, [&model](bool on) { model.repeats = on; });
  couplings_.add(model.obstacle, [start](const QString& text) { start->set_obstacle(text); });
  couplings_.add(model.is_tracking, [stop](bool is) { stop->setEnabled(is); });
  couplings_.add(model.repeats, [repeat](bool on) { repeat->setChecked(on); });
}

void PlaybackBox::add_beside_stop(QWidget* control) { row_->addWidget(control); }

}  // namespace glisson::ui
