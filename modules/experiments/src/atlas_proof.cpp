// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas_proof.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "foretold.h"
#include "glisson/atlas/correspond.h"
#include "glisson/atlas/transfer.h"
#include "glisson/core/error.h"
#include "glisson/core/stopwatch.h"
#include "glisson/experiments/atlas_livers.h"
#include "landmark_effect.h"
#include "readings.h"

namespace glisson::experiments {
namespace {
using atlas::LeftOut;
using atlas::LeftOutStructure;
using atlas::Member;
using atlas::Structure;

constexpr std::uint64_t kFirstSeed = 9000;  // of livers that the built-in atlas has not

/// Mean and worst over livers, and the share of points within their ellipsoids; of none nothing.
void add(Figures& figures, const std::string& prefix, const std::vector<LeftOut>& livers) {
  if (livers.empty()) return;
  std::map<Structure, std::vector<LeftOutStructure>> found;
  double surface = 0.0, worst = 0.0;
  for (const LeftOut& liver : livers) {
    surface += liver.mean_distance / static_cast<double>(livers.size());
    worst = std::max(worst, liver.mean_distance);
    for (const auto& [structure, one] : liver.structures) found[structure].push_back(one);
  }
  figures[prefix + "surface_mean_mm"] = 1e3 * surface;
  figures[prefix + "surface_worst_mm"] = 1e3 * worst;
  double all_inside = 0.0, all_points = 0.0;
  for (const auto& [structure, all] : found) {
    const std::string key = prefix + atlas::structure_code(structure) + "_";
    double inside = 0.0, points = 0.0;
    Figures sums;
    for (const LeftOutStructure& one : all) {
      sums["mean_mm"] += 1e3 * one.mean_error;
      sums["deviation_mm"] += 1e3 * one.deviation;
      if (atlas::is_area(structure)) sums["area_mean_mm"] += 1e3 * one.area_distance;
      figures[key + "worst_mm"] = std::max(figures[key + "worst_mm"], 1e3 * one.mean_error);
      if (atlas::is_area(structure))
        figures[key + "area_worst_mm"] = std::max(figures[key + "area_worst_mm"], 1e3 * one.area_distance);
      inside += one.inside;
      points += one.points;
    }
    for (const auto& [name, sum] : sums) figures[key + name] = sum / static_cast<double>(all.size());
    figures[key + "livers"] = static_cast<double>(all.size());
    figures[key + "inside_share"] = inside / points;
    all_inside += inside;
    all_points += points;
  }
  if (all_points > 0.0) figures[prefix + "inside_share"] = all_inside / all_points;
}

std::string row(const LeftOut& liver, const char* how) {
  char text[160];
  const auto shown = [&](Structure structure, bool of_area) {
    const auto found = liver.structures.find(structure);
    if (found == liver.structures.end()) return std::string("      -");
    char number[16];
    std::snprintf(number, sizeof number, "%7.1f",
                  1e3 * (of_area ? found->second.area_distance : found->second.mean_error));
    return std::string(number);
  };
  std::snprintf(text, sizeof text, "%-6s %-9s %7.2f %s %s %s %s %s %s %s %8.2f", liver.name.c_str(), how,
                1e3 * liver.mean_distance, shown(Structure::vena_cava, false).c_str(),
                shown(Structure::vena_cava, true).c_str(), shown(Structure::portal_entrance, false).c_str(),
                shown(Structure::gallbladder_bed, false).c_str(),
                shown(Structure::umbilical_notch, false).c_str(),
                shown(Structure::falciform_line, false).c_str(),
                shown(Structure::anterior_margin, false).c_str(), liver.unusual);
  return text;
}

class Proof {
 public:
  Proof(const AtlasProofOptions& options, const RunContext& context) : options_(options), context_(context) {}

