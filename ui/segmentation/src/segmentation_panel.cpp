// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/segmentation_panel.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>

#include "glisson/engine/commands/set_locks.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/review.h"
#include "glisson/patient/label_place.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/bridge_list.h"
#include "glisson/ui/segmentation/edit_box.h"
#include "glisson/ui/segmentation/edit_texts.h"
#include "glisson/ui/segmentation/label_import.h"
#include "glisson/ui/segmentation/notes_box.h"
#include "glisson/ui/segmentation/offer_box.h"
#include "glisson/ui/segmentation/seed_box.h"

namespace glisson::ui {
namespace {

constexpr int kEye = 600;  ///< milliseconds: a double click ends within 400, and an eye needs 200 to come

}  // namespace

SegmentationPanel::SegmentationPanel(EngineBridge& engine, ViewState& views, QWidget* parent)
    : Panel(engine, tr("Segmentation"),
            tr("Grow the structures from a few clicks, then correct them by hand."), parent),
      views_(views),
      session_(new EditSession(engine, views, this)) {
  setObjectName(QStringLiteral("segmentation_panel"));
  build_modes();
  offer_ = new OfferBox(engine, views, this);
  content()->addWidget(offer_);
  seeds_ = new SeedBox(engine, views, this);
  content()->addWidget(seeds_);
  build_labels();
  edit_ = new EditBox(*session_, *this, this);
  edit_->add_below_settings(new BridgeList(*session_, engine, views, edit_));
  content()->addWidget(edit_);
  show_offer();
  show_editing(false);
  connect(add_attention(tr("Shows what is told of this segmentation")), &QPushButton::clicked, this,
          &SegmentationPanel::go_to_notes);
  connect(&seeds_->notes(), &NotesBox::changed, this, &SegmentationPanel::show_notes);
  connect(&seeds_->notes(), &NotesBox::place_chosen, &views_, &ViewState::set_crosshair);
  show_notes();
  connect(offer_, &OfferBox::changed, this, &SegmentationPanel::show_offer);
  auto* escape = new QShortcut(Qt::Key_Escape, this);
  connect(escape, &QShortcut::activated, this, [this] {
    if (!seeds_->escape()) session_->escape();
  });
  connect(seeds_, &SeedBox::took_mouse, this, [this] { session_->set_tool(nullptr); });
  connect(session_, &EditSession::tool_changed, this, [this] {
    if (session_->tool() == nullptr) return;
    seeds_->let_go();
    show_editing(true);
  });
  connect(session_, &EditSession::settings_changed, this, &SegmentationPanel::show_label);
  connect(&this->engine(), &EngineBridge::case_changed, this, &SegmentationPanel::show_case);
  // Undo is the labels', even while a number has the keyboard.
  for (QAbstractSpinBox* number : findChildren<QAbstractSpinBox*>()) number->installEventFilter(this);
  watch(part::labels,
        [](const engine::CaseState& state) { return !engine::unapproved_labels(state).empty(); });
  show_case();
}

bool SegmentationPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();
      return true;
    }
  }
  return Panel::eventFilter(watched, event);
}

void SegmentationPanel::build_modes() {
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  seeds_mode_ = new QPushButton(tr("Seeds and growth"), this);
  seeds_mode_->setObjectName(QStringLiteral("mode_seeds"));
  edit_mode_ = new QPushButton(tr("Review and edit"), this);
  edit_mode_->setObjectName(QStringLiteral("mode_edit"));
  for (QPushButton* button : {seeds_mode_, edit_mode_}) {
    button->setCheckable(true);
    button->setProperty("role", "mode");
    row->addWidget(button, 1);
  }
  content()->addLayout(row);
  connect(seeds_mode_, &QPushButton::clicked, this, [this] {
    session_->set_tool(nullptr);
    show_editing(false);
  });
  connect(edit_mode_, &QPushButton::clicked, this, [this] {
    seeds_->let_go();
    show_editing(true);
  });
}

void SegmentationPanel::show_editing(bool on) {
  seeds_mode_->setChecked(!on);
  edit_mode_->setChecked(on);
  seeds_->set_in_front(!on && !offer_->has_offer());
  edit_->setVisible(on && !offer_->has_offer());
}

void SegmentationPanel::show_offer() {
  // An edit or a new seed would let the offer go: first comes the decision.
  const bool waits = offer_->has_offer();
  if (waits) {
    session_->set_tool(nullptr);
    seeds_->let_go();
  }
  for (QPushButton* mode : {seeds_mode_, edit_mode_}) mode->setEnabled(!waits);
  show_import();
  show_editing(edit_mode_->isChecked());
}

