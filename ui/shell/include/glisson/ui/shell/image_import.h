// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glisson/engine/commands/import_image.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/volume/series.h"

namespace glisson::ui {

/// Imports an image; of a DICOM folder or archive with several series it asks which; where the file does
/// not say whether it is CT or MRI, that. Where a case is open the image is read first, so that nobody is
/// asked whose it is of one that cannot be read.
class ImageImport : public QObject {
  Q_OBJECT
 public:
  /// @param window what the question belongs to.
  ImageImport(EngineBridge& engine, QWidget* window);

  void start(const std::filesystem::path& path);
  /// What was found good, with what the person has said about it.
  void finish(const engine::ImportImage& image);

 signals:
  /// A case is open and the image was read: whose is it? Who hears that calls finish().
  void found(const glisson::engine::ImportImage& image);

 private:
  void take(const engine::Outcome& outcome);
  void take_series(const engine::Outcome& outcome);
  void read(const std::string& series);
  void ask_modality();
  void ask(const std::vector<DicomSeries>& series);

  EngineBridge& engine_;
  QWidget* window_;
  engine::ImportImage image_;     ///< that is looked at; another one may be on its way into the case
  engine::ImportImage imported_;  ///< that one
  std::optional<engine::CommandId> listing_, reading_, importing_;
};

}  // namespace glisson::ui
