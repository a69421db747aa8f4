// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/seed_box.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QVBoxLayout>
#include <memory>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/engine/commands/propose_seeds.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/save_name.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/click_box.h"
#include "glisson/ui/segmentation/growth_choices.h"
#include "glisson/ui/segmentation/hand_work_question.h"
#include "glisson/ui/segmentation/network_box.h"
#include "glisson/ui/segmentation/notes_box.h"
#include "glisson/ui/segmentation/region_box.h"
#include "glisson/ui/segmentation/slice_circle.h"

namespace glisson::ui {
namespace {

constexpr int kColumns = 2;     ///< of buttons
constexpr int kLesionRows = 2;  ///< in sight; more are scrolled to
constexpr int kGap = 4;         ///< pixels between buttons

QString seed_name(Label label) {
  return label == structure::kBackground ? SeedBox::tr("Not liver") : structure_text(label);
}

/// In the slice of a gesture; metres.
std::shared_ptr<const SliceLine> circle_of(const SliceGesture& gesture, const Eigen::Vector3d& middle,
                                           double radius, Label label) {
  constexpr int kCorners = 48;
  const int normal = scene::normal_axis(gesture.slice.plane);
  return line_of({middle, radius, Eigen::Vector3d::Unit((normal + 1) % 3),
                  Eigen::Vector3d::Unit((normal + 2) % 3), kCorners},
                 gesture, label);
}

QVBoxLayout* column_of(QWidget* widget) { return static_cast<QVBoxLayout*>(widget->layout()); }

/// Put where it is already it would have the whole window laid out and painted again.
void put_button(QGridLayout* grid, int cell, int columns, QPushButton* button) {
  const QLayoutItem* there = grid->itemAtPosition(cell / columns, cell % columns);
  if (there == nullptr || there->widget() != button) grid->addWidget(button, cell / columns, cell % columns);
}

}  // namespace

SeedBox::SeedBox(EngineBridge& engine, ViewState& views, QWidget* parent)
    : QWidget(parent), engine_(engine), views_(views) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  build_structures();
  build_seed_list();
  connect_seed_list();
  build_growth();
  connect(&views_, &ViewState::picked, this, &SeedBox::place);
  connect(&views_, &ViewState::gestured, this, &SeedBox::draw_lesion);
  connect(&engine_, &EngineBridge::case_changed, this, &SeedBox::show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (storing_.erase(outcome.id) == 0 || !storing_.empty()) return;
    take_seeds();  // those of the case, also where what was stored did not come to it
    show_case();
  });
  connect(&engine_, &EngineBridge::tasks_changed, this, [this] {
    if (is_replaced_ == is_being_replaced(engine_, part::seeds)) return;
    is_replaced_ = !is_replaced_;
    if (is_replaced_) let_go();
    show_buttons();
  });
  connect(propose_, &TaskButton::done, this, [this](const engine::Outcome& outcome) {
    if (outcome.status == engine::Status::done) notes_->show_proposal(outcome.notes);
  });
  show_case();
}

void SeedBox::build_structures() {
  column_of(this)->addWidget(make_explanation(
      tr("Choose a structure, then click it in a slice; across a lesion you can also drag, to tell its "
         "diameter. Esc ends placing."),
      this));
  grid_ = new QGridLayout;
  grid_->setSpacing(kGap);
  column_of(this)->addLayout(grid_);
  // However many lesions there are, what lies below keeps its place.
  lesions_ = new QScrollArea(this);
  lesions_->setObjectName(QStringLiteral("seed_lesions"));
  lesions_->setFrameShape(QFrame::NoFrame);
  lesions_->setWidgetResizable(true);
  lesions_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget(lesions_);
  auto* rows = new QVBoxLayout(inside);
  rows->setContentsMargins(0, 0, 0, 0);
  lesion_grid_ = new QGridLayout;
  lesion_grid_->setSpacing(kGap);
  for (int column = 0; column < kColumns; ++column) lesion_grid_->setColumnStretch(column, 1);
  rows->addLayout(lesion_grid_);
  rows->addStretch(1);
  lesions_->setWidget(inside);
  column_of(this)->addWidget(lesions_);
}

void SeedBox::build_seed_list() {
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("seed_list"));
  list_->setFixedHeight(84);
  list_->setHorizontalScrollBarPolicy(
      Qt::ScrollBarAlwaysOff);  // three rows are in sight, whatever their length
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  column_of(this)->addWidget(list_);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  remove_ = new QPushButton(tr("Delete"), this);
  remove_->setObjectName(QStringLiteral("delete_seeds"));
  clear_ = new QPushButton(tr("Clear"), this);
  clear_->setObjectName(QStringLiteral("clear_seeds"));
  load_ = new QPushButton(tr("Load…"), this);
  save_ = new QPushButton(tr("Save…"), this);
  int cell = 0;
  for (QPushButton* button : {remove_, clear_, load_, save_}) {
    button->setProperty("role", "small");
    buttons->addWidget(button, 0, cell++);
  }
  column_of(this)->addLayout(buttons);
}

