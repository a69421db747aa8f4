// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"

namespace glisson::atlas {

double deviation(const StructureStatistics& statistics) {
  const int points = point_count(statistics.structure);
  double traces = 0.0;
  for (int k = 0; k < points; ++k) traces += covariance(statistics, k).trace();
  return std::sqrt(traces / points);
}

namespace {

using Judged = std::map<Structure, LeftOutStructure>;

/// Of those that were judged, the liver by liver that `judged` gives.
void add(Figures& figures, const BuildResult& built, const Judged LeftOut::*judged, const std::string& how) {
  std::map<Structure, std::vector<LeftOutStructure>> found;
  for (const LeftOut& left : built.left_out)
    for (const auto& [structure, one] : left.*judged) found[structure].push_back(one);
  for (const auto& [structure, all] : found) {
    const std::string key = std::string("atlas_") + structure_code(structure) + how;
    double inside = 0.0, points = 0.0;
    for (const LeftOutStructure& one : all) {
      figures[key + "_mean_mm"] += 1e3 * one.mean_error / static_cast<double>(all.size());
      figures[key + "_worst_mm"] = std::max(figures[key + "_worst_mm"], 1e3 * one.mean_error);
      inside += one.inside;
      points += one.points;
    }
    figures[key + "_inside_share"] = inside / points;
  }
}

}  // namespace

Figures figures_of(const BuildResult& built) {
  Figures figures;
  const auto count = static_cast<double>(built.left_out.size());
  figures["atlas_members"] = count;
  figures["atlas_modes"] = built.quality.compactness_modes;
  figures["atlas_generality_mm"] = 1e3 * built.quality.generality;
  figures["atlas_specificity_mm"] = 1e3 * built.quality.specificity;
  for (const LeftOut& left : built.left_out)
    figures["atlas_surface_mean_mm"] += 1e3 * left.mean_distance / count;
  add(figures, built, &LeftOut::structures, "");
  add(figures, built, &LeftOut::with_notch, "_with_notch");
  return figures;
}

}  // namespace glisson::atlas
