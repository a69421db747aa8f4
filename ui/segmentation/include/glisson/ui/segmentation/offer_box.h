// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "glisson/engine/commands/decide_segmentation.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/view_state.h"

class QLabel;
class QPushButton;

namespace glisson::ui {

/// A new segmentation would replace what a hand has corrected: what it would change, in the slices and in
/// millilitres, and the decision. Visible while the case has such an offer.
class OfferBox : public QWidget {
  Q_OBJECT
 public:
  OfferBox(EngineBridge& engine, ViewState& views, QWidget* parent = nullptr);

  /// While it is not, nothing of it is drawn in the slices.
  void set_active(bool on);
  bool has_offer() const { return engine_.state()[part::offer] != nullptr; }

 signals:
  /// An offer has come, or gone.
  void changed();

 private:
  void build_legend();
  QPushButton* add_choice(const QString& text, const char* name, engine::DecideSegmentation::Choice choice);
  void decide(engine::DecideSegmentation::Choice choice);
  void show_case();
  void show_offer(const engine::SegmentationOffer& offer);
  void go_to_most();
  void show_in_views();

  EngineBridge& engine_;
  ViewState& views_;
  bool active_ = false;
  std::shared_ptr<const engine::SegmentationOffer> shown_;
  std::optional<engine::CommandId> deciding_;
  QLabel* text_ = nullptr;
  QLabel* hand_ = nullptr;
  QLabel* problem_ = nullptr;
  FiguresTable* figures_ = nullptr;
};

}  // namespace glisson::ui
