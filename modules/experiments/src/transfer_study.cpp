// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/transfer_study.h"

#include <cmath>
#include <limits>

#include "foretold.h"
#include "glisson/core/error.h"
#include "glisson/experiments/atlas_livers.h"
#include "glisson/model/build.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {
using atlas::Member;
using atlas::Structure;

constexpr std::uint64_t kFirstSeed = 9000;  // the proof's livers, which the built-in atlas has not
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double spread_of(const atlas::BuildResult& built, Structure structure) {
  const auto found = built.spreads.find(structure);
  return found == built.spreads.end() ? kNaN : found->second;
}

class Study {
 public:
  Study(const TransferStudyOptions& options, const RunContext& context)
      : options_(options), context_(context) {}

  Cancellable<TransferStudy> run() {
    const bool real = there("liver_labelmaps");
    if (!in_silico(context_.part(0.0, real ? 0.4 : 1.0))) return {};
    if (real && !of_patients(context_.part(0.4, 1.0))) return {};
    return std::move(study_);
  }

 private:
  bool there(const char* folder) {
    if (fs::is_directory(options_.data / folder)) return true;
    study_.absent.emplace_back(folder);
    return false;
  }

  Member synthetic(int number) const {
    return synthetic_member(kFirstSeed + options_.seed * 100 + static_cast<std::uint64_t>(number));
  }

  std::optional<atlas::BuildResult> built(std::vector<Member> members, bool real, const RunContext& context) {
    auto result = atlas::build(std::move(members), *options_.base, {}, context);
    if (!result) return {};
    for (const atlas::LeftOut& liver : result->left_out) study_.rows.push_back(row_of(liver, real, false));
    return result;
  }

  /// On livers that are not the atlas' own.
  bool lay(const atlas::Atlas& atlas, const std::vector<Member>& livers, bool real,
           const RunContext& context) {
    for (std::size_t i = 0; i < livers.size(); ++i) {
      context.progress(static_cast<double>(i) / static_cast<double>(livers.size()), "atlas.fit");
      const auto liver = foretold(atlas, livers[i], context);
      if (!liver) return false;
      study_.rows.push_back(row_of(*liver, real, true));
    }
    return true;
  }

  bool in_silico(const RunContext& context) {
    std::vector<Member> inside, outside;
    for (int i = 0; i < options_.livers; ++i) inside.push_back(synthetic(i));
    for (int i = 0; i < options_.outside; ++i) outside.push_back(synthetic(options_.livers + i));
    const auto result = built(std::move(inside), false, context.part(0.0, 0.85));
    if (!result) return false;
    study_.notch_spread = spread_of(*result, Structure::umbilical_notch);
    study_.cava_spread = spread_of(*result, Structure::vena_cava);
    return lay(result->atlas, outside, false, context.part(0.85, 1.0));
  }

  bool of_patients(const RunContext& context) {
    std::vector<std::string> names = label_map_names(options_.data);
    std::erase_if(names, [](const std::string& name) { return !is_for_development(name); });
    std::vector<Member> members;
    for (const std::string& name : names) {
      context.progress(0.35 * static_cast<double>(members.size()) / static_cast<double>(names.size()),
                       "atlas.livers");
      auto member = label_map_member(options_.data, name, context.quiet());
      if (!member) return false;
      members.push_back(std::move(*member));
    }
    const auto result = built(std::move(members), true, context.part(0.35, 0.9));
    if (!result) return false;
    study_.real_cava_spread = spread_of(*result, Structure::vena_cava);
    if (!there("liver_models")) return true;
    // Its vessels show neither vena cava nor notch.
    const auto surfaces = model::read_surfaces(options_.data / "liver_models", LengthUnit::millimetre);
    return lay(result->atlas, {{"liver_models", surfaces.liver, {}}}, true, context.part(0.9, 1.0));
  }

  const TransferStudyOptions& options_;
  const RunContext& context_;
  TransferStudy study_{{}, kNaN, kNaN, kNaN, {}};
};

}  // namespace

TransferStudyOptions TransferStudyOptions::quick() {
  TransferStudyOptions options;
  options.livers = 5;
  options.outside = 1;
  return options;
}

void TransferStudyOptions::validate() const {
  if (!base) throw InputError("transfer study", "base", "is not there", "Give the built-in atlas");
  const OptionCheck demand("transfer study");
  demand(livers >= 5 && livers <= 90, "livers", livers, "Give 5 to 90");
  demand(outside >= 0 && outside <= 10, "outside", outside, "Give 0 to 10");
}

TransferRow row_of(const atlas::LeftOut& foretold, bool real, bool outside) {
  TransferRow row{foretold.name,         real, outside, foretold.mean_distance,
                  foretold.max_distance, kNaN, kNaN,    kNaN};
  if (const auto notch = foretold.structures.find(Structure::umbilical_notch);
      notch != foretold.structures.end() && !real)
    row.notch = notch->second.mean_error;
  if (const auto cava = foretold.structures.find(Structure::vena_cava); cava != foretold.structures.end()) {
    row.cava = cava->second.area_distance;
    row.cava_largest = cava->second.area_largest;
  }
  return row;
}

Cancellable<TransferStudy> study_transfer(const TransferStudyOptions& options, const RunContext& context) {
  options.validate();
  return Study(options, context).run();
}

}  // namespace glisson::experiments
