// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <clocale>

// The translations are in a static library: without a mention the linker leaves them out.
static void load_translations() { Q_INIT_RESOURCE(glisson_translations); }

namespace glisson::ui {

void set_up_language(QCoreApplication& application) {
  std::setlocale(LC_NUMERIC, "C");
  load_translations();
  // Qt's own words ("Usage", "Cancel" in dialogs) are there when its translations are installed.
  for (const auto& [name, folder] :
       {std::pair(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath)),
        std::pair(QStringLiteral("glisson"), QStringLiteral(":/glisson/translations"))}) {
    auto* translator = new QTranslator(&application);
    if (translator->load(QLocale(), name, QStringLiteral("_"), folder))
      QCoreApplication::installTranslator(translator);
    else
      delete translator;
  }
  // From here on numbers look the same everywhere, in spin boxes as in the figures beside them.
  QLocale::setDefault(QLocale::c());
}

}  // namespace glisson::ui
