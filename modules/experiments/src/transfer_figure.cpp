// SPDX-License-Identifier: GPL-3.0-or-later
// Fig. 5 in words and numbers.
#include <cmath>
#include <functional>

#include "glisson/core/marked_text.h"
#include "glisson/experiments/transfer_study.h"

namespace glisson::experiments {
namespace {

constexpr double kPaperBound = 0.01;  // metres: "all the boundary condition location errors are under 10 mm"

/// Mean, largest and how many beyond the paper's bound, of the rows that have the value.
struct Tally {
  double mean = NAN, largest = NAN;
  int livers = 0, beyond = 0;
};
Tally tally(const TransferStudy& study, bool real, double TransferRow::*value) {
  Tally found;
  double sum = 0.0;
  for (const TransferRow& row : study.rows) {
    if (row.real != real || !std::isfinite(row.*value)) continue;
    ++found.livers;
    sum += row.*value;
    found.largest = std::fmax(found.largest, row.*value);
    if (row.*value >= kPaperBound) ++found.beyond;
  }
  if (found.livers > 0) found.mean = sum / found.livers;
  return found;
}

std::string beyond(const Tally& tally) {
  return tally.livers == 0 ? "-" : std::to_string(tally.beyond) + " of " + std::to_string(tally.livers);
}

std::string both(const Tally& tally) {
  return in_millimetres(tally.mean) + "; " + in_millimetres(tally.largest);
}

Table table_of(const TransferStudy& study) {
  Table table{
      {"liver", "data", "foretold by", "surface mm", "largest mm", "notch mm", "cava mm", "largest mm"}, {}};
  for (const TransferRow& row : study.rows)
    table.rows.push_back({row.liver, row.real ? "real" : "in silico",
                          row.outside ? "atlas without it" : "others", in_millimetres(row.surface),
                          in_millimetres(row.surface_largest), in_millimetres(row.notch),
                          in_millimetres(row.cava), in_millimetres(row.cava_largest)});
  return table;
}

Table beside(const TransferStudy& study) {
  const Tally notch = tally(study, false, &TransferRow::notch),
              cava = tally(study, false, &TransferRow::cava),
              real_cava = tally(study, true, &TransferRow::cava);
  return {
      {"what", "paper (real)", "in silico", "real"},
      {{"standard deviation of the notch over the samples, mm", "11.12", in_millimetres(study.notch_spread),
        "-"},
       {"standard deviation of the vena cava over the samples, mm", "16.56",
        in_millimetres(study.cava_spread), in_millimetres(study.real_cava_spread)},
       {"surface: mean; worst liver, mm", "very accurate", both(tally(study, false, &TransferRow::surface)),
        both(tally(study, true, &TransferRow::surface))},
       {"notch: mean; worst liver, mm", "under 10 but for one sample", both(notch), "-"},
       {"vena cava: mean; worst liver, mm", "under 10 but for one sample", both(cava), both(real_cava)},
       {"notch: livers of 10 mm and more", "at most 1 of 12", beyond(notch), "-"},
       {"vena cava: livers of 10 mm and more", "at most 1 of 12", beyond(cava), beyond(real_cava)}}};
}

Figures figures_in(const TransferStudy& study) {
  Figures figures = {{"figure5_notch_spread_mm", 1e3 * study.notch_spread},
                     {"figure5_cava_spread_mm", 1e3 * study.cava_spread},
                     {"figure5_real_cava_spread_mm", 1e3 * study.real_cava_spread}};
  const auto add = [&](const std::string& key, bool real, double TransferRow::*value) {
    const Tally found = tally(study, real, value);
    const std::string begin = std::string("figure5_") + (real ? "real_" : "") + key;
    figures[begin + "_mean_mm"] = 1e3 * found.mean;
    figures[begin + "_worst_mm"] = 1e3 * found.largest;
    if (found.livers > 0) figures[begin + "_livers"] = found.livers;
  };
  for (const bool real : {false, true}) {
    add("surface", real, &TransferRow::surface);
    add("surface_largest", real, &TransferRow::surface_largest);
    add("notch", real, &TransferRow::notch);
    add("cava", real, &TransferRow::cava);
    add("cava_largest", real, &TransferRow::cava_largest);
  }
  std::erase_if(figures, [](const auto& one) { return !std::isfinite(one.second); });
  return figures;
}

/// A liver's name under its bars: they are slanted, and there is room for few letters.
std::string name_under_bars(const TransferRow& row) {
  const std::string word = "synthetic_", letter = "s ";
  std::string name = row.liver;
  for (auto at = name.find(word); at != std::string::npos; at = name.find(word, at + letter.size()))
    name.replace(at, word.size(), letter);
  return name + (row.outside ? " *" : "");
}

FigurePlot plot_of(const TransferStudy& study) {
  FigurePlot plot{QT_TRANSLATE_NOOP("cli", "the atlas laid on livers"),
                  QT_TRANSLATE_NOOP("cli", "liver (s: synthetic; * not in the atlas)"),
                  QT_TRANSLATE_NOOP("cli", "mean Hausdorff distance, mm"),
                  {},
                  {}};
  FigureSeries surface{QT_TRANSLATE_NOOP("cli", "surface"), {}, {}, {}},
      notch{QT_TRANSLATE_NOOP("cli", "umbilical notch (in silico)"), {}, {}, {}},
      cava{QT_TRANSLATE_NOOP("cli", "vena cava"), {}, {}, {}};
  for (const TransferRow& row : study.rows) {
    const auto x = static_cast<double>(plot.categories.size());
    plot.categories.push_back(name_under_bars(row));
    surface.values.emplace_back(x, drawn_millimetres(row.surface));
    notch.values.emplace_back(x, drawn_millimetres(row.notch));
    cava.values.emplace_back(x, drawn_millimetres(row.cava));
  }
  plot.series = {surface, notch, cava};
  return plot;
}

}  // namespace

PaperFigure figure_of(const TransferStudy& study) {
  PaperFigure figure;
  figure.number = 5;
  figure.title = "The paper's Fig. 5: transfer of boundary conditions by the atlas";
  figure.introduction =
      "An atlas of livers is laid on each of them, foretold by the others, and on livers that are not in it. "
      "Synthetic livers (in silico: all structures known by formula) and label maps of real CTs (those of "
      "even "
      "numbers, which served development; their notch is not known, '-'). Surface: from samples of one "
      "surface "
      "to the closest point of the other, mean, the worse direction. Vena cava: from each point of one "
      "contact "
      "to the closest of the other, half the sum of both directions' means. Largest: Hausdorff distance. "
      "Notch: "
      "from the true point to the one foretold.";
  figure.table = table_of(study);
  figure.paper = beside(study);
  figure.figures = figures_in(study);
  figure.plots = {plot_of(study)};
  figure.absent = study.absent;
  return figure;
}

}  // namespace glisson::experiments
