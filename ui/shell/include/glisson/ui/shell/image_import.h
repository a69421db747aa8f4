// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"

namespace glisson::ui {

/// Imports an image; of a DICOM folder or archive with several series it asks which.
class ImageImport : public QObject {
  Q_OBJECT
 public:
  /// @param window what the question belongs to.
  ImageImport(EngineBridge& engine, QWidget* window);

  void start(const std::filesystem::path& path);

 private:
  void take(const engine::Outcome& outcome);
  void ask(const std::vector<DicomSeries>& series);

  EngineBridge& engine_;
  QWidget* window_;
  std::filesystem::path path_;
  std::optional<engine::CommandId> listing_;
};

}  // namespace glisson::ui