void SeedBox::connect_seed_list() {
  auto* key = new QShortcut(Qt::Key_Delete, list_);
  key->setContext(Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, this, &SeedBox::remove_selected);
  connect(remove_, &QPushButton::clicked, this, &SeedBox::remove_selected);
  connect(list_, &QListWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!list_->selectedItems().isEmpty()); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row_number) {
    if (row_number >= 0 && row_number < static_cast<int>(entries_.size()))
      views_.set_crosshair(Point<CtFrame>(entries_[static_cast<std::size_t>(row_number)].p_in_ct));
  });
  connect(clear_, &QPushButton::clicked, this, &SeedBox::clear_or_put_back);
  connect(load_, &QPushButton::clicked, this, &SeedBox::load_seeds);
  connect(save_, &QPushButton::clicked, this, &SeedBox::save_seeds);
}

void SeedBox::load_seeds() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Load seeds"), {}, tr("Seeds (*.json)"));
  if (path.isEmpty()) return;
  try {
    seeds_ = segmentation::read_seeds(path.toStdString());
    known_lesions_.clear();
    store();
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Load seeds"), error_text(error.what()));
  }
}

void SeedBox::save_seeds() {
  const QString path =
      ask_where_to_save(this, tr("Save seeds"), {}, tr("Seeds (*.json)"), {QStringLiteral(".json")});
  if (path.isEmpty()) return;
  try {
    segmentation::write_seeds(path.toStdString(), seeds_);
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save seeds"), error_text(error.what()));
  }
}

void SeedBox::build_growth() {
  correction_ = new ClickBox(engine_, this);
  column_of(this)->addWidget(correction_);
  auto* form = new QFormLayout;
  what_ = make_narrow_combo(this);
  what_->setObjectName(QStringLiteral("find_anew"));
  for (const Find& find : finds()) what_->addItem(find.text);
  what_->setToolTip(tr("What is found anew. All else stays as it is, with everything that you edited."));
  form->addRow(tr("Find anew"), what_);
  column_of(this)->addLayout(form);
  region_ = new RegionBox(views_, this);
  column_of(this)->addWidget(region_);
  connect(region_, &RegionBox::drawing_started, this, [this] {
    choose_structure(std::nullopt);
    emit took_mouse();
  });
  connect(region_, &RegionBox::changed, this, [this] { run_->set_obstacle(obstacle()); });
  run_ = new TaskButton(
      engine_, tr("Segment"), [this] { return growth(); }, this);
  run_->setObjectName(QStringLiteral("segment"));
  run_->reserve_lines();
  column_of(this)->addWidget(run_);
  // Below: what it says moves nothing that is on its way to be clicked.
  propose_ = new TaskButton(
      engine_, tr("Propose the liver"), [] { return engine::Command(engine::ProposeSeeds{}); }, this);
  propose_->setObjectName(QStringLiteral("propose_seeds"));
  propose_->setToolTip(tr("Looks for the liver without a click in it: seeds that you can delete or add to."));
  propose_->watch(engine::ProposeSeeds{});
  column_of(this)->addWidget(propose_);
  notes_ = new NotesBox(engine_, this);
  column_of(this)->addWidget(notes_);
  network_ = new NetworkBox(engine_, this);
  column_of(this)->addWidget(network_);
  column_of(this)->addStretch(1);
  connect(what_, &QComboBox::currentIndexChanged, this, [this] { run_->set_obstacle(obstacle()); });
}

std::optional<engine::Command> SeedBox::growth() {
  let_go();
  engine::Segment command{options(), engine::OverHandWork::offer};
  if (replaces_hand_) {
    command.over_hand_work = engine::OverHandWork::replace;
  } else if (const auto edited = command.would_replace(engine_.state());
             !edited.empty() && !command.keeps_labels() && !labels_fit()) {
    const auto replace = [this] {
      replaces_hand_ = true;
      run_->trigger();
      replaces_hand_ = false;  // what could not begin is asked for again
    };
    ask_over_hand_work(window(), edited,
                       tr("Your corrections lie on the voxels of another CT: what would change cannot be "
                          "shown. The new segmentation takes the place of all labels, and they are lost."),
                       replace);
    return {};
  }
  return command;
}

bool SeedBox::labels_fit() const {
  const auto& state = engine_.state();
  return state[part::labels]->voxels.grid().same_as(state[part::image]->grid);
}

segmentation::SegmentationOptions SeedBox::options() const {
  segmentation::SegmentationOptions options;
  options.working_spacing_mm = region_->resolution_mm();
  options.region = region_->region();
  options.structures = finds()[static_cast<std::size_t>(what_->currentIndex())].structures;
  options.locked = {locked_.begin(), locked_.end()};
  return options;
}

