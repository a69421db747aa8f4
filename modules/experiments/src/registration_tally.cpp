// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "glisson/core/error.h"
#include "of_none.h"
#include "registration_trials.h"

namespace glisson::experiments {
namespace {

constexpr double kFar = 10e-3, kNear = 3e-3;  ///< metres: registrations over and under

double millimetres(double metres) { return 1e3 * metres; }

const char* proof_set_code(ProofSet set) {
  return set == ProofSet::development ? "development" : "validation";
}

template <class... Values>
std::string text(const char* format, Values... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double value) {
    if (std::isfinite(value)) sum += value, ++count;
  }
  double value() const { return count > 0 ? sum / count : std::nan(""); }
};

std::string shown_mm(const Mean& mean) { return figure_text("%.2f", millimetres(mean.value())); }

/// Mean error, metres, over which a registration with so much seen is to be doubted.
double told_from(double share) { return share < 0.15 ? 6e-3 : share < 0.25 ? 4e-3 : 2.5e-3; }

struct Cell {
  Mean ours, paper, rigid, lesion;
  int doubted = 0, count = 0, failed = 0, untold = 0;
  void add(const RegistrationTrial& trial) {
    doubted += trial.doubted();
    untold += !trial.doubted() && trial.mean > told_from(trial.share);
    ++count;
    if (!std::isfinite(trial.mean)) {
      ++failed;
      return;  // the others are compared on the registrations that there are
    }
    ours.add(trial.mean);
    paper.add(trial.paper_mean);
    rigid.add(trial.rigid_mean);
    lesion.add(trial.worst_lesion());
  }
  /// Over all clouds: a method is not the better for having failed on the hard ones.
  double mean_of_all() const { return failed > 0 ? std::numeric_limits<double>::infinity() : ours.value(); }
};

struct Tally {
  int count = 0, far = 0, far_told = 0, near = 0, near_told = 0, refused = 0, told = 0;
  void add(const RegistrationTrial& trial) {
    ++count;
    refused += trial.refused;
    told += trial.doubted();
    if (trial.worst_lesion() > kFar) ++far, far_told += trial.doubted();
    if (trial.worst_lesion() < kNear) ++near, near_told += trial.doubted();
  }
};

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  Mean of_a, of_b;
  for (const double value : a) of_a.add(value);
  for (const double value : b) of_b.add(value);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i] - of_a.value(), y = b[i] - of_b.value();
    ab += x * y, aa += x * x, bb += y * y;
  }
  return n > 2 && aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : std::nan("");
}

/// What the correlation of expected with found errors is where the expectations are right, and errors are
/// even in three directions. There an error is its expectation times a number of mean 1 and variance kSpread
/// (of the chi distribution with three degrees of freedom): errors scatter however well they are foretold.
double best_correlation(const std::vector<double>& expected) {
  constexpr double kSpread = 3.0 * std::numbers::pi / 8.0 - 1.0;
  double sum = 0.0, squares = 0.0;
  for (const double value : expected) sum += value, squares += value * value;
  const auto n = static_cast<double>(expected.size());
  const double mean = sum / n, square = squares / n, variance = square - mean * mean;
  return n > 2 && variance > 1e-9 * square ? std::sqrt(variance / (square * (1.0 + kSpread) - mean * mean))
                                           : std::nan("");
}

void add_expected(const std::vector<RegistrationTrial>& trials, const std::string& prefix,
                  RegistrationProof& proof) {
  std::vector<double> expected, found;
  int covered = 0, asked = 0;
  for (const RegistrationTrial& trial : trials) {
    if (trial.fault != RegistrationFault::none || trial.refused) continue;
    for (std::size_t i = 0; i < trial.expected.size(); ++i) {
      expected.push_back(trial.expected[i]);
      found.push_back(trial.lesions[i]);
      covered += trial.covered[i];
      ++asked;
    }
  }
  if (asked == 0) return;
  proof.figures[prefix + "expected_correlation"] = correlation(expected, found);
  proof.figures[prefix + "expected_correlation_at_best"] = best_correlation(expected);
  proof.figures[prefix + "expected_coverage"] = covered / static_cast<double>(asked);
  proof.figures[prefix + "expected_outside"] = (asked - covered) / static_cast<double>(asked);
  Mean of_expected, of_found;
  for (const double value : expected) of_expected.add(value);
  for (const double value : found) of_found.add(value);
  proof.figures[prefix + "expected_mean_mm"] = millimetres(of_expected.value());
  proof.figures[prefix + "expected_true_mean_mm"] = millimetres(of_found.value());
}

}  // namespace

