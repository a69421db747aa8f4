// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>

#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/edit_session.h"
#include "glisson/ui/segmentation/label_table.h"

class QLabel;
class QPushButton;

namespace glisson::ui {

class EditBox;
class LabelImport;
class OfferBox;
class SeedBox;

/// CT to labels: structures grow from seeds that the operator clicks, and are corrected by hand.
class SegmentationPanel : public Panel {
  Q_OBJECT
 public:
  SegmentationPanel(EngineBridge& engine, ViewState& views, QWidget* parent = nullptr);

  void activate() override;
  void deactivate() override;
  EditSession& session() { return *session_; }
  /// Clicks in the slices place seeds of this structure; none: they move the crosshair.
  void choose_structure(std::optional<Label> structure);
  /// Undo and redo, for a menu.
  QList<QAction*> history_actions() const;
  /// Labels that were made elsewhere; what they mean is asked where the file does not say.
  void import_labels(const std::filesystem::path& path);
  /// Seeds and growth, or the tools of the hand.
  void show_editing(bool on);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_modes();
  void build_labels();
  void show_case();
  void show_offer();
  /// They stand where the segmentation was asked for, which may be out of sight: the head counts them.
  void show_notes();
  void go_to_notes();
  void show_rows();
  void show_label();
  void toggle(std::set<Label>& labels, Label label);
  void take_marks();
  void approve();
  /// Chooses the next label that nobody has approved, and shows it in the slices.
  /// @param had_keyboard Approve gets it back.
  void look_at_next(Label approved, bool had_keyboard);
  void ask_for_labels();
  void show_import();

  ViewState& views_;
  EditSession* session_;
  SeedBox* seeds_ = nullptr;
  EditBox* edit_ = nullptr;
  OfferBox* offer_ = nullptr;
  QPushButton* seeds_mode_ = nullptr;
  QPushButton* edit_mode_ = nullptr;
  LabelTable* table_ = nullptr;
  QLabel* figures_ = nullptr;
  QPushButton* approve_ = nullptr;
  bool waits_for_eye_ = false;  ///< another label has just come to be approved
  QPushButton* import_ = nullptr;
  LabelImport* importer_ = nullptr;
  std::set<Label> hidden_, locked_;
  engine::CommandId locking_ = 0;  ///< that stores what was locked last
  std::uint64_t marks_of_ = 0;     ///< the number of the case whose labels they are
  std::shared_ptr<const segmentation::LabelStatistics> shown_statistics_;
  bool shown_hounsfield_ = true;
  std::shared_ptr<const Review> shown_review_;
};

}  // namespace glisson::ui
