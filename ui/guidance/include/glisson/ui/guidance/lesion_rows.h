// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/common/figures_table.h"

namespace glisson::ui {

/// One lesion, as it is told to a person.
struct LesionRow {
  Label lesion = 0;
  Level level = Level::withdrawn;
  QString name, state;
  QString expected;  ///< mean error; a dash: not known
  QString within;    ///< reach of its 95 % region; a dash: not known
  QString why;       ///< less than the lesion is drawn; empty: it is drawn
  bool operator==(const LesionRow&) const = default;
};
using LesionRows = std::vector<LesionRow>;

/// One row a verdict. @param whole of the overlay that they belong to: none is better.
LesionRows lesion_rows(const std::vector<LesionVerdict>& verdicts, Level whole);

/// The numbers of one of them; those of a lesion that is not shown are not told.
FigureRows lesion_figures(const LesionVerdict& verdict, Level whole,
                          const std::optional<guidance::LesionMeasures>& measures);

/// The lesion that is shown at a pixel, the nearest by its own size; 0: none.
Label lesion_at(const OverlayFrame& overlay, const Camera& camera, const Eigen::Vector2d& pixel);

}  // namespace glisson::ui
