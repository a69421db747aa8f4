// SPDX-License-Identifier: GPL-3.0-or-later
// Fig. 6 in words and numbers.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/marked_text.h"
#include "glisson/experiments/sensitivity.h"

namespace glisson::experiments {
namespace {

constexpr double kSmallShift = 3e-3;  // metres, the paper's "below 3 mm"

std::string shown(double value, const char* format) {
  if (!std::isfinite(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

Table table_of(const Sensitivity& found) {
  Table table{{"altered", "by", "mean Hausdorff mm", "least mm", "most mm", "nodes mm", "equilibria"}, {}};
  for (const ShiftRow& row : found.shifts)
    table.rows.push_back({std::string("place of ") + support_code(row.support),
                          shown(1e3 * row.shift, "%.1f mm"), in_millimetres(row.mean.surface),
                          in_millimetres(row.least), in_millimetres(row.most), in_millimetres(row.mean.nodes),
                          std::to_string(row.solved) + "/" + std::to_string(row.tried)});
  for (const StiffnessRow& row : found.stiffness)
    table.rows.push_back({std::string("stiffness of ") + support_code(row.support), shown(row.factor, "x %g"),
                          in_millimetres(row.distance.surface), "-", "-", in_millimetres(row.distance.nodes),
                          std::isfinite(row.distance.surface) ? "1/1" : "0/1"});
  return table;
}

/// The largest mean distance of small shifts (not below, at 3 mm too), of all shifts, of any stiffness from
/// half to twice, and of any stiffness. Metres; not a number: none was tried, or none came to rest. What
/// stays as it is has no part in them.
struct Extremes {
  double small = NAN, place = NAN, halved_or_doubled = NAN, stiffness = NAN;
};
Extremes extremes_of(const Sensitivity& found) {
  Extremes most;
  for (const ShiftRow& row : found.shifts) {
    if (row.shift == 0.0) continue;
    if (row.shift <= kSmallShift) most.small = std::fmax(most.small, row.mean.surface);
    most.place = std::fmax(most.place, row.mean.surface);
  }
  for (const StiffnessRow& row : found.stiffness) {
    if (row.factor == 1.0) continue;
    if (row.factor >= 0.5 && row.factor <= 2.0)
      most.halved_or_doubled = std::fmax(most.halved_or_doubled, row.distance.surface);
    most.stiffness = std::fmax(most.stiffness, row.distance.surface);
  }
  return most;
}

Table beside(const Sensitivity& found) {
  const Extremes most = extremes_of(found);
  std::string exponents;
  for (const Support support : kSupports)
    exponents += std::string(exponents.empty() ? "" : "; ") + support_code(support) + " " +
                 shown(found.exponents[static_cast<std::size_t>(support)], "%.2f");
  return {{"what", "paper", "here"},
          {{"error of a shift of at most 3 mm, mm", "below 1 (shift below 3)", in_millimetres(most.small)},
           {"error over shift: exponent (1 linear, 2 quadratic)", "seems to be quadratic", exponents},
           {"error of stiffness x 0.5 to x 2, mm", "very small beside the place's",
            in_millimetres(most.halved_or_doubled)},
           {"error of any stiffness, mm", "-", in_millimetres(most.stiffness)},
           {"error of any place, mm", "-", in_millimetres(most.place)},
           {"reference's motion, mean and largest, mm", "-",
            in_millimetres(found.motion_mean) + "; " + in_millimetres(found.motion_max)}}};
}

Figures figures_in(const Sensitivity& found) {
  const Extremes most = extremes_of(found);
  Figures figures = {{"figure6_motion_mean_mm", 1e3 * found.motion_mean},
                     {"figure6_motion_max_mm", 1e3 * found.motion_max},
                     {"figure6_shift_upto_3mm_mm", 1e3 * most.small},
                     {"figure6_shift_most_mm", 1e3 * most.place},
                     {"figure6_stiffness_half_to_twice_mm", 1e3 * most.halved_or_doubled},
                     {"figure6_stiffness_most_mm", 1e3 * most.stiffness}};
  int unsolved = 0;
  for (const ShiftRow& row : found.shifts) {
    const std::string key = std::string("figure6_") + support_code(row.support) + "_shift_" +
                            shown(1e3 * row.shift, "%g") + "mm_";
    figures[key + "mm"] = 1e3 * row.mean.surface;
    figures[key + "nodes_mm"] = 1e3 * row.mean.nodes;
    unsolved += row.tried - row.solved;
  }
  for (const StiffnessRow& row : found.stiffness) {
    figures[std::string("figure6_") + support_code(row.support) + "_stiffness_" + shown(row.factor, "%g") +
            "_mm"] = 1e3 * row.distance.surface;
    if (!std::isfinite(row.distance.surface)) ++unsolved;
  }
  for (const Support support : kSupports)
    figures[std::string("figure6_") + support_code(support) + "_exponent"] =
        found.exponents[static_cast<std::size_t>(support)];
  figures["figure6_without_equilibrium"] = unsolved;
  std::erase_if(figures, [](const auto& one) { return !std::isfinite(one.second); });
  return figures;
}

const char* support_text(Support support) {
  switch (support) {
    case Support::notch:
      return QT_TRANSLATE_NOOP("cli", "falciform ligament at the notch");
    case Support::cava:
      return QT_TRANSLATE_NOOP("cli", "vena cava");
    case Support::both:
      break;
  }
  return QT_TRANSLATE_NOOP("cli", "both");
}

FigurePlot plot_of_places(const Sensitivity& found) {
  FigurePlot plot{QT_TRANSLATE_NOOP("cli", "(a) place of the boundary conditions"),
                  QT_TRANSLATE_NOOP("cli", "shift along the surface, mm"),
                  QT_TRANSLATE_NOOP("cli", "mean Hausdorff distance, mm"),
                  {},
                  {}};
  for (const Support support : kSupports) {
    FigureSeries shifted{support_text(support), {}, {}, {}};
    for (const ShiftRow& row : found.shifts) {
      if (row.support != support) continue;
      shifted.values.emplace_back(1e3 * row.shift, drawn_millimetres(row.mean.surface));
      shifted.low.push_back(drawn_millimetres(row.least));
      shifted.high.push_back(drawn_millimetres(row.most));
    }
    plot.series.push_back(std::move(shifted));
  }
  return plot;
}

FigurePlot plot_of_stiffness(const Sensitivity& found) {
  FigurePlot plot{QT_TRANSLATE_NOOP("cli", "(b) stiffness of the boundary conditions"),
                  QT_TRANSLATE_NOOP("cli", "times the reference's stiffness"),
                  QT_TRANSLATE_NOOP("cli", "mean Hausdorff distance, mm"),
                  {},
                  {}};
  for (const Support support : kSupports) {
    FigureSeries stiffened{support_text(support), {}, {}, {}};
    for (const StiffnessRow& row : found.stiffness) {
      if (row.support != support) continue;
      if (support == kSupports.front()) plot.categories.push_back("× " + shown(row.factor, "%g"));
      stiffened.values.emplace_back(static_cast<double>(stiffened.values.size()),
                                    drawn_millimetres(row.distance.surface));
    }
    plot.series.push_back(std::move(stiffened));
  }
  return plot;
}

}  // namespace

PaperFigure figure_of(const Sensitivity& found) {
  PaperFigure figure;
  figure.number = 6;
  figure.title = "The paper's Fig. 6: sensitivity to boundary conditions";
  figure.introduction =
      "Gravity turns from supine to the flank; the liver (vessels and capsule included) hangs on the "
      "falciform "
      "ligament at the umbilical notch and on the vena cava alone, E = 20 MPa. The places of one or both are "
      "shifted along the surface, in several directions, or their stiffness is altered; the final shape is "
      "compared with the reference's. Mean Hausdorff distance: from each vertex of one surface to the "
      "closest "
      "point of the other, mean; half the sum of both directions. In silico: one simulation against another.";
  figure.table = table_of(found);
  figure.paper = beside(found);
  figure.figures = figures_in(found);
  figure.plots = {plot_of_places(found), plot_of_stiffness(found)};
  return figure;
}

}  // namespace glisson::experiments