std::string csv_of(const std::vector<RegistrationTrial>& trials) {
  std::set<std::string> keys;
  for (const RegistrationTrial& trial : trials)
    for (const auto& [key, value] : trial.figures) keys.insert(key);
  std::string csv =
      "set,patient,handling,share,fault,mean_mm,lesion_1_mm,lesion_2_mm,lesion_3_mm,expected_1_mm,"
      "expected_2_mm,expected_3_mm,rigid_mm,paper_mm,seconds,refused,doubts";
  for (const std::string& key : keys) csv += "," + key;
  csv += "\n";
  for (const RegistrationTrial& trial : trials) {
    csv += text("%s,%s,%s,%.2f,%s,%.3f", proof_set_code(trial.set), trial.patient.c_str(),
                trial.handling.c_str(), trial.share, registration_fault_code(trial.fault),
                millimetres(trial.mean));
    for (const auto* list : {&trial.lesions, &trial.expected})
      for (std::size_t i = 0; i < 3; ++i)
        csv += i < list->size() ? text(",%.3f", millimetres((*list)[i])) : ",";
    csv += text(",%.3f,%.3f,%.2f,%d,", millimetres(trial.rigid_mean), millimetres(trial.paper_mean),
                trial.seconds, trial.refused ? 1 : 0);
    for (std::size_t i = 0; i < trial.doubts.size(); ++i) csv += (i > 0 ? ";" : "") + trial.doubts[i];
    for (const std::string& key : keys) {
      const auto found = trial.figures.find(key);
      csv += found == trial.figures.end() ? "," : text(",%.6g", found->second);
    }
    csv += "\n";
  }
  return csv;
}

namespace {

std::vector<std::string> cut(const std::string& line, char at) {
  std::vector<std::string> parts(1);
  for (const char c : line)
    if (c == at)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

RegistrationFault fault_of(const std::string& code) {
  for (const RegistrationFault fault : kRegistrationFaults)
    if (code == registration_fault_code(fault)) return fault;
  throw std::invalid_argument(code);
}

constexpr std::size_t kOwnColumns = 17;

/// @throws std::invalid_argument, std::out_of_range what is no number.
RegistrationTrial trial_of(const std::vector<std::string>& keys, const std::vector<std::string>& cells) {
  RegistrationTrial trial;
  trial.set =
      cells[0] == proof_set_code(ProofSet::development) ? ProofSet::development : ProofSet::validation;
  trial.patient = cells[1];
  trial.handling = cells[2];
  trial.share = std::stod(cells[3]);
  trial.fault = fault_of(cells[4]);
  trial.mean = 1e-3 * std::stod(cells[5]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!cells[6 + i].empty()) trial.lesions.push_back(1e-3 * std::stod(cells[6 + i]));
    if (!cells[9 + i].empty()) trial.expected.push_back(1e-3 * std::stod(cells[9 + i]));
  }
  trial.rigid_mean = 1e-3 * std::stod(cells[12]);
  trial.paper_mean = 1e-3 * std::stod(cells[13]);
  trial.seconds = std::stod(cells[14]);
  trial.refused = cells[15] == "1";
  if (!cells[16].empty()) trial.doubts = cut(cells[16], ';');
  for (std::size_t k = kOwnColumns; k < cells.size(); ++k)
    if (!cells[k].empty()) trial.figures[keys[k]] = std::stod(cells[k]);
  trial.cover();
  return trial;
}

}  // namespace

std::vector<RegistrationTrial> trials_of(const std::string& csv, const std::filesystem::path& file) {
  std::vector<RegistrationTrial> trials;
  const std::vector<std::string> lines = cut(csv, '\n');
  const std::vector<std::string> keys = cut(lines.front(), ',');
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    const std::vector<std::string> cells = cut(lines[i], ',');
    try {
      if (cells.size() != keys.size() || cells.size() < kOwnColumns) throw std::invalid_argument("columns");
      trials.push_back(trial_of(keys, cells));
    } catch (const std::logic_error&) {
      throw InputError(file.string(), "line " + std::to_string(i + 1), "is no registration",
                       "Start without --resume");
    }
  }
  return trials;
}

