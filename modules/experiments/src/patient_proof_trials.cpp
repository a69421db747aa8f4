// SPDX-License-Identifier: GPL-3.0-or-later
#include "patient_proof_trials.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/core/stopwatch.h"
#include "glisson/insilico/altered_ct.h"
#include "glisson/insilico/layperson.h"
#include "glisson/insilico/operator.h"
#include "glisson/insilico/pathology.h"
#include "glisson/segmentation/correct_around.h"
#include "glisson/segmentation/evaluate.h"
#include "glisson/segmentation/propose_seeds.h"
#include "glisson/volume/io.h"
#include "glisson/volume/morphology.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

constexpr double kLeastLesion = 1.0;  // ml: a smaller one is not clicked
constexpr std::uint64_t kCorrections = 3;

using Bytes = std::vector<std::uint8_t>;

struct Trial {
  std::string name;
  const char* kind;  ///< of the CT, as the figures name it
  Image ct;
  LabelMap truth;
};
constexpr const char *kReal = "real", *kAltered = "altered", *kSynthetic = "synthetic";

/// The largest distance from the boundary of either mask to the other mask's, mm.
double worst_distance_mm(const VolumeGrid& grid, const Bytes& a, const Bytes& b) {
  Bytes either = a;
  for (std::size_t i = 0; i < either.size(); ++i) either[i] = a[i] != 0 || b[i] != 0;
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, either, 3.0);
  if (box.empty()) return 0.0;
  const Mask one = crop(grid.size, grid.spacing_mm, a, box), two = crop(grid.size, grid.spacing_mm, b, box);
  if (one.count() == 0 || two.count() == 0) return std::nan("");
  // Only where the masks differ can either reach beyond the other.
  const auto beyond = [](const Mask& in, const Mask& of) {
    const std::vector<float> distance2 = squared_distance_mm2(of);
    float most = 0.0F;
    for (std::size_t i = 0; i < in.voxels.size(); ++i)
      if (in.voxels[i] != 0) most = std::max(most, distance2[i]);
    return std::sqrt(static_cast<double>(most));
  };
  return std::max(beyond(one, two), beyond(two, one));
}

Bytes is(const LabelMap& labels, Label wanted) {
  return labels.voxels.mask([&](Label label) { return label == wanted; });
}

/// The truth's lesions that are clicked, in the order of the seeds.
std::vector<Label> clicked_lesions(const LabelMap& truth) {
  std::vector<Label> clicked;
  const std::vector<long> counts = truth.voxels.histogram();
  for (std::size_t label = 0; label < counts.size(); ++label)
    if (is_lesion(static_cast<Label>(label)) && counts[label] > 0 &&
        1e-3 * static_cast<double>(counts[label]) * truth.voxels.grid().voxel_volume_mm3() >= kLeastLesion)
      clicked.push_back(static_cast<Label>(label));
  return clicked;
}

std::string line_of(const char* format, const std::string& name, const std::string& rest) {
  char text[180];
  std::snprintf(text, sizeof text, format, name.c_str(), rest.c_str());
  return text;
}

