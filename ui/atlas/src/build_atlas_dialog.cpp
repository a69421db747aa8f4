// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/atlas/build_atlas_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/ui/common/atlas_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr int kWidth = 460, kListHeight = 150;  // pixels

/// How far off each structure was on a liver that had no part in it.
QStringList expectations(const atlas::BuildResult& built) {
  std::map<atlas::Structure, std::pair<double, int>> sums;
  for (const atlas::LeftOut& left : built.left_out)
    for (const auto& [structure, found] : left.structures) {
      sums[structure].first += found.mean_error;
      ++sums[structure].second;
    }
  QStringList lines;
  for (const auto& [structure, sum] : sums)
    lines << BuildAtlasDialog::tr("%1: off by %2 mm on average where the others foretell it")
                 .arg(landmark_text(structure))
                 .arg(1e3 * sum.first / sum.second, 0, 'f', 1);
  return lines;
}

}  // namespace

BuildAtlasDialog::BuildAtlasDialog(EngineBridge& engine, AtlasChoice& choice, QWidget* parent)
    : TaskDialog(parent), choice_(choice) {
  setObjectName(QStringLiteral("build_atlas"));
  setWindowTitle(tr("Build an atlas"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(make_explanation(
      tr("Of your own cases, five at least, with a model and reviewed landmarks. What a case only took "
         "over from an atlas is no evidence and stays out. It takes some seconds a liver."),
      this));
  layout->addLayout(make_cases());
  layout->addLayout(make_place());
  build_ = new TaskButton(
      engine, tr("Build"),
      [this]() -> std::optional<engine::Command> {
        asked_out_ = command().out;
        notes_->clear();
        return engine::Command(command());
      },
      this);
  build_->setObjectName(QStringLiteral("build_atlas_task"));
  build_->setMinimumWidth(kWidth);
  layout->addWidget(build_);
  notes_ = new QLabel(this);
  notes_->setObjectName(QStringLiteral("build_atlas_notes"));
  notes_->setWordWrap(true);
  layout->addWidget(notes_);
  layout->addStretch(1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  come_back_for(*build_);
  connect(build_, &TaskButton::done, this, &BuildAtlasDialog::show_outcome);
  connect(&choice_, &AtlasChoice::changed, this, &BuildAtlasDialog::show_state);
  show_state();
}

QLayout* BuildAtlasDialog::make_cases() {
  auto* layout = new QVBoxLayout;
  cases_ = new QListWidget(this);
  cases_->setObjectName(QStringLiteral("atlas_cases"));
  cases_->setAccessibleName(tr("Cases"));
  cases_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  cases_->setMinimumHeight(kListHeight);
  layout->addWidget(cases_);
  auto* row = new QHBoxLayout;
  auto* add = new QPushButton(tr("Add case or folder…"), this);
  auto* remove = new QPushButton(tr("Remove"), this);
  remove->setObjectName(QStringLiteral("remove_atlas_case"));
  row->addWidget(add, 1);
  row->addWidget(remove);
  layout->addLayout(row);
  const auto choice = [&](const char* name, const QString& words, const QString& tip) {
    auto* box = new QCheckBox(words, this);
    box->setObjectName(QLatin1String(name));
    box->setToolTip(tip);
    layout->addWidget(box);
    return box;
  };
  unapproved_ = choice("atlas_unapproved", tr("Cases whose labels nobody has approved, too"), QString());
  keep_shape_ = choice("atlas_keep_shape", tr("Keep the mean liver, and learn places alone"),
                       tr("Where structures lie on the mean liver of the chosen atlas: suits few cases"));
  summed_ = choice("atlas_summed", tr("Keep nothing of single cases"),
                   tr("Of structures means and mean squares alone, without the cases' names"));
  connect(add, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("A case, or a folder of cases"));
    if (!folder.isEmpty()) add_cases(folder);
  });
  connect(remove, &QPushButton::clicked, this, [this] {
    qDeleteAll(cases_->selectedItems());
    show_state();
  });
  return layout;
}

QLayout* BuildAtlasDialog::make_place() {
  auto* form = new QFormLayout;
  name_ = new QLineEdit(tr("own"), this);
  name_->setObjectName(QStringLiteral("atlas_new_name"));
  form->addRow(tr("Name"), name_);
  auto* row = new QHBoxLayout;
  folder_ = new QLineEdit(this);
  folder_->setObjectName(QStringLiteral("atlas_new_folder"));
  folder_->setPlaceholderText(tr("a new folder"));
  auto* choose = new QPushButton(tr("Choose…"), this);
  row->addWidget(folder_, 1);
  row->addWidget(choose);
  form->addRow(tr("Kept in"), row);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getSaveFileName(this, tr("Folder for the atlas"));
    if (!folder.isEmpty()) keep_in(folder);
  });
  for (QLineEdit* line : {name_, folder_})
    connect(line, &QLineEdit::textChanged, this, &BuildAtlasDialog::show_state);
  return form;
}

void BuildAtlasDialog::add_cases(const QString& folder) {
  if (cases_->findItems(folder, Qt::MatchExactly).isEmpty()) cases_->addItem(folder);
  show_state();
}

void BuildAtlasDialog::keep_in(const QString& folder) { folder_->setText(folder); }

engine::BuildAtlas BuildAtlasDialog::command() const {
  engine::BuildAtlas build;
  for (int row = 0; row < cases_->count(); ++row)
    build.cases.emplace_back(cases_->item(row)->text().toStdString());
  build.base = choice_.atlas();
  build.options.name = name_->text().trimmed().toStdString();
  build.out = folder_->text().trimmed().toStdString();
  build.unapproved = unapproved_->isChecked();
  build.options.keep_shape = keep_shape_->isChecked();
  build.options.summed = summed_->isChecked();
  return build;
}

void BuildAtlasDialog::show_state() {
  if (build_ == nullptr) return;
  build_->set_obstacle(!choice_.problem().isEmpty()          ? tr("Choose an atlas to build on first.")
                       : cases_->count() == 0                ? tr("Add your cases first.")
                       : name_->text().trimmed().isEmpty()   ? tr("Give the atlas a name.")
                       : folder_->text().trimmed().isEmpty() ? tr("Name a folder to keep it in.")
                                                             : QString());
}

void BuildAtlasDialog::show_outcome(const engine::Outcome& outcome) {
  const auto made = outcome.result.as<atlas::BuildResult>();
  if (outcome.status != engine::Status::done || !made) return;
  QStringList lines = expectations(*made);
  if (!outcome.notes.empty()) lines << notes_text(outcome.notes);
  notes_->setText(lines.join(QLatin1Char('\n')));
  emit built(asked_out_);
}

}  // namespace glisson::ui
