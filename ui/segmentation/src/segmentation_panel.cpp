// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/segmentation_panel.h"

#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QSlider>

#include "glisson/core/error.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

QString seed_name(Label label) {
  return label == structure::kBackground ? SegmentationPanel::tr("Not liver") : structure_text(label);
}

/// The structures that can be seeded, with as many lesions as there are and one more.
std::vector<Label> choices(const segmentation::Seeds& seeds) {
  std::vector<Label> labels = {structure::kParenchyma, structure::kPortalVein,  structure::kHepaticVeins,
                               structure::kVenaCava,   structure::kGallbladder, structure::kBackground};
  for (std::size_t i = 0; i <= seeds.lesions.size(); ++i)
    labels.push_back(static_cast<Label>(structure::kFirstLesion + i));
  return labels;
}

}  // namespace

SegmentationPanel::SegmentationPanel(EngineBridge& engine, ViewState& views, QWidget* parent)
    : Panel(engine, tr("Segmentation"),
            tr("Mark each structure with a few clicks in the slices, then grow them."), parent),
      views_(views) {
  setObjectName(QStringLiteral("segmentation_panel"));
  build_structures();
  build_seed_list();
  QVBoxLayout* grow = add_section(tr("Grow"));
  auto* form = new QFormLayout;
  spacing_ = new QDoubleSpinBox(this);
  spacing_->setRange(0.5, 5.0);
  spacing_->setSingleStep(0.5);
  spacing_->setDecimals(1);
  spacing_->setSuffix(tr(" mm"));
  spacing_->setValue(segmentation::SegmentationOptions{}.working_spacing_mm);
  spacing_->setToolTip(tr("Resolution at which the liver's surface evolves. Finer is slower."));
  form->addRow(tr("Resolution"), spacing_);
  grow->addLayout(form);
  run_ = new TaskButton(
      engine, tr("Segment"),
      [this]() -> std::optional<engine::Command> {
        choose_structure(std::nullopt);
        engine::Segment command;
        command.options.working_spacing_mm = spacing_->value();
        return command;
      },
      this);
  run_->setObjectName(QStringLiteral("segment"));
  grow->addWidget(run_);
  notes_ = make_explanation({}, this);
  notes_->hide();
  grow->addWidget(notes_);

  QVBoxLayout* look = add_section(tr("Result"));
  figures_ = new FiguresTable(this);
  look->addWidget(figures_);
  auto* opacity = new QSlider(Qt::Horizontal, this);
  opacity->setRange(0, 100);
  opacity->setValue(static_cast<int>(100 * views.style().label_opacity));
  auto* row = new QFormLayout;
  row->addRow(tr("Label opacity"), opacity);
  look->addLayout(row);
  auto* import = new QPushButton(tr("Import labels…"), this);
  look->addWidget(import);

  connect(opacity, &QSlider::valueChanged, this,
          [this](int value) { views_.set_label_opacity(value / 100.0); });
  connect(import, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Import labels"), {},
                                                      tr("Labels (*.nrrd *.nii *.nii.gz *.mha *.mhd *.vti)"));
    if (!path.isEmpty()) this->engine().post(engine::ImportLabels{path.toStdString(), {}});
  });
  connect(&this->engine(), &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (outcome.status != engine::Status::done || outcome.command != "segment") return;
    notes_->setText(notes_text(outcome.notes));
    notes_->setVisible(!outcome.notes.empty());
  });
  connect(&views_, &ViewState::picked, this, &SegmentationPanel::place);
  connect(&this->engine(), &EngineBridge::case_changed, this, &SegmentationPanel::show_case);
  connect(&this->engine(), &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (storing_.erase(outcome.id) > 0 && storing_.empty()) show_case();
  });
  watch(engine::Part::labels, {"segment", "import_labels"});
  show_case();
}

void SegmentationPanel::build_structures() {
  QVBoxLayout* box =
      add_section(tr("Seeds"), tr("Choose a structure, then click it in a slice. Esc ends placing."));
  grid_ = new QGridLayout;
  grid_->setSpacing(4);
  box->addLayout(grid_);
  auto* escape = new QShortcut(Qt::Key_Escape, this);
  escape->setContext(Qt::WindowShortcut);
  connect(escape, &QShortcut::activated, this, [this] { choose_structure(std::nullopt); });
}

void SegmentationPanel::build_seed_list() {
  list_ = new QListWidget(this);
  list_->setObjectName(QStringLiteral("seed_list"));
  list_->setFixedHeight(110);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  content()->addWidget(list_);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  remove_ = new QPushButton(tr("Delete"), this);
  remove_->setObjectName(QStringLiteral("delete_seeds"));
  clear_ = new QPushButton(tr("Clear"), this);
  auto* load = new QPushButton(tr("Load…"), this);
  save_ = new QPushButton(tr("Save…"), this);
  int cell = 0;
  for (QPushButton* button : {remove_, clear_, load, save_}) {
    buttons->addWidget(button, cell / 2, cell % 2);
    ++cell;
  }
  content()->addLayout(buttons);
  auto* key = new QShortcut(Qt::Key_Delete, list_);
  key->setContext(Qt::WidgetShortcut);
  connect(key, &QShortcut::activated, this, &SegmentationPanel::remove_selected);
  connect(remove_, &QPushButton::clicked, this, &SegmentationPanel::remove_selected);
  connect(list_, &QListWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!list_->selectedItems().isEmpty()); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row_number) {
    if (row_number >= 0 && row_number < static_cast<int>(entries_.size()))
      views_.set_crosshair(Point<CtFrame>(entries_[static_cast<std::size_t>(row_number)].p_in_ct));
  });
  connect(clear_, &QPushButton::clicked, this, [this] {
    seeds_ = {};
    store();
  });
  connect(load, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Load seeds"), {}, tr("Seeds (*.json)"));
    if (path.isEmpty()) return;
    try {
      seeds_ = segmentation::read_seeds(path.toStdString());
      store();
    } catch (const Error& error) {
      QMessageBox::warning(this, tr("Load seeds"), QString::fromStdString(error.what()));
    }
  });
  connect(save_, &QPushButton::clicked, this, [this] {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save seeds"), {}, tr("Seeds (*.json)"));
    if (path.isEmpty()) return;
    try {
      segmentation::write_seeds(path.toStdString(), seeds_);
    } catch (const Error& error) {
      QMessageBox::warning(this, tr("Save seeds"), QString::fromStdString(error.what()));
    }
  });
}

