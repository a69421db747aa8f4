// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/linked_views.h"
#include "glisson/ui/model/angle_histogram.h"

class QCheckBox;
class QLabel;

namespace glisson::ui {

/// Names the labels that models are built from and that nobody has approved, a line for each review state;
/// empty: there are none.
QString unapproved_text(const engine::CaseState& state);

/// Whether the case has a model and it was built from its labels, and not from surfaces.
bool is_from_labels(const engine::CaseState& state);

/// What a person reads before trusting a model: what stands out, the figures, the angles; the worst elements
/// in three dimensions; and the person's word that it is right.
class QualitySheet : public QWidget {
  Q_OBJECT
 public:
  QualitySheet(EngineBridge& engine, LinkedViews& views, QWidget* parent = nullptr);

  /// Ends the view of the worst elements.
  void leave();
  QCheckBox* checked_box() const { return checked_; }
  QCheckBox* worst_box() const { return worst_; }

 private:
  void show_case();
  /// Whether the person can be asked now: not about a model that is being replaced.
  void show_tasks();
  void show_worst();
  /// What is worth a look, a line each.
  QStringList findings() const;
  /// Of them: how closely the mesh follows the organ.
  QStringList fit_findings() const;
  std::vector<std::pair<QString, QString>> mesh_rows() const;
  std::vector<std::pair<QString, QString>> structure_rows() const;  ///< lesions, and trees of vessels

  EngineBridge& engine_;
  LinkedViews& views_;
  QLabel* summary_;
  FiguresTable *figures_, *structures_;
  AngleHistogram* angles_;
  QCheckBox* worst_;
  QLabel* notes_;
  QLabel* review_;  ///< the labels that nobody has approved, beside the box that approves the model
  QCheckBox* checked_;
  std::shared_ptr<const model::BuiltModel> shown_;
};

}  // namespace glisson::ui
