// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/label_meanings.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <set>

#include "glisson/patient/segment_meaning.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

enum Column { name, volume, meaning, column_count };

/// What a label can be said to be; any lesion stands for all.
constexpr std::array kMeanings = {structure::kParenchyma, structure::kPortalVein, structure::kHepaticVeins,
                                  structure::kVenaCava,   structure::kArtery,     structure::kGallbladder,
                                  structure::kFirstLesion};

/// The wheel scrolls the list: a choice that comes under the pointer on the way does not turn with it.
class StillComboBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

QIcon icon_of(const LabelInfo& info) {
  QPixmap picture(12, 12);
  picture.fill(QColor::fromRgbF(static_cast<float>(info.colour[0]), static_cast<float>(info.colour[1]),
                                static_cast<float>(info.colour[2])));
  return picture;
}

}  // namespace

bool FoundLabels::must_be_asked() const {
  if (labels.empty()) return false;  // nobody could say anything
  return are_numbers || std::ranges::none_of(labels, [](const FoundLabel& label) {
           return label.meaning == structure::kParenchyma;
         });
}

LabelCodes FoundLabels::meanings() const {
  LabelCodes codes;
  for (const FoundLabel& label : labels)
    if (label.meaning) codes[label.info.code] = *label.meaning;
  return codes;
}

FoundLabels found_labels(const LabelFile& file, bool is_own) {
  const bool are_others = !is_own && std::ranges::any_of(file.infos, is_named_otherwise);
  const LabelCodes meant = are_others ? codes_meant(file.infos) : LabelCodes();
  FoundLabels found;
  found.summary = LabelSummary(file.voxels);
  for (const Label code : found.summary.labels()) {
    FoundLabel label;
    label.info.code = code;
    label.ml = found.summary.ml(code);
    const auto info = std::ranges::find(file.infos, label.info.code, &LabelInfo::code);
    if (info != file.infos.end()) label.info = *info;
    const bool is_number = !is_own && is_nameless(label.info);
    if (meant.contains(label.info.code))
      label.meaning = meant.at(label.info.code);
    else if (!are_others && !is_number)
      label.meaning = label.info.code;
    found.are_numbers = found.are_numbers || (is_number && !are_others);
    found.labels.push_back(label);
  }
  return found;
}

LabelMeanings::LabelMeanings(FoundLabels found, const QString& file, QWidget* parent)
    : QDialog(parent), found_(std::move(found)) {
  setObjectName(QStringLiteral("label_meanings"));
  setWindowTitle(tr("Import labels"));
  auto* column = new QVBoxLayout(this);
  auto* text = new QLabel(tr("%1 does not say what each label is. Say it here; what you leave out becomes "
                             "background.")
                              .arg(file),
                          this);
  text->setTextFormat(Qt::PlainText);
  text->setWordWrap(true);
  column->addWidget(text);
  list_ = new QTreeWidget(this);
  list_->setObjectName(QStringLiteral("found_labels"));
  list_->setColumnCount(column_count);
  list_->setHeaderLabels({tr("Label in the file"), tr("Volume"), tr("Is")});
  list_->setRootIsDecorated(false);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->setFocusPolicy(Qt::NoFocus);  // the keyboard goes from choice to choice
  for (const FoundLabel& label : found_.labels) add_row(label);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(name, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(volume, QHeaderView::ResizeToContents);
  list_->setColumnWidth(meaning, 190);
  column->addWidget(list_, 1);
  missing_ = make_warning(this);
  missing_->setText(tr("Say which one is the liver."));
  QSizePolicy keeps_its_place = missing_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);  // the buttons below do not jump
  missing_->setSizePolicy(keeps_its_place);
  column->addWidget(missing_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  import_ = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
  import_->setObjectName(QStringLiteral("import_meanings"));
  if (found_.are_numbers) {
    QPushButton* numbers = buttons->addButton(tr("As Glisson numbers them"), QDialogButtonBox::ActionRole);
    numbers->setObjectName(QStringLiteral("take_numbers"));
    numbers->setAutoDefault(false);
    numbers->setToolTip(
        tr("For files that Glisson has written without names: 1 is the liver, 2 the portal "
           "vein, from 16 on lesions. Other programs number otherwise."));
    connect(numbers, &QPushButton::clicked, this, &LabelMeanings::take_numbers);
  }
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  show_state();
  resize(600, 420);
}

void LabelMeanings::add_row(const FoundLabel& label) {
  auto* row = new QTreeWidgetItem(list_);
  const QString number = QString::number(label.info.code);
  row->setIcon(name, icon_of(label.info));
  row->setText(name, is_nameless(label.info)
                         ? number
                         : QStringLiteral("%1  %2").arg(number, QString::fromStdString(label.info.name)));
  row->setToolTip(name, row->text(name));
  row->setText(volume, tr("%1 ml").arg(label.ml, 0, 'f', 1));
  row->setTextAlignment(volume, Qt::AlignRight | Qt::AlignVCenter);
  auto* choice = new StillComboBox(list_);
  choice->setObjectName(QStringLiteral("meaning_%1").arg(number));
  choice->setAccessibleName(row->text(name));
  choice->addItem(tr("Not imported"), 0);
  for (const Label one : kMeanings)
    choice->addItem(structure_icon(one), is_lesion(one) ? tr("Lesion") : structure_text(one), one);
  choices_.push_back(choice);
  if (label.meaning)
    choice->setCurrentIndex(
        std::max(0, choice->findData(is_lesion(*label.meaning) ? structure::kFirstLesion : *label.meaning)));
  list_->setItemWidget(row, meaning, choice);
  connect(choice, &QComboBox::currentIndexChanged, this, &LabelMeanings::show_state);
}

void LabelMeanings::take_numbers() {
  by_numbers_ = true;
  for (std::size_t n = 0; n < choices_.size(); ++n) {
    const Label code = found_.labels[n].info.code;
    choices_[n]->setCurrentIndex(
        std::max(0, choices_[n]->findData(is_lesion(code) ? structure::kFirstLesion : code)));
  }
}

LabelCodes LabelMeanings::codes() const {
  LabelCodes codes;
  std::set<Label> taken;
  std::vector<Label> lesions;
  for (std::size_t n = 0; n < choices_.size(); ++n) {
    const Label code = found_.labels[n].info.code,
                said = static_cast<Label>(choices_[n]->currentData().toUInt());
    if (said == structure::kBackground) continue;
    if (!is_lesion(said)) {
      codes[code] = said;
    } else if (by_numbers_ && is_lesion(code)) {
      codes[code] = code;
      taken.insert(code);
    } else {
      lesions.push_back(code);
    }
  }
  Label free = structure::kFirstLesion;
  for (const Label code : lesions) {
    while (taken.contains(free)) ++free;
    if (free > structure::kLastLesion) break;  // there are no numbers for more
    codes[code] = free++;
  }
  return codes;
}

void LabelMeanings::show_state() {
  const bool is_said = std::ranges::any_of(choices_, [](const QComboBox* choice) {
    return choice->currentData().toUInt() == structure::kParenchyma;
  });
  missing_->setVisible(!is_said);
  import_->setEnabled(is_said);
}

}  // namespace glisson::ui
