// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/lesion_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/overlay_painter.h"

namespace glisson::ui {
namespace {

/// Context for translators.
class LesionTexts {
  Q_DECLARE_TR_FUNCTIONS(LesionTexts)
 public:
  static QString state(Level level) {
    switch (level) {
      case Level::valid:
        return tr("shown");
      case Level::degraded:
        return tr("region only");
      case Level::withdrawn:
        return tr("not shown");
    }
    return {};
  }
  static QString expected(const LesionVerdict& verdict) {
    const bool is_known = verdict.reach > 0.0;
    return is_known ? tr("%1 mm").arg(1e3 * verdict.expected, 0, 'f', 1) : QStringLiteral("–");
  }
  static QString within(double metres) {
    return metres > 0.0 ? tr("±%1 mm").arg(1e3 * metres, 0, 'f', 1) : QStringLiteral("–");
  }
  static QString length(double metres) { return tr("%1 mm").arg(1e3 * metres, 0, 'f', 0); }
  static QString seconds(double seconds) { return tr("%1 s").arg(seconds, 0, 'f', 0); }
  static QString support() { return tr("Nearest tracked points"); }
  static QString unseen() { return tr("Nothing near it tracked for"); }
};

}  // namespace

LesionRows lesion_rows(const std::vector<LesionVerdict>& verdicts, Level whole) {
  LesionRows rows;
  for (const LesionVerdict& verdict : verdicts) {
    LesionRow row;
    row.lesion = verdict.lesion;
    row.level = std::max(verdict.level, whole);
    row.name = structure_text(verdict.lesion);
    row.state = LesionTexts::state(row.level);
    row.expected = LesionTexts::expected(verdict);
    row.within = LesionTexts::within(verdict.reach);
    const LesionReason reason = whole > verdict.level ? LesionReason::with_the_whole : verdict.reason;
    if (row.level != Level::valid) row.why = QString::fromStdString(scene::lesion_reason_text(reason));
    rows.push_back(std::move(row));
  }
  return rows;
}

FigureRows lesion_figures(const LesionVerdict& verdict, Level whole,
                          const std::optional<guidance::LesionMeasures>& measures) {
  FigureRows rows;
  if (std::max(verdict.level, whole) == Level::withdrawn) return rows;
  const bool are_its = measures && measures->lesion == verdict.lesion;
  for (const auto& [name, value] :
       scene::lesion_numbers(verdict, are_its ? *measures : guidance::LesionMeasures()))
    rows.emplace_back(QString::fromStdString(name), QString::fromStdString(value));
  if (verdict.support > 0.0 && std::isfinite(verdict.support))
    rows.emplace_back(LesionTexts::support(), LesionTexts::length(verdict.support));
  if (verdict.unseen >= 1.0) rows.emplace_back(LesionTexts::unseen(), LesionTexts::seconds(verdict.unseen));
  return rows;
}

Label lesion_at(const OverlayFrame& overlay, const Camera& camera, const Eigen::Vector2d& pixel) {
  constexpr double kSmallest = 12.0;  // pixels: what a hand hits
  Label best = 0;
  double nearest = 1.0;
  for (const LesionVerdict& verdict : overlay.lesions) {
    if (std::max(verdict.level, overlay.level()) == Level::withdrawn || !camera.maps(verdict.centre))
      continue;
    const bool is_region = std::max(verdict.level, overlay.level()) == Level::degraded;
    const double size = verdict.radius + (is_region ? verdict.reach : 0.0);
    const double radius = std::max(kSmallest, size * camera.matrix(0, 0) / verdict.centre.z());
    const double distance = (camera.project(verdict.centre) - pixel).norm() / radius;
    if (distance >= nearest) continue;
    nearest = distance;
    best = verdict.lesion;
  }
  return best;
}

}  // namespace glisson::ui
