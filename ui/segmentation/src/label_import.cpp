// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/label_import.h"

#include <QWidget>
#include <exception>

#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/common/left_liver_question.h"
#include "glisson/ui/segmentation/hand_work_question.h"
#include "glisson/volume/dicom_segmentation.h"

namespace glisson::ui {

LabelImport::LabelImport(EngineBridge& engine, QWidget* owner)
    : QObject(owner),
      engine_(engine),
      owner_(owner),
      looking_(this, look, [this](const auto& path, const auto& found) { accept(path, *found); }) {}

void LabelImport::start(const std::filesystem::path& path) {
  reading_ = true;
  emit reading_changed();
  looking_.give_instead(path);
}

Cancellable<FoundLabels> LabelImport::look(const std::filesystem::path& path, const RunContext& context) {
  try {
    if (has_dicom_mark(path)) {
      const auto labels = read_dicom_labels(path, context);
      if (!labels) return std::nullopt;
      return found_labels(labels->file, labels->own);
    }
    const auto file = read_labels(path, context);
    if (!file) return std::nullopt;
    return found_labels(*file, false);
  } catch (const std::exception&) {
    return FoundLabels();  // the command says what is wrong with it
  }
}

void LabelImport::accept(const std::filesystem::path& path, const FoundLabels& found) {
  reading_ = false;
  emit reading_changed();
  if (found.must_be_asked())
    ask(path, found);
  else
    import_as(path, found, {});
}

void LabelImport::ask(const std::filesystem::path& path, const FoundLabels& found) {
  auto* dialog = new LabelMeanings(found, QString::fromStdString(path.filename().string()), owner_->window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this,
          [this, dialog, path, found] { import_as(path, found, dialog->codes()); });
  dialog->open();  // does not stop the window
}

void LabelImport::import_as(const std::filesystem::path& path, const FoundLabels& found,
                            const LabelCodes& codes) {
  if (!found.summary.look_mirrored(codes.empty() ? found.meanings() : codes))
    return post(path, codes, LeftLiver::refused);
  ask_left_liver(owner_->window(), path, [this, path, codes] { post(path, codes, LeftLiver::asked); });
}

void LabelImport::post(const std::filesystem::path& path, const LabelCodes& codes, LeftLiver left_liver) {
  const auto import = [this, command = engine::ImportLabels{path, codes, built_in_atlas_if_any(),
                                                            left_liver}] { engine_.post(command); };
  const std::set<Label> edited = engine::edited_by_hand(engine_.state());
  if (edited.empty()) return import();
  ask_over_hand_work(owner_->window(), edited,
                     tr("What is imported takes the place of all labels, with these corrections."), import);
}

}  // namespace glisson::ui