void SegmentationPanel::show_notes() {
  const std::size_t notes = seeds_->notes().count();
  call_attention(notes > 0 ? tr("Notes to read: %1").arg(notes) : QString());
}

void SegmentationPanel::go_to_notes() {
  show_editing(false);
  QTimer::singleShot(0, this, [this] {  // laid out by then
    for (QWidget* above = parentWidget(); above != nullptr; above = above->parentWidget())
      if (auto* scroll = qobject_cast<QScrollArea*>(above))
        return scroll->ensureWidgetVisible(&seeds_->notes(), 0, 0);
  });
}

void SegmentationPanel::build_labels() {
  auto* column = new QVBoxLayout;
  column->setSpacing(5);
  table_ = new LabelTable(this);
  column->addWidget(table_);
  figures_ = make_explanation({}, this);
  figures_->setObjectName(QStringLiteral("label_figures"));
  figures_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  figures_->ensurePolished();
  figures_->setText(QStringLiteral("X\nX"));
  figures_->setFixedHeight(figures_->sizeHint().height());  // the tools below keep their place
  column->addWidget(figures_);
  auto* row = new QHBoxLayout;
  approve_ = new QPushButton(tr("Approve"), this);
  approve_->setObjectName(QStringLiteral("approve_label"));
  approve_->setProperty("role", "small");
  approve_->setToolTip(tr(
      "You have looked at the chosen label and it is right: the next one comes. An edit takes that back."));
  import_ = new QPushButton(tr("Import…"), this);
  import_->setObjectName(QStringLiteral("import_labels"));
  import_->setProperty("role", "small");
  auto* opacity = new QSlider(Qt::Horizontal, this);
  opacity->setRange(0, 100);
  opacity->setValue(static_cast<int>(100 * views_.style().label_opacity));
  opacity->setToolTip(tr("Opacity of the labels in the slices"));
  opacity->setAccessibleName(opacity->toolTip());
  row->addWidget(approve_);
  row->addWidget(import_);
  row->addWidget(opacity, 1);
  column->addLayout(row);
  content()->addLayout(column);
  connect(opacity, &QSlider::valueChanged, this,
          [this](int value) { views_.set_label_opacity(value / 100.0); });
  importer_ = new LabelImport(engine(), this);
  connect(importer_, &LabelImport::reading_changed, this, &SegmentationPanel::show_import);
  connect(import_, &QPushButton::clicked, this, &SegmentationPanel::ask_for_labels);
  connect(approve_, &QPushButton::clicked, this, &SegmentationPanel::approve);
  connect(table_, &LabelTable::label_chosen, this, [this](Label label) {
    EditSettings next = session_->settings();
    next.label = label;
    session_->set_settings(next);
  });
  connect(table_, &LabelTable::shown_toggled, this, [this](Label label) { toggle(hidden_, label); });
  connect(table_, &LabelTable::lock_toggled, this, [this](Label label) {
    toggle(locked_, label);
    if (engine().state()[part::image]) locking_ = engine().post(engine::SetLocks{locked_});
  });
  connect(table_, &LabelTable::review_chosen, session_, &EditSession::set_review);
}

void SegmentationPanel::toggle(std::set<Label>& labels, Label label) {
  if (labels.erase(label) == 0) labels.insert(label);
  take_marks();
}

void SegmentationPanel::take_marks() {
  table_->set_marks(hidden_, locked_);
  views_.set_hidden({hidden_.begin(), hidden_.end()});
  seeds_->set_locked(locked_);
  EditSettings next = session_->settings();
  next.region.locked = {locked_.begin(), locked_.end()};
  session_->set_settings(next);
}

void SegmentationPanel::ask_for_labels() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Import labels"), {}, tr("Labels (*.nrrd *.dcm *.nii *.nii.gz *.mha *.mhd *.vti)"));
  if (!path.isEmpty()) import_labels(path.toStdString());
}

void SegmentationPanel::import_labels(const std::filesystem::path& path) { importer_->start(path); }

void SegmentationPanel::show_import() {
  const bool waits = offer_->has_offer();
  import_->setEnabled(!waits && !importer_->is_reading());
  import_->setToolTip(
      waits ? tr("A new segmentation waits: decide about it first, imported labels would take its place.")
            : tr("Labels that were made elsewhere: DICOM segmentation, .seg.nrrd, NIfTI"));
}

