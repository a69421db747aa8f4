// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/quality_sheet.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <map>

#include "glisson/engine/commands/check_model.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/review.h"
#include "glisson/patient/cut_organ.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr int kWorstElements = 20;
constexpr double kFlatDeg = 10.0;
// Beyond these a figure is worth a look before the model is trusted.
constexpr double kVolumeToLookAt = 0.05, kDistanceToLookAtMm = 0.5, kGapToLookAtMm = 10.0;

/// Sentences of unapproved_text() for translators.
class Review {
  Q_DECLARE_TR_FUNCTIONS(Review)
 public:
  static QString line(ReviewState state, const QString& names) {
    switch (state) {
      case ReviewState::not_started:
        return tr("Labels that nobody has reviewed: %1.").arg(names);
      case ReviewState::in_progress:
        return tr("Labels under review: %1.").arg(names);
      case ReviewState::to_review:
        return tr("Labels still to be reviewed: %1.").arg(names);
      case ReviewState::approved:
        break;
    }
    return {};
  }
};

}  // namespace

bool is_from_labels(const engine::CaseState& state) {
  return state[part::model] && state.stamp(part::model).made_from.count(part::labels) > 0;
}

QString unapproved_text(const engine::CaseState& state) {
  QStringList lines;
  for (const auto& [review, labels] : engine::unapproved_labels(state)) {
    QStringList names;
    for (const Label label : labels) names << structure_text(label);
    lines << Review::line(review, names.join(QStringLiteral(", ")));
  }
  return lines.join(QLatin1Char('\n'));
}

QualitySheet::QualitySheet(EngineBridge& engine, LinkedViews& views, QWidget* parent)
    : QWidget(parent), engine_(engine), views_(views) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("model_summary"));
  summary_->setWordWrap(true);
  layout->addWidget(summary_);
  figures_ = new FiguresTable(this);
  layout->addWidget(figures_);
  angles_ = new AngleHistogram(this);
  angles_->setObjectName(QStringLiteral("model_angles"));
  layout->addWidget(angles_);
  worst_ = new QCheckBox(tr("Show the %1 flattest elements in 3D").arg(kWorstElements), this);
  worst_->setObjectName(QStringLiteral("model_worst"));
  layout->addWidget(worst_);
  structures_ = new FiguresTable(this);
  layout->addWidget(structures_);
  review_ = make_warning(this);
  review_->setObjectName(QStringLiteral("model_review"));
  layout->addWidget(review_);
  checked_ = new QCheckBox(tr("I have checked this model"), this);
  checked_->setObjectName(QStringLiteral("model_checked"));
  layout->addWidget(checked_);
  notes_ = make_explanation({}, this);
  layout->addWidget(notes_);
  connect(worst_, &QCheckBox::toggled, this, &QualitySheet::show_worst);
  connect(checked_, &QCheckBox::toggled, this, [this](bool on) {
    engine_.post(engine::CheckModel{{on}, shown_});
  });
  connect(&engine_, &EngineBridge::case_changed, this, &QualitySheet::show_case);
  connect(&engine_, &EngineBridge::tasks_changed, this, &QualitySheet::show_tasks);
  show_case();
  show_tasks();
}

void QualitySheet::show_tasks() {
  const bool waits = is_being_made(engine_, part::model);
  checked_->setEnabled(!waits);
  checked_->setToolTip(waits
                           ? model_wait_text()
                           : tr("Kept with the case. Another model, or an edit of its vessels, asks again."));
  if (is_being_made(engine_, part::check)) return;
  // What was said may not have come to the case.
  const QSignalBlocker quiet(checked_);
  checked_->setChecked(engine::is_model_checked(engine_.state()));
}

void QualitySheet::leave() { worst_->setChecked(false); }

void QualitySheet::show_case() {
  const engine::CaseState& now = engine_.state();
  {
    const QSignalBlocker quiet(checked_);
    checked_->setChecked(engine::is_model_checked(now));
  }
  show_warning(*review_, is_from_labels(now) ? unapproved_text(now) : QString());
  if (now[part::model] == shown_ && (shown_ || !summary_->text().isEmpty())) return;
  shown_ = now[part::model];
  for (QWidget* part : std::initializer_list<QWidget*>{checked_, angles_, worst_})
    part->setVisible(shown_ != nullptr);
  notes_->setVisible(shown_ && !shown_->report.notes.empty());
  show_worst();
  if (!shown_) {
    summary_->setText(tr("No model yet."));
    figures_->clear();
    structures_->clear();
    return;
  }
  const QStringList open = findings();
  summary_->setText(open.isEmpty()
                        ? tr("Nothing stands out. Look at the liver, its vessels and lesions in 3D.")
                        : tr("Worth a look:") + QStringLiteral("\n• ") + open.join(QStringLiteral("\n• ")));
  figures_->set_rows(mesh_rows());
  structures_->set_rows(structure_rows());
  angles_->set_counts(model::dihedral_histogram(shown_->model.mesh));
  notes_->setText(notes_text(shown_->report.notes));
}