std::string number(const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// A column with the median; blank where there is nothing.
std::string median_column(int width, std::vector<double> values) {
  if (values.empty()) return std::string(static_cast<std::size_t>(width), ' ');
  std::sort(values.begin(), values.end());
  char text[40];
  std::snprintf(text, sizeof text, "%*.3f", width, interpolated_percentile(values, 0.5));
  return text;
}

class Trials {
 public:
  explicit Trials(PatientProof& proof) : proof_(proof) {
    proof_.table.push_back(
        line_of("%-32s%s", "trial",
                "clicks  Dice  worst mm    ml  true ml  corrected  clicks  Dice  lesions  drawn  unclicked  "
                "portal  hepatic  seconds"));
  }

  /// Ten clicks, and three corrections; then with a click on each lesion, and with a line across each
  /// instead; vessels on the labels of the ten clicks. False: cancelled.
  bool run(const Trial& trial, std::uint64_t seed, const RunContext& context) {
    insilico::LaypersonOptions hand;
    hand.seed = seed;
    const Bytes truth = inside_liver(trial.truth);
    const segmentation::Seeds ten = insilico::click_as_layperson(trial.ct, trial.truth, hand);
    const auto plain = segment(trial, ten, context.part(0.0, 0.4));
    if (!plain) return false;
    const double seconds = seconds_;
    const auto corrected = dice_corrected(trial, truth, ten, plain->labels, context.quiet());
    if (!corrected) return false;
    hand.least_lesion_ml = kLeastLesion;
    const segmentation::Seeds seeds = insilico::click_as_layperson(trial.ct, trial.truth, hand);
    const auto more = segment(trial, seeds, context.part(0.4, 0.7));
    if (!more) return false;
    const std::vector<double> lesions = lesion_dice(trial, more->labels);
    std::vector<double> drawn;
    if (!lesions.empty()) {
      hand.draws_lesions = true;
      const auto across =
          segment(trial, insilico::click_as_layperson(trial.ct, trial.truth, hand), context.part(0.7, 1.0));
      if (!across) return false;
      drawn = lesion_dice(trial, across->labels);
    }
    const auto unclicked = dice_unclicked(trial, truth, context.quiet());
    if (!unclicked) return false;
    const auto trees = tree_dice(trial, truth, plain->labels, seed, context.quiet());
    if (!trees) return false;
    const Bytes found = inside_liver(plain->labels);
    const double voxel_mm3 = trial.ct.grid.voxel_volume_mm3();
    const auto all = segmentation::agreement(found, truth, voxel_mm3);
    const double with_lesions = segmentation::dice(inside_liver(more->labels), truth);
    const auto clicks = seeds.liver.rows() + seeds.background.rows();
    proof_.table.push_back(line_of(
        "%-32s%s", trial.name + (trial.kind == kSynthetic ? "" : std::string(" (") + trial.kind + ")"),
        number("%6.0f", static_cast<double>(clicks)) + number("%6.3f", all.dice) +
            number("%10.1f", worst_distance_mm(trial.ct.grid, found, truth)) + number("%6.0f", all.ml) +
            number("%9.0f", all.truth_ml) + number("%11.3f", *corrected) +
            number("%8.0f", static_cast<double>(clicks) + static_cast<double>(seeds.lesions.size())) +
            number("%6.3f", with_lesions) + median_column(9, lesions) + median_column(7, drawn) +
            number("%11.3f", *unclicked) + median_column(8, trees->portal) +
            median_column(9, trees->hepatic) + number("%9.1f", seconds)));
    const auto add = [&](const std::string& what, const std::vector<double>& these) {
      std::vector<double>& to = found_[trial.kind + ("_dice_" + what)];
      to.insert(to.end(), these.begin(), these.end());
    };
    add("liver", {all.dice});
    add("corrected_liver", {*corrected});
    add("unclicked_liver", {*unclicked});
    add("portal_vein", trees->portal);
    add("hepatic_veins", trees->hepatic);
    add("lesion", lesions);
    add("drawn_lesion", drawn);
    slowest_ = std::max(slowest_, seconds);
    return true;
  }

  void finish() {
    for (auto& [what, values] : found_) {
      if (values.empty()) continue;
      std::sort(values.begin(), values.end());
      proof_.figures["trial_" + what + "_worst"] = values.front();
      proof_.figures["trial_" + what + "_median"] = interpolated_percentile(values, 0.5);
    }
    proof_.figures["trial_seconds_longest"] = slowest_;
    proof_.figures["trial_correction_seconds_longest"] = slowest_correction_;
  }

 private:
  /// Of the liver that is proposed; 0 where none is. Cancelled: empty.
  Cancellable<double> dice_unclicked(const Trial& trial, const Bytes& truth, const RunContext& context) {
    segmentation::Seeds seeds;
    try {
      auto proposed = segmentation::propose_liver_seeds(trial.ct, context);
      if (!proposed) return std::nullopt;
      seeds.liver = std::move(*proposed);
    } catch (const InputError&) {
      return 0.0;
    }
    const auto result = segment(trial, seeds, context);
    if (!result) return std::nullopt;
    return segmentation::dice(inside_liver(result->labels), truth);
  }

  /// Dice of both trees in the true liver; nothing where the truth has none.
  struct TreeDice {
    std::vector<double> portal, hepatic;
  };
  /// Grown from an operator's clicks on the labels of the ten clicks.
  static Cancellable<TreeDice> tree_dice(const Trial& trial, const Bytes& liver, const LabelMap& labels,
                                         std::uint64_t seed, const RunContext& context) {
    TreeDice dice;
    const std::vector<long> present = trial.truth.voxels.histogram();
    if (present.size() <= structure::kHepaticVeins || present[structure::kPortalVein] == 0) return dice;
    insilico::OperatorOptions hand;
    hand.seed = seed;
    segmentation::SegmentationOptions options;
    options.structures = {false, true, true, true, false, false};
    const auto found =
        segmentation::segment(trial.ct, insilico::click_seeds(trial.truth, hand), options, context, &labels);
    if (!found) return std::nullopt;
    // A tree that is told as not seen counts as not found: 0.
    const auto measure = [&](Label tree, std::vector<double>& to) {
      Bytes one = is(found->labels, tree), other = is(trial.truth, tree);
      for (std::size_t i = 0; i < liver.size(); ++i)
        if (liver[i] == 0) one[i] = other[i] = 0;
      to.push_back(segmentation::dice(one, other));
    };
    measure(structure::kPortalVein, dice.portal);
    measure(structure::kHepaticVeins, dice.hepatic);
    return dice;
  }

  /// After three clicks, each where the labels are then most deeply wrong. Cancelled: empty.
  Cancellable<double> dice_corrected(const Trial& trial, const Bytes& truth, segmentation::Seeds seeds,
                                     LabelMap labels, const RunContext& context) {
    for (std::uint64_t n = 0; n < kCorrections; ++n) {
      const auto click = insilico::correct_as_layperson(trial.truth, labels, n + 1);
      if (!click) break;
      const Stopwatch watch;
      auto corrected = segmentation::correct_around(trial.ct, labels, seeds, *click, {}, context);
      slowest_correction_ = std::max(slowest_correction_, watch.seconds());
      if (!corrected) return std::nullopt;
      labels = std::move(corrected->labels);
      Points& clicks = click->is_liver ? seeds.liver : seeds.background;
      clicks.conservativeResize(clicks.rows() + 1, 3);
      clicks.row(clicks.rows() - 1) = click->p_in_ct.xyz.transpose();
    }
    return segmentation::dice(inside_liver(labels), truth);
  }

  /// Of each lesion with the truth's that was clicked.
  static std::vector<double> lesion_dice(const Trial& trial, const LabelMap& found) {
    std::vector<double> each;
    for (const Label truth : clicked_lesions(trial.truth))
      each.push_back(segmentation::dice(is(found, static_cast<Label>(structure::kFirstLesion + each.size())),
                                        is(trial.truth, truth)));
    return each;
  }

  Cancellable<segmentation::Segmented> segment(const Trial& trial, const segmentation::Seeds& seeds,
                                               const RunContext& context) {
    const Stopwatch watch;
    auto result = segmentation::segment(trial.ct, seeds, {}, context);
    seconds_ = watch.seconds();
    return result;
  }

  PatientProof& proof_;
  std::map<std::string, std::vector<double>> found_;  ///< by kind and what was measured
  double seconds_ = 0.0, slowest_ = 0.0, slowest_correction_ = 0.0;
};

std::optional<Trial> real_trial(const PatientProofOptions& options, const std::string& name,
                                PatientProof& proof, const RunContext& context) {
  const fs::path folder = options.data / name;
  if (!fs::exists(folder)) {
    if (std::find(proof.absent.begin(), proof.absent.end(), name) == proof.absent.end())
      proof.absent.push_back(name);
    return {};
  }
  Trial trial;
  trial.name = name;
  trial.kind = kReal;
  const bool first = fs::exists(folder / "PATIENT_DICOM.tar.gz");
  auto ct = read_image(folder / (first ? "PATIENT_DICOM.tar.gz" : "DICOM.tar.gz"), context);
  if (!ct) return {};
  trial.ct = std::move(*ct);
  if (first) {
    const fs::path file = folder / "3Dircadb0101Labeled.vti";
    trial.truth =
        recode(read_labels(file), read_label_codes(options.clicks / "3dircadb1_codes.json"), file.string());
    insilico::split_lesions(trial.truth, kLeastLesion);
  } else {
    const LabelFile labels = read_labels(folder / "liver.nrrd");
    std::vector<Label> dense = labels.voxels.dense();
    for (Label& label : dense) label = label != 0 ? structure::kParenchyma : Label{0};
    trial.truth = {LabelVolume(labels.voxels.grid(), dense), {structure_info(structure::kParenchyma)}};
  }
  return trial;
}

/// The same whichever CTs are there. @param number of the CT, from 0.
std::uint64_t clicks_on_ct(std::uint64_t seed, std::size_t number) { return 1000 * seed + number + 1; }

/// False: cancelled.
bool run_altered(const Trial& real, std::uint64_t seed, std::uint64_t place, Trials& trials,
                 const RunContext& context) {
  for (const insilico::Alteration& alteration : insilico::alterations()) {
    auto made = insilico::altered_ct(real.ct, real.truth, alteration, seed, context.quiet());
    if (!made) return false;
    const Trial trial{alteration.name, kAltered, std::move(made->ct), std::move(made->truth)};
    if (!trials.run(trial, ++place + 100, context.quiet())) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> tried_cts(std::uint64_t seed) {
  std::vector<std::string> cts{"ct_ircad1"};
  if (seed == 1) cts.emplace_back("ct_chaos3");
  return cts;
}

std::vector<std::string> unused_cts(const fs::path& data, std::uint64_t seed) {
  std::vector<std::string> unused;
  if (!fs::is_directory(data)) return unused;
  const std::vector<std::string> tried = tried_cts(seed);
  for (const auto& entry : fs::directory_iterator(data)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("ct_") && std::find(tried.begin(), tried.end(), name) == tried.end())
      unused.push_back(name);
  }
  std::sort(unused.begin(), unused.end());
  return unused;
}

std::uint64_t clicks_on_pathology(std::uint64_t seed, std::size_t number) {
  return clicks_on_ct(seed, tried_cts(seed).size() + number);
}

bool run_trials(const PatientProofOptions& options, PatientProof& proof, const RunContext& context) {
  Trials trials(proof);
  const std::vector<std::string> reals = tried_cts(options.seed);
  for (std::size_t n = 0; n < reals.size(); ++n) {
    const auto trial = real_trial(options, reals[n], proof, context.quiet());
    if (context.cancelled()) return false;
    const std::uint64_t place = clicks_on_ct(options.seed, n);
    if (trial && !trials.run(*trial, place, context.quiet())) return false;
    // Alterations need the expert's lesions and vena cava.
    if (trial && !clicked_lesions(trial->truth).empty() &&
        !run_altered(*trial, options.seed, place, trials, context))
      return false;
  }
  const auto pathologies =
      options.synthetic ? insilico::pathologies(options.seed) : std::vector<insilico::Pathology>{};
  for (std::size_t n = 0; n < pathologies.size(); ++n) {
    if (pathologies[n].name.find(options.only) == std::string::npos) continue;
    context.progress(static_cast<double>(n) / static_cast<double>(pathologies.size()), "patient.ct");
    auto made = insilico::make_pathology_ct(pathologies[n], context.quiet());
    if (!made) return false;
    const Trial trial{pathologies[n].name, kSynthetic, std::move(made->ct), std::move(made->truth)};
    if (!trials.run(trial, clicks_on_pathology(options.seed, n), context.quiet())) return false;
  }
  trials.finish();
  proof.unused = unused_cts(options.data, options.seed);
  return true;
}

}  // namespace glisson::experiments
