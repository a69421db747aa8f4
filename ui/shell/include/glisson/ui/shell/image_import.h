// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/volume/series.h"

namespace glisson::ui {

/// Imports an image; of a DICOM folder or archive with several series it asks which; where the file does
/// not say whether it is CT or MRI, that.
class ImageImport : public QObject {
  Q_OBJECT
 public:
  /// @param window what the question belongs to.
  ImageImport(EngineBridge& engine, QWidget* window);

  /// @param new_case it is of another patient: nothing of the open case stays.
  void start(const std::filesystem::path& path, bool new_case);

 private:
  void take(const engine::Outcome& outcome);
  void ask_modality();
  void ask(const std::vector<DicomSeries>& series);

  EngineBridge& engine_;
  QWidget* window_;
  std::filesystem::path path_;
  bool new_case_ = false;
  std::optional<engine::CommandId> listing_, importing_;
};

}  // namespace glisson::ui
