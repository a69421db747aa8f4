// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "glisson/core/frames.h"
#include "glisson/ui/common/engine_bridge.h"

class QLabel;

namespace glisson::ui {

/// What is told of the case's labels, however they came about and whenever the case was opened; while a new
/// segmentation is offered, of that one. Notes that tell a place have a link to it.
class NotesBox : public QWidget {
  Q_OBJECT
 public:
  explicit NotesBox(EngineBridge& engine, QWidget* parent = nullptr);

  /// What is told of proposed seeds comes first, until labels are made of them, or there is another CT or no
  /// seed.
  void show_proposal(const std::vector<std::string>& notes);
  void forget_proposal() { show_proposal({}); }
  /// How many are told.
  std::size_t count() const { return told_.size(); }

 signals:
  void changed();
  void place_chosen(const Point<CtFrame>& place);

 private:
  void show_case();
  QString words() const;

  EngineBridge& engine_;
  std::shared_ptr<const Image> image_;
  std::shared_ptr<const LabelMap> labels_;
  std::vector<std::string> proposal_;
  QLabel* words_ = nullptr;
  std::vector<std::string> told_;
};

}  // namespace glisson::ui