void SegmentationPanel::approve() {
  const Label approved = session_->settings().label;
  session_->set_review(approved, ReviewState::approved);
  // A button that is switched off passes the keyboard on, to "Import".
  const bool had_keyboard = approve_->hasFocus();
  if (had_keyboard) table_->setFocus();
  if (session_->tool() == nullptr) look_at_next(approved, had_keyboard);
}

void SegmentationPanel::look_at_next(Label approved, bool had_keyboard) {
  std::set<Label> open;
  for (const auto& [review, labels] : engine::unapproved_labels(engine().state()))
    open.insert(labels.begin(), labels.end());
  open.erase(approved);
  if (open.empty()) return;
  const auto after = open.upper_bound(approved);
  const Label next = after != open.end() ? *after : *open.begin();
  if (const auto place = place_of(engine().state()[part::labels]->voxels, next)) views_.set_crosshair(*place);
  // A second click of the same hand is not for what nobody has seen yet.
  waits_for_eye_ = true;
  QTimer::singleShot(kEye, this, [this, had_keyboard] {
    waits_for_eye_ = false;
    show_label();
    if (had_keyboard && table_->hasFocus()) approve_->setFocus();
  });
  EditSettings settings = session_->settings();
  settings.label = next;
  session_->set_settings(settings);
  show_label();
}

void SegmentationPanel::activate() {
  views_.set_shows_labels(true);
  seeds_->set_active(true);
  offer_->set_active(true);
  session_->set_active(true);
}

void SegmentationPanel::deactivate() {
  session_->set_active(false);
  offer_->set_active(false);
  seeds_->set_active(false);  // they would lie over what the other steps show
  views_.set_shows_labels(false);
}

void SegmentationPanel::choose_structure(std::optional<Label> structure) {
  seeds_->choose_structure(structure);
}

QList<QAction*> SegmentationPanel::history_actions() const {
  return {edit_->undo_action(), edit_->redo_action()};
}

void SegmentationPanel::show_case() {
  const engine::CaseState& now = engine().state();
  if (const std::uint64_t number = engine().snapshot()->case_number; number != marks_of_) {
    marks_of_ = number;
    hidden_.clear();  // another patient's lesion is not hidden because one of the former was
    locked_ = engine::locked_in(now);
    seeds_->let_go();
    EditSettings next = session_->settings();
    next.region = {};
    if (is_lesion(next.label)) next.label = structure::kParenchyma;
    session_->set_settings(next);
    take_marks();
  }
  // While own ones are on their way the panel is ahead of the case.
  if (const std::set<Label> locked = engine::locked_in(now);
      locked != locked_ && !engine().is_busy(locking_)) {
    locked_ = locked;
    take_marks();
  }
  if (now[part::statistics] != shown_statistics_ || now[part::review] != shown_review_ ||
      session_->shows_hounsfield() != shown_hounsfield_ || table_->topLevelItemCount() == 0) {
    shown_hounsfield_ = session_->shows_hounsfield();
    shown_statistics_ = now[part::statistics];
    shown_review_ = now[part::review];
    show_rows();
  }
  show_label();
}

void SegmentationPanel::show_rows() {
  table_->set_rows(label_rows(shown_statistics_.get(), shown_review_.get(), session_->settings().label),
                   session_->shows_hounsfield());
}

void SegmentationPanel::show_label() {
  const Label label = session_->settings().label;
  // What the tools work on is never another label than the row that is chosen.
  if (table_->row_of(label) == nullptr) show_rows();
  table_->choose(label);
  const auto& statistics = engine().state()[part::statistics];
  const bool counted =
      statistics && statistics->figures().count(label) > 0 && statistics->figures().at(label).voxels > 0;
  const auto& review = engine().state()[part::review];
  const bool approved = review && review->count(label) > 0 && review->at(label) == ReviewState::approved;
  approve_->setEnabled(counted && !approved && !waits_for_eye_);
  approve_->setText(approved ? tr("Approved") : tr("Approve"));
  if (!counted) {
    figures_->setText(tr("%1: nothing yet").arg(structure_text(label)));
    return;
  }
  const segmentation::LabelFigures& figures = statistics->figures().at(label);
  const QStringList parts = {tr("%1 ml").arg(figures.ml, 0, 'f', 1),
                             intensity_text(figures, session_->shows_hounsfield())};
  QString text = tr("%1: %2").arg(structure_text(label), parts.join(QStringLiteral(", ")));
  if (is_lesion(label))
    text += QLatin1Char('\n') + tr("longest diameter %1 mm").arg(figures.longest_diameter_mm, 0, 'f', 1);
  figures_->setText(text);
}

}  // namespace glisson::ui