QStringList QualitySheet::findings() const {
  QStringList found;
  for (const std::string& note : shown_->report.notes)
    if (told_cut({note}) > 0) found << note_text(note);
  const model::MeshQuality& q = shown_->report.quality;
  if (q.min_dihedral_deg < kFlatDeg)
    found << tr("Flat elements: the smallest angle is %1°. Build anew with another number of vertices.")
                 .arg(q.min_dihedral_deg, 0, 'f', 1);
  found << fit_findings();
  std::map<Label, int> trees;
  for (const VesselTree& tree : shown_->model.vessels) ++trees[tree.structure];
  for (const auto& [structure, count] : trees)
    if (count > 1)
      found << tr("%1: %2 separate trees. Join those that belong together.")
                   .arg(structure_text(structure))
                   .arg(count);
  int small = 0;
  for (const model::LesionVolume& lesion : model::lesion_volumes(shown_->model))
    small += lesion.mesh_volume == 0.0;
  if (small > 0)
    found << tr("Lesions without elements of their own: %1. They follow the tissue around them.").arg(small);
  return found;
}

QStringList QualitySheet::fit_findings() const {
  const std::optional<model::OrganFit>& fit = shown_->report.quality.organ_fit;
  if (!fit)
    return {
        tr("How closely the mesh follows the organ is not known: it was imported as it is, and there is no "
           "organ "
           "to compare it with.")};
  QStringList found;
  if (fit->volume_error < -kVolumeToLookAt)
    found << tr("The mesh holds %1 % less volume than the organ. More vertices follow it more closely.")
                 .arg(-100.0 * fit->volume_error, 0, 'f', 1);
  if (fit->volume_error > kVolumeToLookAt)
    found << tr("The mesh holds %1 % more volume than the organ. More vertices follow it more closely.")
                 .arg(100.0 * fit->volume_error, 0, 'f', 1);
  if (fit->vertices_to_fine_mean_mm > kDistanceToLookAtMm)
    found << tr("The mesh's vertices lie %1 mm beside the organ's surface on average.")
                 .arg(fit->vertices_to_fine_mean_mm, 0, 'f', 1);
  if (fit->fine_to_mesh_max_mm > kGapToLookAtMm)
    found << tr("A thin edge of the liver stands out of the mesh by %1 mm.")
                 .arg(fit->fine_to_mesh_max_mm, 0, 'f', 0);
  return found;
}

std::vector<std::pair<QString, QString>> QualitySheet::mesh_rows() const {
  const model::MeshQuality& q = shown_->report.quality;
  const PatientModel& patient = shown_->model;
  const auto mm = [](double value) { return tr("%1 mm").arg(value, 0, 'f', 2); };
  std::vector<std::pair<QString, QString>> rows = {
      {tr("Vertices"), QString::number(q.vertices)},
      {tr("Tetrahedra"), QString::number(q.tetrahedra)},
      {tr("Edge length, mean"), tr("%1 mm").arg(1e3 * model::mean_edge_length(patient.mesh), 0, 'f', 1)},
      {tr("Volume"), tr("%1 ml").arg(1e6 * volume(patient.mesh), 0, 'f', 0)}};
  if (const auto& fit = q.organ_fit) {
    rows.emplace_back(tr("Volume error"), tr("%1 %").arg(100.0 * fit->volume_error, 0, 'f', 1));
    rows.emplace_back(tr("Vertices to fine surface, mean"), mm(fit->vertices_to_fine_mean_mm));
    rows.emplace_back(tr("Mesh to fine surface, mean"), mm(fit->mesh_to_fine_mean_mm));
    rows.emplace_back(tr("Fine surface to mesh, mean"), mm(fit->fine_to_mesh_mean_mm));
    rows.emplace_back(tr("Fine surface to mesh, largest"), mm(fit->fine_to_mesh_max_mm));
  }
  if (q.min_dihedral_deg > 0.0)
    rows.emplace_back(tr("Dihedral angles"),
                      tr("%1° to %2°").arg(q.min_dihedral_deg, 0, 'f', 1).arg(q.max_dihedral_deg, 0, 'f', 1));
  return rows;
}

std::vector<std::pair<QString, QString>> QualitySheet::structure_rows() const {
  std::vector<std::pair<QString, QString>> rows;
  for (const model::LesionVolume& lesion : model::lesion_volumes(shown_->model)) {
    if (lesion.mesh_volume == 0.0) continue;
    QString value =
        tr("%1 ml").arg(1e6 * (lesion.volume > 0.0 ? lesion.volume : lesion.mesh_volume), 0, 'f', 1);
    if (lesion.volume > 0.0) {
      const double error = 100.0 * (lesion.mesh_volume / lesion.volume - 1.0);
      value =
          tr("%1, mesh %2 %")
              .arg(value, (error < 0.0 ? QString() : QStringLiteral("+")) + QString::number(error, 'f', 1));
    }
    rows.emplace_back(structure_text(lesion.label), value);
  }
  for (const model::TreeSummary& tree : model::tree_summaries(shown_->model))
    rows.emplace_back(
        structure_text(tree.structure),
        tr("%1 mm, tips: %2, beams: %3").arg(1e3 * tree.length, 0, 'f', 0).arg(tree.tips).arg(tree.beams));
  return rows;
}

void QualitySheet::show_worst() {
  scene::PatientScene& scene = views_.volume().patient();
  scene.set_highlight(
      shown_ && worst_->isChecked()
          ? model::tetrahedra_as_surface(shown_->model.mesh,
                                         model::worst_tetrahedra(shown_->model.mesh, kWorstElements))
          : TriangleMesh());
  views_.volume().update();
}

}  // namespace glisson::ui