void SeedBox::set_locked(const std::set<Label>& labels) {
  locked_ = labels;
  correction_->set_locked(labels);
  network_->set_locked(labels);
  run_->set_obstacle(obstacle());
}

void SeedBox::set_active(bool on) {
  if (!on) let_go();
  active_ = on;
  region_->set_active(active_ && !isHidden());
  show_markers();
}

void SeedBox::set_in_front(bool on) {
  setVisible(on);
  region_->set_active(active_ && on);
}

void SeedBox::choose_structure(std::optional<Label> structure) {
  if (!structure && !structure_) return;
  structure_ = structure;
  for (const auto& [label, button] : buttons_) button->setChecked(structure == label);
  if (structure && is_lesion(*structure) && buttons_.contains(*structure))
    lesions_->ensureWidgetVisible(buttons_[*structure], 0, 0);
  if (structure) {  // whoever has the mouse lets go
    region_->set_drawing(false);
    emit took_mouse();
  }
  drawn_from_.reset();
  views_.set_line(nullptr);
  views_.set_hand(!structure ? Hand::crosshair : is_lesion(*structure) ? Hand::span : Hand::point);
}

void SeedBox::let_go() {
  choose_structure(std::nullopt);
  region_->set_drawing(false);
}

bool SeedBox::escape() {
  if (region_->escape()) return true;
  if (drawn_from_) {
    drawn_from_.reset();
    views_.set_line(nullptr);
    return true;
  }
  if (!structure_) return false;
  choose_structure(std::nullopt);
  return true;
}

void SeedBox::place(const Point<CtFrame>& p) {
  if (!structure_) return;
  add_seed(seeds_, *structure_, p.xyz);
  store();
  correction_->correct(*structure_, p, seeds_);
}

void SeedBox::draw_lesion(const SliceGesture& gesture) {
  if (!structure_ || views_.hand() != Hand::span) return;
  if (gesture.phase == SliceGesture::Phase::begin) drawn_from_ = gesture.p;
  if (!drawn_from_) return;
  const Eigen::Vector3d middle = 0.5 * (drawn_from_->xyz + gesture.p.xyz);
  const double mm =
      std::min(1e3 * (gesture.p.xyz - drawn_from_->xyz).norm(), segmentation::Seeds::kMostDiameter);
  const bool drawn = mm >= segmentation::Seeds::kLeastDiameter;
  views_.set_line(drawn ? circle_of(gesture, middle, 0.5e-3 * mm, *structure_) : nullptr);
  if (gesture.phase != SliceGesture::Phase::end) return;
  drawn_from_.reset();
  views_.set_line(nullptr);
  const Eigen::Vector3d clicked = drawn ? middle : gesture.p.xyz;
  add_seed(seeds_, *structure_, clicked);
  if (drawn) set_diameter(seeds_, *structure_, mm);
  store();
  correction_->correct(*structure_, Point<CtFrame>(clicked), seeds_);
}

void SeedBox::remove_selected() {
  std::vector<SeedEntry> gone;
  for (const QListWidgetItem* item : list_->selectedItems())
    gone.push_back(entries_[static_cast<std::size_t>(list_->row(item))]);
  // From behind, so that rows that move up do not shift what is still to go.
  std::sort(gone.begin(), gone.end(), [](const SeedEntry& a, const SeedEntry& b) {
    return std::pair(a.structure, a.row) > std::pair(b.structure, b.row);
  });
  for (const SeedEntry& entry : gone) remove_seed(seeds_, entry);
  if (!gone.empty()) store();
}

bool SeedBox::puts_back() const { return entries_.empty() && !list_seeds(cleared_).empty(); }

void SeedBox::clear_or_put_back() {
  const bool back = puts_back();
  std::swap(seeds_, cleared_);
  if (!back) seeds_ = {};  // what was cleared before is gone
  store();
}

void SeedBox::store() {
  storing_.insert(engine_.post(engine::SetSeeds{seeds_}));
  show_seeds();
}

void SeedBox::show_case() {
  if (engine_.state()[part::image] != image_) {
    image_ = engine_.state()[part::image];
    known_lesions_.clear();
    cleared_ = {};
    drawn_from_.reset();
  }
  // While own edits are on their way the box is ahead of the case.
  if (storing_.empty() && engine_.state()[part::seeds] != taken_) take_seeds();
  if (seeds_.liver.rows() == 0) notes_->forget_proposal();
  show_buttons();
}

void SeedBox::take_seeds() {
  taken_ = engine_.state()[part::seeds];
  seeds_ = taken_ ? *taken_ : segmentation::Seeds{};
  show_seeds();
}

