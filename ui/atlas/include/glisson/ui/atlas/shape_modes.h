// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "glisson/ui/atlas/atlas_choice.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/scene/proposal_actors.h"

class QComboBox;
class QLabel;
class QPushButton;
class QShortcut;
class QSlider;

namespace glisson::ui {

/// How livers differ: the atlas' mean liver in the 3D view over the patient's, bent by one of its first modes
/// as far as a slider says, with the structures on it. Leaving it gives the patient's view back.
class ShapeModes : public QWidget {
  Q_OBJECT
 public:
  /// @param choice the atlas whose modes they are
  ShapeModes(EngineBridge& engine, LinkedViews& views, AtlasChoice& choice, QWidget* parent = nullptr);

  /// The panel comes to the front, or leaves it: then nothing is shown any more.
  void set_active(bool active);
  bool is_shown() const { return shown_; }
  void leave() { show_modes(false); }
  int actor_count() const { return actors_.actor_count(); }

 signals:
  void shown_changed(bool shown);

 private:
  void make_controls();
  void add_key(const QKeySequence& key, const std::function<void()>& act);
  void show_case();
  void show_modes(bool on);
  /// The chosen one, and what its modes are called.
  void take_atlas();
  void draw();

  EngineBridge& engine_;
  LinkedViews& views_;
  AtlasChoice& choice_;
  scene::ProposalActors actors_;
  std::shared_ptr<const atlas::Atlas> atlas_;
  bool active_ = false, shown_ = false;
  QPushButton* toggle_ = nullptr;
  QShortcut* toggle_key_ = nullptr;
  std::vector<QShortcut*> keys_;  ///< while it is shown
  QWidget* controls_ = nullptr;
  QComboBox* mode_ = nullptr;
  QSlider* deviations_ = nullptr;
  QLabel* caption_ = nullptr;  ///< in the 3D view
};

}  // namespace glisson::ui
