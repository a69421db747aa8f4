// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/model_panel.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <map>

#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/model_surfaces.h"

namespace glisson::ui {

ModelPanel::ModelPanel(EngineBridge& engine, LinkedViews& views, QWidget* parent)
    : Panel(engine, tr("Model"), tr("A mesh of the liver with its vessels, ready for mechanics."), parent),
      views_(views) {
  setObjectName(QStringLiteral("model_panel"));
  QVBoxLayout* build = add_section(tr("Build from the labels"));
  auto* form = new QFormLayout;
  vertices_ = new QSpinBox(this);
  vertices_->setRange(100, 5000);
  vertices_->setSingleStep(50);
  vertices_->setValue(model::MeshOptions{}.target_vertices);
  vertices_->setToolTip(tr("More vertices follow the organ more closely and compute more slowly."));
  form->addRow(tr("Mesh vertices"), vertices_);
  vessels_ = new QCheckBox(tr("Portal and hepatic vessels stiffen the model"), this);
  vessels_->setChecked(true);
  form->addRow(vessels_);
  build->addLayout(form);
  run_ = new TaskButton(
      engine, tr("Build model"), [this] { return engine::Command(command()); }, this);
  run_->setObjectName(QStringLiteral("build_model"));
  build->addWidget(run_);
  auto* import = new QPushButton(tr("From a folder of surfaces…"), this);
  connect(import, &QPushButton::clicked, this, &ModelPanel::import_surfaces);
  build->addWidget(import);

  build_trial();

  QVBoxLayout* result = add_section(tr("Quality"));
  quality_ = new FiguresTable(this);
  result->addWidget(quality_);
  notes_ = make_explanation({}, this);
  result->addWidget(notes_);
  build_look();
  connect(&this->engine(), &EngineBridge::case_changed, this, &ModelPanel::show_case);
  watch(engine::Part::model, {"build_model", "import_surfaces", "import_mesh"});
  show_case();
}

void ModelPanel::build_trial() {
  trial_section_ = new QWidget(this);
  auto* layout = new QVBoxLayout(trial_section_);
  layout->setContentsMargins(0, 6, 0, 0);
  layout->setSpacing(5);
  auto* heading = new QLabel(tr("Mechanics"), trial_section_);
  heading->setProperty("role", "heading");
  layout->addWidget(heading);
  layout->addWidget(make_explanation(tr("Drag a point of the liver and see it follow with its vessels and "
                                        "lesions. It is held at the vena cava and "
                                        "where vessels enter; its neighbours are not modelled. A trial: the "
                                        "case stays as it is. Esc ends it."),
                                     trial_section_));
  trial_ = new LoadTrialBox(engine(), views_, trial_section_);
  layout->addWidget(trial_);
  content()->addWidget(trial_section_);
}

void ModelPanel::deactivate() { trial_->end(); }

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
  command.options.mesh.target_vertices = vertices_->value();
  command.options.vessels = vessels_->isChecked();
  return command;
}

void ModelPanel::import_surfaces() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of surfaces, named by structure"));
  if (path.isEmpty()) return;
  engine::ImportSurfaces command;
  command.path = path.toStdString();
  command.options = this->command().options;
  engine().post(command);
}

void ModelPanel::show_case() {
  const engine::CaseState& now = engine().state();
  run_->set_obstacle(now.labels ? QString() : tr("Segment the CT or import labels first."));
  if (now.model == shown_ && shown_) return;
  shown_ = now.model;
  look_->setVisible(shown_ != nullptr);
  trial_section_->setVisible(shown_ != nullptr);
  if (!shown_) trial_->end();
  if (!shown_) {
    quality_->clear();
    notes_->setText(tr("No model yet."));
    return;
  }
  const model::MeshQuality& q = shown_->report.quality;
  const auto mm = [](double value) { return tr("%1 mm").arg(value, 0, 'f', 2); };
  std::vector<std::pair<QString, QString>> rows = {{tr("Vertices"), QString::number(q.vertices)},
                                                   {tr("Tetrahedra"), QString::number(q.tetrahedra)}};
  if (q.min_dihedral_deg > 0.0)
    rows.emplace_back(tr("Dihedral angles"),
                      tr("%1° to %2°").arg(q.min_dihedral_deg, 0, 'f', 1).arg(q.max_dihedral_deg, 0, 'f', 1));
  rows.emplace_back(tr("Volume error"), tr("%1 %").arg(100.0 * q.volume_error, 0, 'f', 1));
  rows.emplace_back(tr("Vertices to fine surface, mean"), mm(q.vertices_to_fine_mean_mm));
  rows.emplace_back(tr("Mesh to fine surface, mean"), mm(q.mesh_to_fine_mean_mm));
  rows.emplace_back(tr("Fine surface to mesh, mean"), mm(q.fine_to_mesh_mean_mm));
  rows.emplace_back(tr("Fine surface to mesh, largest"), mm(q.fine_to_mesh_max_mm));
  std::map<Label, std::size_t> beams;  // of all of a structure's trees together
  for (const VesselTree& tree : shown_->model.vessels) beams[tree.structure] += tree.beams.size();
  for (const auto& [structure, count] : beams)
    rows.emplace_back(tr("%1, beams").arg(structure_text(structure)), QString::number(count));
  quality_->set_rows(rows);
  notes_->setText(notes_text(shown_->report.notes));
  notes_->setVisible(!shown_->report.notes.empty());
  show_structures();
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
