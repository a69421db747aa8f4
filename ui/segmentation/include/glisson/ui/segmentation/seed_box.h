// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <set>
#include <vector>

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/seed_book.h"

class QComboBox;
class QGridLayout;
class QListWidget;
class QPushButton;
class QScrollArea;

namespace glisson::ui {

class ClickBox;
class NetworkBox;
class NotesBox;
class RegionBox;

/// Seeds that are clicked in the slices, their list, and the growth from them.
class SeedBox : public QWidget {
  Q_OBJECT
 public:
  SeedBox(EngineBridge& engine, ViewState& views, QWidget* parent = nullptr);

  /// Seeds are drawn in the views, or not.
  void set_active(bool on);
  /// This page is shown, or that of the tools.
  void set_in_front(bool on);
  /// Clicks in the slices place seeds of this structure; none: they move the crosshair.
  void choose_structure(std::optional<Label> structure);
  const std::optional<Label>& structure() const { return structure_; }
  /// Labels that growth must leave as they are.
  void set_locked(const std::set<Label>& labels);
  /// Nobody here has the mouse any more.
  void let_go();
  /// Drops what the mouse has begun, else what it means. @return whether there was any of it.
  bool escape();
  /// What is told of the labels.
  NotesBox& notes() const { return *notes_; }

 signals:
  /// From now on clicks and drags in the slices are meant for the seeds or their region.
  void took_mouse();

 private:
  void build_structures();
  void build_seed_list();
  void connect_seed_list();
  void build_growth();
  void load_seeds();
  void save_seeds();
  /// The structures that can be seeded.
  std::vector<Label> choices() const;
  void show_case();
  /// From the case.
  void take_seeds();
  void show_seeds();
  void show_buttons();
  QPushButton* make_button(Label label);
  void show_markers();
  void place(const Point<CtFrame>& p);
  void draw_lesion(const SliceGesture& gesture);
  void store();
  void remove_selected();
  /// Takes all away; at once again puts them back.
  void clear_or_put_back();
  bool puts_back() const;
  segmentation::SegmentationOptions options() const;
  QString obstacle() const;
  /// Growth as it is set; where it would change what a hand has corrected, the person decides: after it
  /// (OfferBox), or before, where the labels are of another CT's voxels and no difference can be shown.
  std::optional<engine::Command> growth();
  /// Whether the labels lie on the voxels of the image. @pre both are there.
  bool labels_fit() const;

  EngineBridge& engine_;
  ViewState& views_;
  segmentation::Seeds seeds_;
  segmentation::Seeds cleared_;  ///< until there are others
  std::shared_ptr<const segmentation::Seeds> taken_;
  bool is_replaced_ = false;  ///< other seeds are on their way
  std::set<engine::CommandId> storing_;
  std::shared_ptr<const Image> image_;
  /// That have had seeds here: who deletes a seed to set a better one finds the lesion's number again.
  std::set<Label> known_lesions_;
  std::set<Label> locked_;
  bool replaces_hand_ = false;  ///< while the growth begins of which the person has said so
  bool active_ = false;
  std::optional<Label> structure_;
  std::vector<SeedEntry> entries_;
  std::optional<Point<CtFrame>> drawn_from_;  ///< one end of a lesion's diameter
  std::map<Label, QPushButton*> buttons_;
  QGridLayout* grid_ = nullptr;
  QScrollArea* lesions_ = nullptr;
  QGridLayout* lesion_grid_ = nullptr;
  TaskButton* propose_ = nullptr;
  QListWidget* list_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* clear_ = nullptr;
  QPushButton* load_ = nullptr;
  QPushButton* save_ = nullptr;
  ClickBox* correction_ = nullptr;
  QComboBox* what_ = nullptr;
  RegionBox* region_ = nullptr;
  TaskButton* run_ = nullptr;
  NotesBox* notes_ = nullptr;
  NetworkBox* network_ = nullptr;
};

}  // namespace glisson::ui