void SeedBox::show_seeds() {
  entries_ = list_seeds(seeds_);
  if (!entries_.empty()) cleared_ = {};
  for (const SeedEntry& entry : entries_)
    if (is_lesion(entry.structure)) known_lesions_.insert(entry.structure);
  const int chosen = list_->currentRow();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const SeedEntry& entry : entries_) {
      QStringList place;
      for (int axis = 0; axis < 3; ++axis)
        place << QString::fromStdString(scene::anatomical_coordinate(axis, entry.p_in_ct[axis]));
      QString text = QStringLiteral("%1 · %2").arg(seed_name(entry.structure)).arg(entry.row + 1);
      if (entry.diameter_mm > 0.0)
        text += QStringLiteral("   ") + tr("⌀ %1 mm").arg(qRound(entry.diameter_mm));
      list_->addItem(
          new QListWidgetItem(structure_icon(entry.structure),
                              QStringLiteral("%1   %2").arg(text, place.join(QStringLiteral("  ")))));
    }
    list_->setCurrentRow(std::min(chosen, list_->count() - 1));
  }
  show_markers();
  show_buttons();
}

std::vector<Label> SeedBox::choices() const {
  std::vector<Label> labels = {structure::kParenchyma, structure::kPortalVein,  structure::kHepaticVeins,
                               structure::kVenaCava,   structure::kGallbladder, structure::kBackground};
  std::set<Label> lesions = lesions_to_seed(seeds_, engine_.state()[part::statistics].get());
  lesions.insert(known_lesions_.begin(), known_lesions_.end());
  if (structure_ && is_lesion(*structure_)) lesions.insert(*structure_);
  labels.insert(labels.end(), lesions.begin(), lesions.end());
  return labels;
}

QPushButton* SeedBox::make_button(Label label) {
  QWidget* parent = this;
  if (is_lesion(label)) parent = lesions_->widget();
  auto* button = new QPushButton(parent);
  button->setCheckable(true);
  button->setProperty("role", "choice");
  button->setIcon(structure_icon(label));
  button->setObjectName(QStringLiteral("seed_%1").arg(QString::fromStdString(structure_name(label))));
  connect(button, &QPushButton::clicked, this,
          [this, label](bool on) { choose_structure(on ? std::optional(label) : std::nullopt); });
  return button;
}

void SeedBox::show_buttons() {
  const std::vector<Label> labels = choices();
  int cell = 0, lesion_cell = 0;
  for (const Label label : labels) {
    QPushButton*& button = buttons_[label];
    if (button == nullptr) button = make_button(label);
    const int count = count_seeds(seeds_, label);
    button->setText(count > 0 ? QStringLiteral("%1 (%2)").arg(seed_name(label)).arg(count)
                              : seed_name(label));
    button->setEnabled(engine_.state()[part::image] && !is_replaced_);
    button->show();
    if (is_lesion(label))
      put_button(lesion_grid_, lesion_cell++, kColumns, button);
    else
      put_button(grid_, cell++, kColumns, button);
  }
  for (const auto& [label, button] : buttons_)
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) button->hide();
  lesions_->setFixedHeight(kLesionRows * buttons_[structure::kParenchyma]->sizeHint().height() +
                           (kLesionRows - 1) * kGap);
  // Where the bar comes to stand there is room for it from the first lesion on.
  const bool bar = lesion_cell > kLesionRows * kColumns;
  lesions_->setVerticalScrollBarPolicy(bar ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
  lesion_grid_->setContentsMargins(0, 0, bar ? 0 : lesions_->verticalScrollBar()->sizeHint().width(), 0);
  list_->setEnabled(!is_replaced_);
  remove_->setEnabled(!is_replaced_ && !list_->selectedItems().isEmpty());
  load_->setEnabled(!is_replaced_);
  save_->setEnabled(!entries_.empty());
  clear_->setEnabled(!is_replaced_ && (!entries_.empty() || puts_back()));
  clear_->setText(puts_back() ? tr("Put back") : tr("Clear"));
  run_->set_obstacle(obstacle());
}

void SeedBox::show_markers() {
  std::vector<scene::Marker> markers;
  if (active_)
    for (const SeedEntry& entry : entries_) markers.push_back({entry.p_in_ct, entry.structure, 3e-3});
  views_.set_markers(std::move(markers));
}

QString SeedBox::obstacle() const {
  engine::CaseState now = engine_.state();
  // Those that are on their way come before what is pressed next.
  if (!storing_.empty()) now[part::seeds] = std::make_shared<const segmentation::Seeds>(seeds_);
  const engine::Segment command{options(), engine::OverHandWork::offer};
  if (const auto first = engine::obstacle(now, command)) return obstacle_text(first);
  const auto hindrance = command.hindrance(now);
  return hindrance ? hindrance_text(*hindrance) : QString();
}

}  // namespace glisson::ui