  Cancellable<AtlasProof> run() {
    if (options_.synthetic && !synthetic(context_.part(0.0, 0.1))) return {};
    if (options_.synthetic && options_.effect_patients > 0 && !effect(context_.part(0.1, 0.35))) return {};
    std::vector<std::string> names = label_map_names(options_.data);
    if (!options_.validation)
      std::erase_if(names, [](const std::string& name) { return !is_for_development(name); });
    if (names.empty()) {
      proof_.absent.emplace_back("liver_labelmaps");
      return std::move(proof_);
    }
    if (!read(names, context_.part(0.35, 0.45))) return {};
    proof_.table.emplace_back(
        "liver  foretold  surface cava mm area mm  portal     bed   notch falcif.  margin  unusual");
    if (!built_in(context_.part(0.45, 0.55))) return {};
    if (!real(context_.part(0.55, 1.0))) return {};
    return std::move(proof_);
  }

 private:
  std::optional<atlas::BuildResult> built(const std::vector<Member>& members, const RunContext& context) {
    atlas::BuildOptions options;
    const Stopwatch watch;
    auto result = atlas::build(members, *options_.built_in, options, context);
    seconds_ = watch.seconds();
    return result;
  }

  bool synthetic(const RunContext& context) {
    std::vector<Member> members;
    members.reserve(static_cast<std::size_t>(options_.livers));
    for (int i = 0; i < options_.livers; ++i)
      members.push_back(synthetic_member(kFirstSeed + options_.seed * 100 + static_cast<std::uint64_t>(i)));
    const auto result = built(members, context);
    if (!result) return false;
    add(proof_.figures, "synthetic_", result->left_out);
    return true;
  }

  bool effect(const RunContext& context) {
    LandmarkEffectOptions options;
    options.atlas = options_.built_in;
    options.seed = options_.seed;
    options.patients = options_.effect_patients;
    auto measured = measure_landmark_effect(options, context);
    if (!measured) return false;
    proof_.figures.merge(measured->figures);
    proof_.table = std::move(measured->table);
    proof_.table.emplace_back();
    return true;
  }

  bool read(const std::vector<std::string>& names, const RunContext& context) {
    Readings readings;
    if (std::filesystem::exists(options_.readings))
      readings = read_readings(options_.readings);
    else
      proof_.absent.emplace_back("liver_labelmaps_readings.json");
    proof_.figures.merge(apart(readings));
    for (std::size_t i = 0; i < names.size(); ++i) {
      auto liver = label_map_liver(options_.data, names[i], context.quiet());
      if (!liver) return false;
      liver->member.structures.merge(truth_of(readings[names[i]]));
      members_.push_back(std::move(liver->member));
      portal_veins_.push_back(std::move(liver->portal_vein));
      context.progress(static_cast<double>(i + 1) / static_cast<double>(names.size()), "atlas.livers");
    }
    return true;
  }

  bool real(const RunContext& context) {
    const auto result = built(members_, context);
    if (!result) return false;
    std::vector<LeftOut> even, odd;
    for (const LeftOut& liver : result->left_out) {
      (is_for_development(liver.name) ? even : odd).push_back(liver);
      proof_.table.push_back(row(liver, "others"));
    }
    for (const std::string& note : result->notes) proof_.table.push_back("told: " + note);
    add(proof_.figures, "real_", result->left_out);
    add(proof_.figures, "real_even_", even);
    add(proof_.figures, "real_odd_", odd);
    proof_.figures["real_build_s"] = seconds_;
    proof_.figures["real_modes"] = result->quality.compactness_modes;
    proof_.figures["real_generality_mm"] = 1e3 * result->quality.generality;
    proof_.figures["real_specificity_mm"] = 1e3 * result->quality.specificity;
    return true;
  }

  /// A liver laid on once, and what is proposed there as more and more becomes known. False: cancelled.
  bool lay_on(std::size_t i, const RunContext& context) {
    const Member& member = members_[i];
    const Stopwatch watch;
    const auto bare = atlas::transfer(*options_.built_in, member.liver, {}, context.quiet());
    if (!bare) return false;
    slowest_s_ = std::max(slowest_s_, watch.seconds());
    keep("built-in", built_in_, judged(*bare, member));
    atlas::Evidence vein, notch;
    vein.portal_vein = portal_veins_[i];
    keep("and vein", with_vein_, judged(told(*bare, member.liver, vein), member));
    const auto marked = member.structures.find(Structure::umbilical_notch);
    if (marked == member.structures.end()) return true;
    notch.placed.insert(*marked);
    LeftOut others = judged(told(*bare, member.liver, notch), member);
    others.structures.erase(Structure::umbilical_notch);
    keep("and notch", with_notch_, std::move(others));
    return true;
  }

