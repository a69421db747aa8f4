// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/preview_service.h"
#include "glisson/ui/segmentation/label_meanings.h"

namespace glisson::ui {

/// Imports labels that were made elsewhere. Where the file does not say which of them is the liver, or says
/// numbers only, the person is asked first: what is guessed wrong makes a vein of a tumour. So is, whether a
/// liver that lies left of the vena cava was operated on, and whether what a hand has corrected may go.
class LabelImport : public QObject {
  Q_OBJECT
 public:
  /// @param owner what the question belongs to.
  LabelImport(EngineBridge& engine, QWidget* owner);

  /// A file that cannot be read is left to the command, which says why.
  void start(const std::filesystem::path& path);
  bool is_reading() const { return reading_; }

 signals:
  /// It is looked into a file, or not any more.
  void reading_changed();

 private:
  static Cancellable<FoundLabels> look(const std::filesystem::path& path, const RunContext& context);
  void accept(const std::filesystem::path& path, const FoundLabels& found);
  void ask(const std::filesystem::path& path, const FoundLabels& found);
  /// @param codes what the person said; empty: the file's own word counts.
  void import_as(const std::filesystem::path& path, const FoundLabels& found, const LabelCodes& codes);
  void post(const std::filesystem::path& path, const LabelCodes& codes, LeftLiver left_liver);

  EngineBridge& engine_;
  QWidget* owner_;
  bool reading_ = false;
  PreviewService<std::filesystem::path, FoundLabels> looking_;  ///< last: its thread uses the others
};

}  // namespace glisson::ui
