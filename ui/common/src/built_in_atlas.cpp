// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/built_in_atlas.h"

#include <QFile>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

// Outside of every namespace, as Qt asks for it.
static void load_atlas() { Q_INIT_RESOURCE(glisson_atlas); }

namespace glisson::ui {
namespace {

std::shared_ptr<const atlas::Atlas> unpacked() {
  load_atlas();
  const TemporaryFolder folder;
  for (const char* name : {"atlas.json", "mean.vtp"}) {
    QFile packed(QStringLiteral(":/glisson/atlas/") + QLatin1String(name));
    if (!packed.open(QIODevice::ReadOnly))
      throw FileError(std::string("the program lacks its atlas: ") + name);
    write_file_atomically(folder.path() / name, packed.readAll().toStdString());
  }
  return std::make_shared<const atlas::Atlas>(atlas::read_atlas(folder.path()));
}

}  // namespace

std::shared_ptr<const atlas::Atlas> built_in_atlas() {
  static const std::shared_ptr<const atlas::Atlas> kAtlas = unpacked();
  return kAtlas;
}

std::shared_ptr<const atlas::Atlas> built_in_atlas_if_any() {
  try {
    return built_in_atlas();
  } catch (const Error&) {
    return nullptr;
  }
}

}  // namespace glisson::ui
