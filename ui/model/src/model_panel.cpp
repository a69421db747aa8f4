// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/model_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/common/unit_question.h"
#include "glisson/ui/model/tissue_box.h"
#include "glisson/ui/scene/model_surfaces.h"

namespace glisson::ui {
namespace {

constexpr double kFiner = 0.5;  // edge length over that elsewhere, where finer elements are asked for

}  // namespace

ModelPanel::ModelPanel(EngineBridge& engine, LinkedViews& views, QWidget* parent)
    : Panel(engine, tr("Model"), tr("A mesh of the liver with its vessels, ready for mechanics."), parent),
      views_(views) {
  setObjectName(QStringLiteral("model_panel"));
  build_options();
  QVBoxLayout* result = add_section(tr("Quality"));
  quality_ = new QualitySheet(engine, views_, this);
  result->addWidget(quality_);
  build_trees();
  build_tissue();
  build_trial();
  build_look();
  // One hand in the 3D view at a time.
  connect(trees_, &TreeEditor::began, this, [this] {
    trial_->end();
    quality_->leave();
  });
  connect(quality_->worst_box(), &QCheckBox::toggled, this, [this](bool on) {
    if (on) trees_->leave();
  });
  connect(trial_->button(), &QPushButton::toggled, this, [this](bool on) {
    if (on) trees_->leave();
  });
  connect(&this->engine(), &EngineBridge::case_changed, this, &ModelPanel::show_case);
  watch(part::model);
  show_case();
}

void ModelPanel::build_options() {
  QVBoxLayout* build = add_section(tr("Build from the labels"));
  auto* form = new QFormLayout;
  size_by_ = new QComboBox(this);
  size_by_->setObjectName(QStringLiteral("mesh_size_by"));
  size_by_->addItems({tr("Vertices"), tr("Edge length")});
  size_by_->setToolTip(
      tr("More vertices, or shorter edges, follow the organ more closely and compute more slowly."));
  vertices_ = new QSpinBox(this);
  vertices_->setRange(100, 5000);
  vertices_->setSingleStep(50);
  vertices_->setValue(model::MeshOptions{}.target_vertices);
  edge_ = new NumberBox(this);
  edge_->setRange(6.0, 40.0);
  edge_->setDecimals(1);
  edge_->setSuffix(tr(" mm"));
  edge_->setValue(18.0);
  edge_->hide();
  auto* size = new QHBoxLayout;
  size->addWidget(size_by_);
  size->addWidget(vertices_, 1);
  size->addWidget(edge_, 1);
  form->addRow(tr("Mesh size"), size);
  connect(size_by_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int by) {
    vertices_->setVisible(by == 0);
    edge_->setVisible(by == 1);
  });
  fine_lesions_ = new QCheckBox(tr("Finer at lesions"), this);
  fine_lesions_->setObjectName(QStringLiteral("fine_lesions"));
  fine_vessels_ = new QCheckBox(tr("Finer at vessels"), this);
  fine_vessels_->setObjectName(QStringLiteral("fine_vessels"));
  for (QCheckBox* box : {fine_lesions_, fine_vessels_})
    box->setToolTip(tr("Edges half as long there; with a number of vertices, longer ones elsewhere."));
  auto* finer = new QHBoxLayout;
  finer->addWidget(fine_lesions_);
  finer->addWidget(fine_vessels_);
  form->addRow(finer);
  vessels_ = new QCheckBox(tr("Portal and hepatic vessels stiffen the model"), this);
  vessels_->setChecked(true);
  form->addRow(vessels_);
  beams_ = new QSpinBox(this);
  beams_->setObjectName(QStringLiteral("model_beams"));
  beams_->setRange(20, 2000);
  beams_->setSingleStep(20);
  beams_->setValue(model::ModelOptions{}.target_beams);
  beams_->setToolTip(
      tr("Where the vessels have more, the thinnest and shortest side branches are left out; entrances and "
         "vessels of 4 mm across and more stay. More beams compute more slowly."));
  form->addRow(tr("Beams"), beams_);
  connect(vessels_, &QCheckBox::toggled, beams_, &QWidget::setEnabled);
  build->addLayout(form);
  review_ = make_warning(this);
  review_->setObjectName(QStringLiteral("build_review"));
  build->addWidget(review_);
  run_ = new TaskButton(
      engine(), tr("Build model"),
      [this] {
        engine::BuildModel checked = command();
        checked.atlas = built_in_atlas_if_any();
        return engine::Command(std::move(checked));
      },
      this);
  run_->setObjectName(QStringLiteral("build_model"));
  build->addWidget(run_);
  auto* import = new QPushButton(tr("From surfaces…"), this);
  auto* ways = new QMenu(import);
  ways->addAction(tr("A folder, files named by structure…"), this, [this] {
    import_in_a_unit(QFileDialog::getExistingDirectory(this, tr("Folder of surfaces, named by structure")));
  });
  ways->addAction(tr("A list of files (JSON)…"), this, [this] {
    import_surfaces(
        QFileDialog::getOpenFileName(this, tr("List of surfaces"), {}, tr("List of surfaces (*.json)")));
  });
  ways->addAction(tr("One surface of the liver…"), this, [this] {
    import_in_a_unit(QFileDialog::getOpenFileName(this, tr("Surface of the liver"), {},
                                                  tr("Surfaces (*.stl *.obj *.ply *.vtk *.vtp)")));
  });
  import->setMenu(ways);
  build->addWidget(import);
}