void sum_up(const std::vector<RegistrationTrial>& all, ProofSet set, RegistrationProof& proof) {
  std::vector<RegistrationTrial> trials;
  for (const RegistrationTrial& trial : all)
    if (trial.set == set) trials.push_back(trial);
  if (trials.empty()) return;
  std::map<std::pair<std::string, double>, Cell> cells;
  std::map<double, Cell> shares;  // of what is tried with all of them
  Cell others;
  std::map<RegistrationFault, Tally> faults;
  std::map<double, Mean> undoubted;
  Tally sum;
  for (const RegistrationTrial& trial : trials) {
    faults[trial.fault].add(trial);
    sum.add(trial);
    if (trial.fault != RegistrationFault::none) continue;
    cells[{trial.handling, trial.share}].add(trial);
    if (!is_much_tried(trial.handling)) {
      others.add(trial);
      continue;
    }
    shares[trial.share].add(trial);
    if (!trial.doubted()) undoubted[trial.share].add(trial.mean);
  }
  const std::string name = proof_set_code(set), prefix = "registration_" + name + "_";
  proof.table.push_back(name);
  proof.table.emplace_back("handled    seen %  trials  ours mm  paper mm  rigid mm  lesion mm  doubted");
  const auto row = [&](const std::string& what, double share, const Cell& cell) {
    proof.table.push_back(text("%-10s %6.0f %7d %8s %9s %9s %10s %8d", what.c_str(), 100.0 * share,
                               cell.count, shown_mm(cell.ours).c_str(), shown_mm(cell.paper).c_str(),
                               shown_mm(cell.rigid).c_str(), shown_mm(cell.lesion).c_str(), cell.doubted));
  };
  int beaten = 0;
  for (const auto& [key, cell] : cells) {
    row(key.first, key.second, cell);
    beaten += cell.mean_of_all() < cell.rigid.value();
  }
  for (const auto& [share, cell] : shares) {
    row("all", share, cell);
    const std::string at = prefix + std::to_string(std::lround(100.0 * share)) + "_";
    proof.figures[at + "mean_mm"] = millimetres(cell.ours.value());
    proof.figures[at + "all_mean_mm"] = millimetres(cell.mean_of_all());
    proof.figures[at + "failed"] = cell.failed;
    proof.figures[at + "paper_mean_mm"] = millimetres(cell.paper.value());
    proof.figures[at + "rigid_mean_mm"] = millimetres(cell.rigid.value());
    proof.figures[at + "undoubted_mean_mm"] = millimetres(undoubted[share].value());
    proof.figures[at + "undoubted"] = undoubted[share].count;
    proof.figures[at + "untold_share"] = share_of(cell.untold, cell.count);
  }
  if (others.count > 0) {
    row("others", kFaultShare, others);
    proof.figures[prefix + "others_mean_mm"] = millimetres(others.ours.value());
    proof.figures[prefix + "others_rigid_mean_mm"] = millimetres(others.rigid.value());
    proof.figures[prefix + "others_failed"] = others.failed;
    proof.figures[prefix + "others_untold_share"] = share_of(others.untold, others.count);
  }
  proof.table.emplace_back("fault             trials  refused  doubted  >10 mm  told  <3 mm  doubted");
  const auto tell = [&](const std::string& what, const Tally& tally) {
    proof.table.push_back(text("%-17s %6d %8d %8d %7d %5d %6d %8d", what.c_str(), tally.count, tally.refused,
                               tally.told, tally.far, tally.far_told, tally.near, tally.near_told));
  };
  for (const auto& [fault, tally] : faults) tell(registration_fault_code(fault), tally);
  tell("all", sum);
  proof.figures[prefix + "trials"] = sum.count;
  proof.figures[prefix + "far"] = sum.far;
  proof.figures[prefix + "far_told_share"] = share_of(sum.far_told, sum.far);
  proof.figures[prefix + "near"] = sum.near;
  proof.figures[prefix + "near_doubted_share"] = share_of(sum.near_told, sum.near);
  proof.figures[prefix + "rigid_beaten_share"] = share_of(beaten, static_cast<int>(cells.size()));
  add_expected(trials, prefix, proof);
}

}  // namespace glisson::experiments
