// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <map>
#include <vector>

#include "glisson/ui/segmentation/edit_session.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace glisson::ui {

/// The settings of the chosen tool, and of no other.
class ToolPages : public QWidget {
  Q_OBJECT
 public:
  explicit ToolPages(EditSession& session, QWidget* parent = nullptr);

 private:
  using Get = std::function<double(const EditSettings&)>;
  using Set = std::function<void(EditSettings&, double)>;
  struct Range {
    double low, high, step;
    int decimals;
    QString unit;
  };

  QFormLayout* add_page(const std::vector<EditTool>& tools);
  QDoubleSpinBox* add_number(QFormLayout* form, const QString& name, const char* object, const Range& range,
                             const Get& get, const Set& set);
  void add_choice(QFormLayout* form, const QString& name, const char* object, const QStringList& choices,
                  const Get& get, const Set& set);
  void add_check(QFormLayout* form, const QString& text, const char* object, const Get& get, const Set& set);
  void add_labels(QFormLayout* form, const QString& name, const char* object, const Get& get, const Set& set);
  void build_brush();
  void build_scissors();
  void build_threshold();
  void build_shapes();
  void build_combinations();
  void build_mouse_tools();
  void change(const std::function<void(EditSettings&)>& how);
  void show_tool();
  void show_settings();

  EditSession& session_;
  std::map<EditTool, QWidget*> pages_;
  std::vector<std::function<void(const EditSettings&)>> refresh_;
};

}  // namespace glisson::ui