QWidget* ModelPanel::make_part(const QString& heading, const QString& explanation) {
  auto* part = new QWidget(this);
  auto* layout = new QVBoxLayout(part);
  layout->setContentsMargins(0, 6, 0, 0);
  layout->setSpacing(5);
  auto* label = new QLabel(heading, part);
  label->setProperty("role", "heading");
  layout->addWidget(label);
  layout->addWidget(make_explanation(explanation, part));
  content()->addWidget(part);
  return part;
}

void ModelPanel::build_trees() {
  trees_section_ = make_part(
      tr("Vessel trees"), tr("The centrelines that stiffen the model. Each tree is held where it enters."));
  trees_ = new TreeEditor(engine(), views_, trees_section_);
  trees_section_->layout()->addWidget(trees_);
}

void ModelPanel::build_tissue() {
  tissue_section_ =
      make_part(tr("Stiffness"), tr("Young's modulus. Trial, registration and what is simulated for it go by "
                                    "it; a registration made before is out of date then."));
  tissue_section_->layout()->addWidget(new TissueBox(engine(), tissue_section_));
}

void ModelPanel::build_trial() {
  trial_section_ =
      make_part(tr("Mechanics"), tr("Drag a point of the liver and see it follow with its vessels and "
                                    "lesions. It is held at the vena cava and "
                                    "where vessels enter; its neighbours are not modelled. A trial: the "
                                    "case stays as it is. Esc ends it."));
  trial_ = new LoadTrialBox(engine(), views_, trial_section_);
  trial_section_->layout()->addWidget(trial_);
}

void ModelPanel::deactivate() {
  trial_->end();
  trees_->leave();
  quality_->leave();
}

void ModelPanel::build_look() {
  look_ = new QWidget(this);
  auto* layout = new QVBoxLayout(look_);
  layout->setContentsMargins(0, 6, 0, 0);
  layout->setSpacing(5);
  auto* heading = new QLabel(tr("3D view"), look_);
  heading->setProperty("role", "heading");
  layout->addWidget(heading);
  structures_ = new QVBoxLayout;
  structures_->setSpacing(3);
  layout->addLayout(structures_);
  auto* mesh = new QCheckBox(tr("Mesh"), look_);
  layout->addWidget(mesh);
  auto* opacity = new QSlider(Qt::Horizontal, look_);
  opacity->setRange(0, 100);
  opacity->setValue(35);
  auto* form = new QFormLayout;
  form->addRow(tr("Liver opacity"), opacity);
  layout->addLayout(form);
  content()->addWidget(look_);
  connect(mesh, &QCheckBox::toggled, this, [this](bool on) {
    views_.volume().patient().set_mesh_visible(on);
    views_.volume().update();
  });
  connect(opacity, &QSlider::valueChanged, this, [this](int value) {
    views_.volume().patient().set_opacity(structure::kParenchyma, value / 100.0);
    views_.volume().update();
  });
}

engine::BuildModel ModelPanel::command() const {
  engine::BuildModel command;
  if (size_by_->currentIndex() == 0)
    command.options.mesh.target_vertices = vertices_->value();
  else
    command.options.mesh.edge_mm = edge_->value();
  if (fine_lesions_->isChecked()) command.options.mesh.lesion_refinement = kFiner;
  if (fine_vessels_->isChecked()) command.options.mesh.vessel_refinement = kFiner;
  command.options.vessels = vessels_->isChecked();
  command.options.target_beams = beams_->value();
  return command;
}

void ModelPanel::import_in_a_unit(const QString& path) {
  if (path.isEmpty()) return;
  ask_unit(this, path.toStdString(), [this, path](LengthUnit unit) { import_surfaces(path, unit); });
}

void ModelPanel::import_surfaces(const QString& path, LengthUnit unit) {
  if (path.isEmpty()) return;  // a list says its units itself, else it is in millimetres
  engine::ImportSurfaces command;
  command.path = path.toStdString();
  command.unit = unit;
  command.options = this->command().options;
  command.atlas = built_in_atlas_if_any();
  engine().post(command);
}

void ModelPanel::show_case() {
  const engine::CaseState& now = engine().state();
  run_->set_obstacle(obstacle_text(engine::obstacle(now, command())));
  // Once there is a model of theirs, they are named where it is approved.
  show_warning(*review_, is_from_labels(now) ? QString() : unapproved_text(now));
  if (now[part::model] == shown_ && shown_) return;
  shown_ = now[part::model];
  look_->setVisible(shown_ != nullptr);
  tissue_section_->setVisible(shown_ != nullptr);
  trial_section_->setVisible(shown_ != nullptr);
  if (!shown_) trial_->end();
  trees_section_->setVisible(shown_ && !(shown_->model.vessels.empty() && shown_->tree_edits.empty()));
  if (shown_) show_structures();
}

void ModelPanel::show_structures() {
  while (QLayoutItem* item = structures_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  std::vector<Label> labels = {structure::kParenchyma};
  for (const Label label : scene::inner_structures(shown_->model)) labels.push_back(label);
  for (const Label label : {structure::kVenaCava, structure::kGallbladder})
    if (scene::structure_surface(shown_->model, label).triangle_count() > 0) labels.push_back(label);
  for (const Label label : labels) {
    auto* box = new QCheckBox(structure_text(label), look_);
    box->setIcon(structure_icon(label));
    box->setChecked(true);
    structures_->addWidget(box);
    views_.volume().patient().set_visible(label, true);
    connect(box, &QCheckBox::toggled, this, [this, label](bool on) {
      views_.volume().patient().set_visible(label, on);
      views_.volume().update();
    });
  }
}

}  // namespace glisson::ui