  void keep(const char* how, std::vector<LeftOut>& livers, LeftOut liver) {
    proof_.table.push_back(row(liver, how));
    livers.push_back(std::move(liver));
  }

  /// Of all, and of those of even and of odd numbers apart.
  void add_all(const std::string& prefix, const std::vector<LeftOut>& livers) {
    std::vector<LeftOut> even, odd;
    for (const LeftOut& liver : livers) (is_for_development(liver.name) ? even : odd).push_back(liver);
    add(proof_.figures, prefix + "even_", even);
    add(proof_.figures, prefix + "odd_", odd);
    add(proof_.figures, prefix, livers);
  }

  /// What is refused here, though it is a liver, stays out of what follows.
  bool built_in(const RunContext& context) {
    std::vector<Member> taken;
    double refused = 0.0, said = 0.0;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      const std::vector<std::string> mirrored = complaints_about_mirrored(members_[i]);
      if (std::find(mirrored.begin(), mirrored.end(), kRefused) != mirrored.end()) refused += 1.0;
      if (!mirrored.empty()) said += 1.0;
      try {
        if (!lay_on(i, context)) return false;
        taken.push_back(members_[i]);
      } catch (const InputError&) {
        proof_.table.push_back(members_[i].name + "   refused as mirrored, wrongly");
      }
      context.progress(static_cast<double>(i + 1) / static_cast<double>(members_.size()), "atlas.fit");
    }
    const auto count = static_cast<double>(members_.size());
    proof_.figures["wrongly_refused_livers"] = count - static_cast<double>(taken.size());
    proof_.figures["mirrored_refused_share"] = refused / count;
    proof_.figures["mirrored_refused_or_doubted_share"] = said / count;
    proof_.figures["transfer_slowest_s"] = slowest_s_;
    add_all("built_in_", built_in_);
    add_all("with_vein_", with_vein_);
    add_all("with_notch_", with_notch_);
    members_ = std::move(taken);
    return true;
  }

  /// What is said of the mirrored liver's left and right.
  std::vector<std::string> complaints_about_mirrored(const Member& member) const {
    TriangleMesh mirrored = member.liver;
    mirrored.vertices.col(0) *= -1.0;
    mirrored.triangles.col(1).swap(mirrored.triangles.col(2));
    try {
      const auto made = atlas::transfer(*options_.built_in, mirrored, {}, context_.quiet());
      std::vector<std::string> said;
      if (made)
        std::copy_if(made->doubts.begin(), made->doubts.end(), std::back_inserter(said),
                     [](const std::string& doubt) { return doubt == "atlas.perhaps_mirrored"; });
      return said;
    } catch (const InputError&) {
      return {kRefused};
    }
  }

  static constexpr const char* kRefused = "refused";
  const AtlasProofOptions& options_;
  const RunContext& context_;
  AtlasProof proof_;
  std::vector<Member> members_;
  std::vector<std::vector<VesselTree>> portal_veins_;  ///< of those that were read
  double seconds_ = 0.0, slowest_s_ = 0.0;
  std::vector<LeftOut> built_in_, with_vein_, with_notch_;
};

}  // namespace

void AtlasProofOptions::validate() const {
  if (!built_in) throw InputError("atlas proof", "built_in", "is not there", "Give the built-in atlas");
  const OptionCheck demand("atlas proof");
  demand(livers >= 5 && livers <= 50, "livers", livers, "Give 5 to 50");
  demand(effect_patients >= 0, "effect_patients", effect_patients, "Give 0 or more");
}

Cancellable<AtlasProof> prove_atlas(const AtlasProofOptions& options, const RunContext& context) {
  options.validate();
  return Proof(options, context).run();
}

}  // namespace glisson::experiments
