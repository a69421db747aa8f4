// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/measure_book.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"

namespace glisson::ui {
namespace {

constexpr double kHere = 1e-6;  ///< metres within which two lines lie in one slice

/// Whether two lines of one slice meet between their ends.
bool cross(const MeasureLine& a, const MeasureLine& b, scene::Plane plane) {
  const int normal = scene::normal_axis(plane), x = normal == 0 ? 1 : 0, y = 3 - normal - x;
  const auto flat = [&](const Eigen::Vector3d& p) { return Eigen::Vector2d(p[x], p[y]); };
  Eigen::Matrix2d along;
  along << flat(a.to - a.from), flat(b.from - b.to);
  if (std::abs(along.determinant()) < 1e-18) return false;  // parallel, or no line
  const Eigen::Vector2d shares = along.inverse() * flat(b.from - a.from);
  return shares.minCoeff() >= 0.0 && shares.maxCoeff() <= 1.0;
}

}  // namespace

void MeasureBook::set_tool(MeasureTool tool) {
  if (tool == tool_) return;
  drop();
  tool_ = tool;
  emit tool_changed();
}

std::optional<Measure> MeasureBook::drawn() const {
  if (!drawing_) return std::nullopt;
  return Measure{plane_, tool_, *drawing_, std::nullopt};
}

void MeasureBook::begin(scene::Plane plane, const Point<CtFrame>& p) {
  require(tool_ != MeasureTool::none, "a measure is begun with a tool");
  plane_ = plane;
  drawing_ = MeasureLine{p.xyz, p.xyz};
  emit changed();
}

void MeasureBook::move(const Point<CtFrame>& p) {
  if (!drawing_) return;
  drawing_->to = p.xyz;
  // The wheel may turn to another slice in the middle of a drag: a measure stays in its own.
  const int normal = scene::normal_axis(plane_);
  drawing_->to[normal] = drawing_->from[normal];
  emit changed();
}

bool MeasureBook::crosses_last(const MeasureLine& line) const {
  if (tool_ != MeasureTool::diameters || measures_.empty()) return false;
  const Measure& last = measures_.back();
  const int normal = scene::normal_axis(plane_);
  return last.tool == MeasureTool::diameters && !last.across && last.plane == plane_ &&
         std::abs(last.line.from[normal] - line.from[normal]) < kHere && cross(last.line, line, plane_);
}

void MeasureBook::end(double least) {
  if (!drawing_) return;
  const MeasureLine line = *drawing_;
  drawing_.reset();
  if (line.length() >= least) {
    if (crosses_last(line))
      measures_.back().across = line;
    else
      measures_.push_back({plane_, tool_, line, std::nullopt});
  }
  emit changed();
}

void MeasureBook::drop() {
  if (!drawing_) return;
  drawing_.reset();
  emit changed();
}

void MeasureBook::undo() {
  if (measures_.empty()) return;
  if (measures_.back().across)
    measures_.back().across.reset();
  else
    measures_.pop_back();
  emit changed();
}

void MeasureBook::wipe() {
  if (measures_.empty() && !drawing_) return;
  measures_.clear();
  drawing_.reset();
  emit changed();
}

QString MeasureBook::text(const Measure& measure) {
  const auto millimetres = [](double metres) { return QString::number(1e3 * metres, 'f', 1); };
  const double first = measure.line.length();
  if (!measure.across) return tr("%1 mm").arg(millimetres(first));
  const double second = measure.across->length();
  return tr("%1 × %2 mm").arg(millimetres(std::max(first, second)), millimetres(std::min(first, second)));
}

}  // namespace glisson::ui
