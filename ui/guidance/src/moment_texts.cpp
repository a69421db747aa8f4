// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/moment_texts.h"

#include <QCoreApplication>
#include <QDateTime>

#include "glisson/engine/parts/moments.h"
#include "glisson/ui/scene/overlay_painter.h"

namespace glisson::ui {
namespace {

struct MomentTexts {
  Q_DECLARE_TR_FUNCTIONS(MomentTexts)
};

/// In the machine's time zone.
QString kept_at(const engine::KeptMoment& moment) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(moment.kept_at), Qt::ISODate);
  return at.isValid() ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"))
                      : MomentTexts::tr("at an unknown time");
}

}  // namespace

QString moment_place(const engine::KeptMoment& moment) {
  return MomentTexts::tr("frame %1, %2").arg(moment.overlay.index).arg(kept_at(moment));
}

QString moment_time(const engine::KeptMoment& moment) {
  return MomentTexts::tr("frame %1, %2 s, kept %3")
      .arg(moment.overlay.index)
      .arg(moment.overlay.seconds, 0, 'f', 1)
      .arg(kept_at(moment));
}

QString moment_level(const engine::KeptMoment& moment) {
  const QString why = QString::fromStdString(scene::validity_text(moment.overlay.validity));
  switch (moment.overlay.level()) {
    case Level::valid:
      return MomentTexts::tr("valid");
    case Level::degraded:
      return MomentTexts::tr("outline only: %1").arg(why);
    case Level::withdrawn:
      return MomentTexts::tr("no overlay: %1").arg(why);
  }
  return {};
}

}  // namespace glisson::ui
