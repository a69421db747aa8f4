// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/label_rows.h"

#include <QCoreApplication>
#include <set>

namespace glisson::ui {

std::vector<LabelRow> label_rows(const segmentation::LabelStatistics* statistics, const Review* review,
                                 Label worked_on) {
  const auto figures_of = [&](Label label) {
    if (statistics != nullptr)
      if (const auto found = statistics->figures().find(label); found != statistics->figures().end())
        return found->second;
    return segmentation::LabelFigures{};
  };
  std::set<Label> labels = {structure::kParenchyma, structure::kPortalVein, structure::kHepaticVeins,
                            structure::kVenaCava, structure::kGallbladder};
  if (statistics != nullptr)
    for (const auto& [label, figures] : statistics->figures())
      if (label != structure::kBackground && figures.voxels > 0) labels.insert(label);
  const std::vector<Label> free =
      free_labels(structure::kFirstLesion, [&labels](Label label) { return labels.contains(label); });
  if (!free.empty()) labels.insert(free.front());
  if (worked_on != structure::kBackground) labels.insert(worked_on);
  std::vector<LabelRow> rows;
  for (const Label label : labels) {
    LabelRow row{label, figures_of(label), ReviewState::not_started};
    if (review != nullptr)
      if (const auto found = review->find(label); found != review->end()) row.review = found->second;
    rows.push_back(row);
  }
  return rows;
}

QString intensity_text(const segmentation::LabelFigures& figures, bool hounsfield) {
  const QString text = hounsfield ? QCoreApplication::translate("glisson::ui::LabelTable", "%1 ± %2 HU")
                                  : QCoreApplication::translate("glisson::ui::LabelTable", "%1 ± %2");
  return text.arg(figures.mean_hu, 0, 'f', 0).arg(figures.sd_hu, 0, 'f', 0);
}

}  // namespace glisson::ui
