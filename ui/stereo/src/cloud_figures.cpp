// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/cloud_figures.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"

namespace glisson::ui {
namespace {

constexpr double kPaperDensity = 0.7;  ///< points per cm2 that the paper's registration needs
constexpr double kRowsOff = 3.0;       ///< pixels: a calibration that is this far off is doubtful

/// Context of these sentences for translators.
class CloudFigures {
  Q_DECLARE_TR_FUNCTIONS(CloudFigures)
 public:
  using Rows = std::vector<std::pair<QString, QString>>;

  static void add_cloud(Rows& rows, const LabelledCloud& cloud) {
    rows.emplace_back(tr("Points"), QString::number(cloud.size()));
    if (cloud.size() == 0) return;
    const auto z = cloud.points.col(2);
    rows.emplace_back(
        tr("Distance from the camera"),
        tr("%1 to %2 mm").arg(1e3 * z.minCoeff(), 0, 'f', 0).arg(1e3 * z.maxCoeff(), 0, 'f', 0));
  }
  static void add_points(Rows& rows, const engine::PairPoints& points) {
    const stereo::ReconstructReport& report = points.whole->report;
    rows.emplace_back(tr("Method"), report.method == stereo::Method::dense ? tr("dense") : tr("features"));
    if (points.area_cm2 > 0.0) {
      rows.emplace_back(tr("Surface"), tr("%1 cm²").arg(points.area_cm2, 0, 'f', 0));
      rows.emplace_back(
          tr("Density"),
          tr("%1 per cm² (needs %2)").arg(points.density_per_cm2, 0, 'f', 1).arg(kPaperDensity));
    }
    if (points.density.area_cm2 > 0.0)
      rows.emplace_back(tr("Dense enough"),
                        tr("%1 % of the surface").arg(100.0 * points.density.covered, 0, 'f', 0));
    rows.emplace_back(tr("Depth's deviation"), tr("%1 mm").arg(1e3 * report.sigma_median, 0, 'f', 2));
    rows.emplace_back(tr("Rows off by"), tr("%1 px").arg(report.row_offset_px, 0, 'f', 2));
    rows.emplace_back(tr("Epipolar error"), tr("%1 px").arg(report.epipolar_rms_px, 0, 'f', 2));
  }
  static void add_registration(Rows& rows, const Registration& registration) {
    rows.emplace_back(tr("Of the organ seen"), tr("%1 %").arg(100.0 * registration.seen_share, 0, 'f', 0));
  }
  static QString of_another_frame() {
    return tr("The regions were drawn on another frame: move them to where they belong now, or clear them.");
  }
  static QString warning(const engine::PairPoints& points) {
    QStringList lines;
    if (points.area_cm2 > 0.0 && points.density_per_cm2 < kPaperDensity)
      lines << tr("Fewer points per cm² than registration needs: choose another method, or look closer.");
    if (std::abs(points.whole->report.row_offset_px) > kRowsOff)
      lines << tr("The pictures' rows do not agree with the calibration: calibrate the laparoscope again.");
    return lines.join(QLatin1Char('\n'));
  }
};

/// Whether there are points, and not of a former calibration.
bool tell_of_now(const engine::CaseState& state) {
  const auto& points = state[part::points];
  return points && (!points->rig || points->rig == state[part::rig]);
}

}  // namespace

std::vector<std::pair<QString, QString>> cloud_figures(const engine::CaseState& state) {
  CloudFigures::Rows rows;
  if (state[part::cloud]) CloudFigures::add_cloud(rows, *state[part::cloud]);
  if (state[part::cloud] && tell_of_now(state)) CloudFigures::add_points(rows, *state[part::points]);
  // Known once the model lies on the cloud.
  if (state[part::cloud] && state[part::registration] && state[part::registration]->seen_share > 0.0 &&
      engine::stage_state(state, part::registration) == engine::StageState::current)
    CloudFigures::add_registration(rows, *state[part::registration]);
  return rows;
}

QString cloud_warning(const engine::CaseState& state) {
  if (state[part::regions] && !state[part::regions]->regions.empty() &&
      engine::stage_state(state, part::regions) == engine::StageState::stale)
    return CloudFigures::of_another_frame();
  return tell_of_now(state) ? CloudFigures::warning(*state[part::points]) : QString();
}

}  // namespace glisson::ui
