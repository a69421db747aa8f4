// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/common/panel.h"

class QLabel;
class QPushButton;

namespace glisson::ui {

class AtlasChoice;
class ProposalReview;
class ShapeModes;

/// Review of the anatomical landmarks: what the atlas proposes; the anterior margin that was found is shown,
/// notch and vena cava are placed by clicking on the surface in three dimensions.
class AtlasPanel : public Panel {
  Q_OBJECT
 public:
  enum class Tool { none, notch, vena_cava };

  AtlasPanel(EngineBridge& engine, LinkedViews& views, ViewState& state, QWidget* parent = nullptr);

  void activate() override;
  void deactivate() override;
  void choose(Tool tool);
  const Landmarks& landmarks() const { return landmarks_; }

 signals:
  void landmarks_shown();

 private:
  /// @param points that it places, CT frame.
  QPushButton* add_tool(const QString& heading, const QString& explanation, QLabel*& state,
                        Points Landmarks::*points, Tool tool);
  void place(double x, double y);
  /// What has changed of these; of the others what the case has already, so that nothing is said to be placed
  /// that nobody has touched.
  void store(Points Landmarks::*points);
  /// All that is on the screen.
  void accept_all();
  void show_case();
  void show_landmarks();

  LinkedViews& views_;
  AtlasChoice* choice_ = nullptr;
  ProposalReview* review_ = nullptr;
  ShapeModes* modes_ = nullptr;
  Tool tool_ = Tool::none;
  std::set<Tool> begin_anew_;  ///< the next point of these takes the place of the model's own
  Landmarks landmarks_;        ///< effective ones, as on the screen
  Landmarks placed_;           ///< those of them that the case has as placed
  std::shared_ptr<const Landmarks> taken_;
  std::shared_ptr<const model::BuiltModel> model_;
  std::set<engine::CommandId> storing_;
  bool active_ = false;
  bool waits_ = false;  ///< for a new model: what is placed now would be taken for placed on that
  QLabel* margin_ = nullptr;
  QLabel* notch_ = nullptr;
  QLabel* cava_ = nullptr;
  QLabel* obstacle_ = nullptr;
  QPushButton* place_notch_ = nullptr;
  QPushButton* place_cava_ = nullptr;
  QPushButton* accept_ = nullptr;
};

}  // namespace glisson::ui
