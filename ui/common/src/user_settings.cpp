// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/user_settings.h"

#include <QDir>

namespace glisson::ui {

std::unique_ptr<QSettings> user_settings() {
  const QString folder = qEnvironmentVariable("GLISSON_SETTINGS");
  if (!folder.isEmpty())
    return std::make_unique<QSettings>(QDir(folder).filePath(QStringLiteral("glisson.ini")),
                                       QSettings::IniFormat);
  return std::make_unique<QSettings>(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("glisson"),
                                     QStringLiteral("glisson"));
}

}  // namespace glisson::ui
