// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/atlas_choice.h"

#include <QSettings>

#include "glisson/core/error.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/user_settings.h"

namespace glisson::ui {
namespace {

const QString kKey = QStringLiteral("atlas");

/// Null, and why.
std::shared_ptr<const atlas::Atlas> read(const std::filesystem::path& folder, QString& problem) {
  try {
    return std::make_shared<const atlas::Atlas>(atlas::read_atlas(folder));
  } catch (const Error& error) {
    problem = error_text(error.what());
    return nullptr;
  }
}

}  // namespace

AtlasChoice::AtlasChoice(QObject* parent) : QObject(parent) {
  folder_ = user_settings()->value(kKey).toString().toStdString();
  if (!folder_.empty()) own_ = read(folder_, problem_);
}

std::shared_ptr<const atlas::Atlas> AtlasChoice::atlas() const {
  return is_built_in() ? built_in_atlas() : own_;
}

bool AtlasChoice::choose(const std::filesystem::path& folder, QString& problem) {
  auto found = read(folder, problem);
  if (!found) return false;
  own_ = std::move(found);
  std::error_code failure;
  const std::filesystem::path whole = std::filesystem::absolute(folder, failure);
  keep(failure ? folder : whole);
  return true;
}

void AtlasChoice::choose_built_in() {
  own_ = nullptr;
  keep({});
}

void AtlasChoice::keep(const std::filesystem::path& folder) {
  folder_ = folder;
  problem_.clear();
  const auto settings = user_settings();
  if (folder.empty())
    settings->remove(kKey);
  else
    settings->setValue(kKey, QString::fromStdString(folder.string()));
  emit changed();
}

}  // namespace glisson::ui
