// SPDX-License-Identifier: GPL-3.0-or-later
#include "mr_signal.h"

#include <cmath>
#include <numbers>

#include "tissue.h"

namespace glisson::insilico {
namespace {

/// What decides the signal of one tissue.
struct Protons {
  double hounsfield;  ///< the tissue's name on the canvas
  double t1_s, t2_s;
  double share;         ///< of water that gives a signal
  double plasma = 0.0;  ///< share of plasma and interstitium: what contrast medium reaches
  double left = 1.0;    ///< after fat suppression
  bool flows = false;
};

constexpr double kFatLeft = 0.1;

/// Rising Hounsfield units. Between two tissues lies what is mixed of them.
const std::vector<Protons>& soft_tissues() {
  static const std::vector<Protons> kTissues{{tissue::kAir, 1.0, 0.05, 0.0},
                                             {tissue::kLung, 1.0, 0.01, 0.03},
                                             {tissue::kFat, 0.343, 0.058, 0.9, 0.02, kFatLeft},
                                             {tissue::kInnerFat, 0.343, 0.058, 0.9, 0.02, kFatLeft},
                                             {tissue::kPelvis, 3.0, 0.5, 0.95},
                                             {tissue::kBile, 2.5, 0.4, 0.95},
                                             {tissue::kSkin, 0.9, 0.03, 0.7, 0.15},
                                             {tissue::kMuscle, 0.856, 0.027, 0.8, 0.1},
                                             {tissue::kTumour, 0.95, 0.08, 0.85, 0.14},
                                             {tissue::kBowelContent, 1.2, 0.06, 0.8},
                                             {tissue::kStomach, 1.2, 0.06, 0.8},
                                             {tissue::kBowelWall, 1.0, 0.05, 0.8, 0.3},
                                             {tissue::kPancreas, 0.584, 0.046, 0.78, 0.25},
                                             {tissue::kLiver, 0.586, 0.046, 0.78, 0.27},
                                             {tissue::kSpleen, 1.057, 0.079, 0.8, 0.36},
                                             {tissue::kHeart, 1.03, 0.05, 0.8, 0.3},
                                             {tissue::kCava, 1.441, 0.29, 0.85, 0.52, 1.0, true},
                                             {tissue::kHepatic, 1.441, 0.29, 0.85, 0.57, 1.0, true},
                                             {tissue::kMedulla, 1.412, 0.085, 0.85, 0.5},
                                             {tissue::kAorta, 1.441, 0.29, 0.85, 0.58, 1.0, true},
                                             {tissue::kPortal, 1.441, 0.29, 0.85, 0.6, 1.0, true},
                                             {tissue::kCortex, 0.966, 0.087, 0.85, 0.6}};
  return kTissues;
}
const std::vector<Protons>& bones() {
  static const std::vector<Protons> kTissues{{tissue::kCanal, 3.5, 1.0, 0.98},
                                             {tissue::kDisc, 1.2, 0.06, 0.6},
                                             {tissue::kCartilage, 1.1, 0.03, 0.6, 0.05},
                                             {tissue::kMarrow, 0.549, 0.049, 0.5, 0.15},
                                             {tissue::kCortical, 1.0, 0.001, 0.0}};
  return kTissues;
}

double signal_of(const Protons& p, MrOptions::Sequence sequence) {
  if (sequence == MrOptions::Sequence::t2) {
    constexpr double kRepetition = 3.0, kEcho = 0.08;  // s
    if (p.flows) return 0.02;
    return p.left * p.share * (1.0 - std::exp(-kRepetition / p.t1_s)) * std::exp(-kEcho / p.t2_s);
  }
  constexpr double kRepetition = 4.5e-3;                     // s
  constexpr double kFlip = 12.0 / 180.0 * std::numbers::pi;  // radians
  constexpr double kRelaxivity = 4.1, kInPlasma = 1.2;       // 1/(mM s), mM
  const double medium = sequence == MrOptions::Sequence::t1_venous ? kInPlasma * p.plasma : 0.0;
  const double e = std::exp(-kRepetition * (1.0 / p.t1_s + kRelaxivity * medium));
  return p.left * p.share * std::sin(kFlip) * (1.0 - e) / (1.0 - e * std::cos(kFlip));
}

using Table = std::vector<std::pair<double, double>>;

Table table_of(const std::vector<Protons>& tissues, MrOptions::Sequence sequence) {
  Table table;
  for (const Protons& one : tissues) table.emplace_back(one.hounsfield, signal_of(one, sequence));
  return table;
}

double looked_up(const Table& table, double hounsfield) {
  if (hounsfield <= table.front().first) return table.front().second;
  for (std::size_t n = 1; n < table.size(); ++n)
    if (hounsfield < table[n].first)
      return mix(table[n - 1].second, table[n].second,
                 (hounsfield - table[n - 1].first) / (table[n].first - table[n - 1].first));
  return table.back().second;
}

}  // namespace

SignalOf signals_of(MrOptions::Sequence sequence) {
  return [soft = table_of(soft_tissues(), sequence), hard = table_of(bones(), sequence)](
             double hounsfield, bool bone) { return looked_up(bone ? hard : soft, hounsfield); };
}

}  // namespace glisson::insilico