void SegmentationPanel::activate() {
  active_ = true;
  show_markers();
}

void SegmentationPanel::deactivate() {
  choose_structure(std::nullopt);
  active_ = false;
  show_markers();  // they would lie over what the other steps show
}

void SegmentationPanel::choose_structure(std::optional<Label> structure) {
  structure_ = structure;
  for (const auto& [label, button] : buttons_) button->setChecked(structure == label);
  views_.set_hand(structure ? Hand::point : Hand::crosshair);
}

void SegmentationPanel::place(const Point<CtFrame>& p) {
  if (!structure_) return;
  add_seed(seeds_, *structure_, p.xyz);
  store();
}

void SegmentationPanel::remove_selected() {
  std::vector<SeedEntry> gone;
  for (const QListWidgetItem* item : list_->selectedItems())
    gone.push_back(entries_[static_cast<std::size_t>(list_->row(item))]);
  // From behind, so that rows and lesions that move up do not shift what is still to go.
  std::sort(gone.begin(), gone.end(), [](const SeedEntry& a, const SeedEntry& b) {
    return std::pair(a.structure, a.row) > std::pair(b.structure, b.row);
  });
  for (const SeedEntry& entry : gone) remove_seed(seeds_, entry);
  if (!gone.empty()) store();
}

void SegmentationPanel::store() {
  storing_.insert(engine().post(engine::SetSeeds{seeds_}));
  show_seeds();
}

void SegmentationPanel::show_case() {
  // While own edits are on their way the panel is ahead of the case.
  if (storing_.empty() && engine().state().seeds != taken_) {
    taken_ = engine().state().seeds;
    seeds_ = taken_ ? *taken_ : segmentation::Seeds{};
  }
  show_volumes();
  show_seeds();
}

void SegmentationPanel::show_seeds() {
  entries_ = list_seeds(seeds_);
  const int chosen = list_->currentRow();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const SeedEntry& entry : entries_) {
      QStringList place;
      for (int axis = 0; axis < 3; ++axis)
        place << QString::fromStdString(scene::anatomical_coordinate(axis, entry.p_in_ct[axis]));
      list_->addItem(new QListWidgetItem(
          structure_icon(entry.structure),
          QStringLiteral("%1   %2").arg(seed_name(entry.structure), place.join(QStringLiteral("  ")))));
    }
    list_->setCurrentRow(std::min(chosen, list_->count() - 1));
  }
  const std::vector<Label> labels = choices(seeds_);
  int cell = 0;
  for (const Label label : labels) {
    QPushButton*& button = buttons_[label];
    if (button == nullptr) {
      button = new QPushButton(this);
      button->setCheckable(true);
      button->setProperty("role", "choice");
      button->setIcon(structure_icon(label));
      button->setObjectName(QStringLiteral("seed_%1").arg(QString::fromStdString(structure_name(label))));
      connect(button, &QPushButton::clicked, this,
              [this, label](bool on) { choose_structure(on ? std::optional(label) : std::nullopt); });
    }
    const int count = count_seeds(seeds_, label);
    button->setText(count > 0 ? QStringLiteral("%1 (%2)").arg(seed_name(label)).arg(count)
                              : seed_name(label));
    button->setEnabled(engine().state().image != nullptr);
    button->show();
    grid_->addWidget(button, cell / 2, cell % 2);
    ++cell;
  }
  for (const auto& [label, button] : buttons_)
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) button->hide();
  show_markers();
  remove_->setEnabled(!list_->selectedItems().isEmpty());
  for (QPushButton* button : {clear_, save_}) button->setEnabled(!entries_.empty());
  run_->set_obstacle(obstacle());
}

void SegmentationPanel::show_markers() {
  std::vector<scene::Marker> markers;
  if (active_)
    for (const SeedEntry& entry : entries_) markers.push_back({entry.p_in_ct, entry.structure, 3e-3});
  views_.set_markers(std::move(markers));
}

void SegmentationPanel::show_volumes() {
  const auto& labels = engine().state().labels;
  if (labels == measured_) return;
  measured_ = labels;
  std::vector<std::pair<QString, QString>> rows;
  if (labels) {
    const std::vector<long> voxels = labels->voxels.histogram();
    const double voxel_ml = 1e-3 * labels->voxels.grid().spacing_mm.prod();
    for (std::size_t label = 1; label < voxels.size(); ++label)
      if (voxels[label] > 0)
        rows.emplace_back(structure_text(static_cast<Label>(label)),
                          tr("%1 ml").arg(voxel_ml * static_cast<double>(voxels[label]), 0, 'f', 1));
  }
  figures_->set_rows(rows);
  if (!labels) notes_->hide();
}

QString SegmentationPanel::obstacle() const {
  if (!engine().state().image) return tr("Open a CT first.");
  if (seeds_.liver.rows() == 0) return tr("Place at least one seed in the liver.");
  return {};
}

}  // namespace glisson::ui
