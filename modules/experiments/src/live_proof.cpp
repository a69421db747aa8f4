// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_proof.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "live_faults.h"
#include "live_run.h"
#include "live_stage.h"
#include "live_tally.h"
#include "moved_tissue.h"

namespace glisson::experiments {
namespace {

/// A real pair that is set in motion.
struct RealSet {
  const char* folder;
  const char* title;
  const char* prefix;  ///< of the figures' keys
  RealPair (*read)(const std::filesystem::path& folder);
};
constexpr RealSet kRealSets[] = {
    {"stereo_opencas", "liver tissue, moved", "live_tissue_",
     [](const std::filesystem::path& folder) { return opencas(folder, OpencasPart::tissue); }},
    {"stereo_heart", "silicone heart, moved", "live_heart_", heart}};

constexpr std::uint64_t kDevelopment[] = {101, 102};  ///< limits of guidance::JudgeOptions were set on them
constexpr std::uint64_t kLookedAt[] = {7, 8, 11, 12, 13, 14, 15, 16};  ///< with former programs

/// A moment of its films, to be looked at.
void write_pictures(const std::filesystem::path& folder, const std::string& set, const LiveStage& stage) {
  const std::size_t k = stage.standing.film.size() / 3;
  for (const auto& [name, filmed] : {std::pair{"standing", &stage.standing}, {"held", &stage.held}}) {
    const std::string start = set + "_" + name;
    stereo::write_picture(folder / (start + "_left.png"), filmed->film[k].left);
    stereo::write_picture(folder / (start + "_right.png"), filmed->film[k].right);
  }
}

/// What the runs leave, a line each.
struct Sheets {
  std::string frames = kFrameHeads, lesions = kLesionHeads;
};

/// Every fault on one stage. @return false: cancelled.
bool try_faults(const LiveStage& stage, const std::string& name, std::uint64_t seed,
                const LiveProofOptions& options, LiveTally& gathered, Untried& untried, Sheets& sheets,
                const RunContext& context) {
  const auto faults = live_faults(stage.rig, options.onset, options.frames - 1, seed);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (context.cancelled()) return false;
    context.progress(static_cast<double>(i) / static_cast<double>(faults.size()), "demo.track");
    if (faults[i].name.find(options.only) == std::string::npos || !untried.can_try(stage, faults[i]))
      continue;
    const std::vector<JudgedFrame> frames = run_live(stage, faults[i], options.onset);
    gathered.add(faults[i], frames);
    for (const JudgedFrame& judged : frames) {
      sheets.frames += frame_line(name, faults[i].name, judged);
      sheets.lesions += lesion_lines(name, faults[i].name, judged);
    }
  }
  return true;
}

/// "of seed 15, 16": those of `seeds` that are wanted. Empty: none is.
template <class Wanted>
std::string seeds_named(const std::vector<std::uint64_t>& seeds, const Wanted& wanted) {
  std::string text;
  for (const std::uint64_t seed : seeds)
    if (wanted(seed)) text += (text.empty() ? "of seed " : ", ") + std::to_string(seed);
  return text;
}

}  // namespace

std::string told_of_patients(const std::vector<std::uint64_t>& seeds) {
  const auto is_development = [](std::uint64_t seed) { return std::ranges::count(kDevelopment, seed) > 0; };
  const auto was_looked_at = [](std::uint64_t seed) { return std::ranges::count(kLookedAt, seed) > 0; };
  std::string text;
  const auto tell = [&](const std::string& whom, const char* what) {
    if (!whom.empty()) text += (text.empty() ? "Patients " : "; patients ") + whom + " " + what;
  };
  tell(seeds_named(seeds, is_development), "(in silico) served development: limits were set on them");
  tell(seeds_named(seeds, was_looked_at),
       "(in silico) did not serve to set limits, but were looked at with former programs");
  tell(seeds_named(seeds, [&](std::uint64_t seed) { return !is_development(seed) && !was_looked_at(seed); }),
       "(in silico) did not serve to set limits");
  return text.empty() ? text : text + ".";
}

void LiveProofOptions::validate() const {
  const OptionCheck demand("live proof options");
  demand(!seeds.empty() || !data.empty(), "seeds", 0.0, "Give one at least");
  demand(frames >= 60, "frames", frames, "Give 60 at least");
  demand(onset >= 10 && onset + 20 < frames, "onset", onset, "Give a frame well before the last");
}

Cancellable<LiveProof> prove_live(const LiveProofOptions& options, const std::filesystem::path& folder,
                                  const RunContext& context) {
  options.validate();
  LiveProof proof;
  Sheets sheets;
  LiveTally theatre;
  Untried untried;
  const double part = 1.0 / (static_cast<double>(options.seeds.size()) + 1.0);
  double done = 0.0;
  Filmed former;  // another patient's
  for (const std::uint64_t seed : options.seeds) {
    auto stage = theatre_stage(seed, options.frames, context.part(done, done + 0.4 * part));
    if (!stage) return std::nullopt;
    stage->other = std::move(former);
    if (!try_faults(*stage, std::to_string(seed), seed, options, theatre, untried, sheets,
                    context.part(done + 0.4 * part, done + part)))
      return std::nullopt;
    former = std::move(stage->standing);
    done += part;
  }
  theatre.sum_up("in the theatre", "live_", proof);
  for (const RealSet& set : kRealSets) {
    if (options.data.empty() || !std::filesystem::exists(options.data / set.folder)) {
      proof.absent.emplace_back(set.folder);
      continue;
    }
    const auto stage = pair_stage(set.read(options.data / set.folder), options.frames, 1,
                                  context.part(done, done + 0.1 * part));
    if (!stage) return std::nullopt;
    write_pictures(folder, set.folder, *stage);
    LiveTally gathered;
    if (!try_faults(*stage, set.folder, 1, options, gathered, untried, sheets,
                    context.part(done + 0.1 * part, done + 0.5 * part)))
      return std::nullopt;
    gathered.sum_up(set.title, set.prefix, proof);
    done += 0.5 * part;
  }
  for (const std::string& fault : untried.names()) proof.absent.push_back("fault " + fault);
  std::string table;
  for (const std::string& line : proof.table) table += line + "\n";
  write_file_atomically(folder / "live.csv", sheets.frames);
  write_file_atomically(folder / "lesions.csv", sheets.lesions);
  write_file_atomically(folder / "live.txt", table);
  return proof;
}

}  // namespace glisson::experiments
