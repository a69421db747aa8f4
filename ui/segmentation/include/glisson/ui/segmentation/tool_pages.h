// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <map>
#include <vector>

#include "glisson/ui/segmentation/edit_session.h"

namespace glisson::ui {

/// The settings of the chosen tool, and of no other: made of the tools' descriptions.
class ToolPages : public QWidget {
  Q_OBJECT
 public:
  explicit ToolPages(EditSession& session, QWidget* parent = nullptr, const EditTools& tools = edit_tools());

 private:
  void add_page(EditTool tool);
  QWidget* make(const PageField& field);
  QWidget* make_number(const PageField& field);
  QWidget* make_slider(const PageField& field);
  QWidget* make_choice(const PageField& field);
  QWidget* make_check(const PageField& field);
  QWidget* make_labels(const PageField& field);
  QWidget* make_button(const PageField& field);
  QString suffix_of(const std::string& unit) const;
  void change(const std::function<void(EditSettings&)>& how);
  void show_tool();
  void show_settings();

  EditSession& session_;
  const EditTools tools_;
  std::map<EditTool, QWidget*> pages_;
  std::vector<std::function<void(const EditSettings&)>> refresh_;
};

}  // namespace glisson::ui
