// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/task_dialog.h"

#include <algorithm>

#include "glisson/ui/common/task_button.h"

namespace glisson::ui {

void TaskDialog::come_back_for(const TaskButton& task) {
  tasks_.push_back(&task);
  connect(&task, &TaskButton::done, this, &TaskDialog::show);
}

void TaskDialog::reject() {
  if (std::any_of(tasks_.begin(), tasks_.end(), [](const TaskButton* task) { return task->is_running(); }))
    hide();
  else
    QDialog::reject();
}

}  // namespace glisson::ui
