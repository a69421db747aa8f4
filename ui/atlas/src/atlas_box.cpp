// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/atlas_box.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/engine/parts/proposals.h"
#include "glisson/ui/atlas/build_atlas_dialog.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

AtlasBox::AtlasBox(EngineBridge& engine, AtlasChoice& choice, QWidget* parent)
    : QWidget(parent), engine_(engine), choice_(choice) {
  setObjectName(QStringLiteral("atlas_box"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  name_ = make_explanation({}, this);
  name_->setObjectName(QStringLiteral("atlas_name"));
  row->addWidget(name_, 1);
  button_ = new QPushButton(tr("Atlas…"), this);
  button_->setObjectName(QStringLiteral("choose_atlas"));
  button_->setToolTip(tr("The livers that the landmarks are proposed from"));
  row->addWidget(button_);
  layout->addLayout(row);
  problem_ = make_warning(this);
  problem_->setObjectName(QStringLiteral("atlas_problem"));
  layout->addWidget(problem_);
  other_ = make_explanation({}, this);
  other_->setObjectName(QStringLiteral("atlas_other"));
  layout->addWidget(other_);
  auto* menu = new QMenu(this);
  const auto add = [&](const QString& text, const char* name, const std::function<void()>& act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QString::fromLatin1(name));
    connect(action, &QAction::triggered, this, act);
  };
  add(tr("Built-in atlas"), "built_in_atlas", [this] {
    refused_.clear();
    choice_.choose_built_in();
  });
  add(tr("Own atlas…"), "own_atlas", [this] { ask_for_folder(); });
  add(tr("Build from cases…"), "build_own_atlas", [this] { open_dialog(); });
  button_->setMenu(menu);
  connect(&choice_, &AtlasChoice::changed, this, &AtlasBox::show_state);
  connect(&engine_, &EngineBridge::case_changed, this, &AtlasBox::show_state);
  show_state();
}

BuildAtlasDialog* AtlasBox::dialog() const { return dialog_; }

void AtlasBox::ask_for_folder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of an atlas"),
                                                           QString::fromStdString(choice_.folder().string()));
  if (!folder.isEmpty()) choose(folder.toStdString());
}

void AtlasBox::choose(const std::filesystem::path& folder) {
  refused_.clear();
  choice_.choose(folder, refused_);
  show_state();
}

void AtlasBox::open_dialog() {
  if (!dialog_) {
    dialog_ = new BuildAtlasDialog(engine_, choice_, window());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog_, &BuildAtlasDialog::built, this, &AtlasBox::choose);
  }
  dialog_->show();
  dialog_->raise();
}

void AtlasBox::show_state() {
  const auto used = choice_.atlas();
  if (!used)
    name_->setText(tr("Atlas in %1").arg(QString::fromStdString(choice_.folder().filename().string())));
  else
    name_->setText(
        (choice_.is_built_in() ? tr("Built-in atlas '%1', %2 livers") : tr("Own atlas '%1', %2 livers"))
            .arg(QString::fromStdString(used->name))
            .arg(used->members.size()));
  name_->setToolTip(QString::fromStdString(choice_.folder().string()));
  QStringList problems;
  if (!choice_.problem().isEmpty())
    problems << tr("The chosen atlas cannot be used: choose it anew, another one, or the built-in atlas.")
             << choice_.problem();
  if (!refused_.isEmpty()) problems << refused_;
  show_warning(*problem_, problems.join(QLatin1Char('\n')));
  const auto& transfer = engine_.state()[part::proposals];
  const bool is_other = transfer && used && transfer->atlas != used->name;
  other_->setText(
      is_other
          ? tr("The proposals below are from the atlas '%1'.").arg(QString::fromStdString(transfer->atlas))
          : QString());
  other_->setVisible(is_other);
}

}  // namespace glisson::ui
