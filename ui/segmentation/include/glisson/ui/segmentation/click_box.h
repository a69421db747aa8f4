// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <set>

#include "glisson/segmentation/segment.h"
#include "glisson/ui/common/engine_bridge.h"

class QCheckBox;
class QLabel;

namespace glisson::ui {

/// Whether a click corrects labels that are there, at once (the liver's, its veins', a lesion's), and what
/// the last one did.
class ClickBox : public QWidget {
  Q_OBJECT
 public:
  explicit ClickBox(EngineBridge& engine, QWidget* parent = nullptr);

  /// Corrects around a click, if that is chosen and there are labels that it may change.
  /// @param structure that was clicked; background: what is not liver. @param seeds the click's own among
  /// them.
  void correct(Label structure, const Point<CtFrame>& p_in_ct, const segmentation::Seeds& seeds);
  /// Labels that a click must leave as they are.
  void set_locked(const std::set<Label>& labels) { locked_ = labels; }

 private:
  /// @return whether this click is to correct labels now; else it is said why not.
  bool corrects(Label structure);
  void tell(const engine::Outcome& outcome);

  EngineBridge& engine_;
  std::set<Label> locked_;
  std::set<engine::CommandId> waiting_;
  QStringList told_;                    ///< errors and notes of the clicks since none was waiting
  std::shared_ptr<const Image> image_;  ///< that the words are about
  QCheckBox* at_once_;
  QLabel* words_;
};

}  // namespace glisson::ui
