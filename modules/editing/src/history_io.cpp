// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/editing/history.h"

namespace glisson::editing {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

using BrickPointer = std::shared_ptr<const LabelVolume::Brick>;

constexpr const char* kRemedy = "Delete the folder 'history' of the case: only the undo steps are lost";
/// Bricks stand in a volume of 16 x 16 x n bricks of their own, which any program can read.
constexpr int kRow = 16;

json info_entry(const LabelInfo& info) {
  return {{"code", info.code},
          {"name", info.name},
          {"terminology", info.terminology},
          {"colour", info.colour},
          {"status", info.status}};
}

LabelInfo info_of(const json& entry) {
  return {entry.at("code").get<Label>(), entry.at("name").get<std::string>(),
          entry.at("terminology").get<std::string>(), entry.at("colour").get<std::array<double, 3>>(),
          entry.at("status").get<std::string>()};
}

json info_entries(const std::vector<LabelInfo>& infos) {
  json list = json::array();
  for (const LabelInfo& info : infos) list.push_back(info_entry(info));
  return list;
}

std::vector<LabelInfo> infos_of(const json& list) {
  std::vector<LabelInfo> infos;
  for (const json& entry : list) infos.push_back(info_of(entry));
  return infos;
}

/// Numbers for bricks, each once, in the order in which they come; nothing is -1.
class BrickBook {
 public:
  int number(const BrickPointer& brick) {
    if (!brick) return -1;
    const auto [place, is_new] = numbers_.emplace(brick.get(), static_cast<int>(bricks_.size()));
    if (is_new) bricks_.push_back(brick);
    return place->second;
  }
  LabelVolume volume() const {
    VolumeGrid grid;
    const int layers = (static_cast<int>(bricks_.size()) + kRow * kRow - 1) / (kRow * kRow);
    grid.size = LabelVolume::kSide * Eigen::Vector3i(kRow, kRow, std::max(1, layers));
    LabelVolume volume(grid);
    for (std::size_t n = 0; n < bricks_.size(); ++n) volume.set_brick(n, bricks_[n]);
    return volume;
  }

 private:
  std::map<const LabelVolume::Brick*, int> numbers_;
  std::vector<BrickPointer> bricks_;
};

json step_entry(const History::Step& step, BrickBook& book) {
  json changes = json::array();
  for (const LabelChange& change : step.changes)
    changes.push_back({change.number, book.number(change.before), book.number(change.after)});
  return {{"tool", step.name.code},
          {"label", step.name.label},
          {"size_mm", 1e3 * step.name.size},
          {"bricks", changes},
          {"infos_before", info_entries(step.infos_before)},
          {"infos_after", info_entries(step.infos_after)},
          {"notes_before", step.notes_before},
          {"notes_after", step.notes_after}};
}

History::Step step_of(const json& entry, const LabelVolume& bricks, std::size_t brick_count,
                      const std::string& file) {
  const auto brick = [&](int number) -> BrickPointer {
    if (number < 0) return nullptr;
    if (static_cast<std::size_t>(number) >= bricks.brick_count())
      throw InputError(file, "bricks", "brick " + std::to_string(number) + " is missing", kRemedy);
    return bricks.brick(static_cast<std::size_t>(number));
  };
  History::Step step;
  step.name = {entry.at("tool").get<std::string>(), entry.at("label").get<Label>(),
               1e-3 * entry.at("size_mm").get<double>()};
  for (const json& change : entry.at("bricks")) {
    const auto number = change.at(0).get<std::size_t>();
    if (number >= brick_count) throw InputError(file, "bricks", "belongs to labels of another size", kRemedy);
    step.changes.push_back({number, brick(change.at(1).get<int>()), brick(change.at(2).get<int>())});
  }
  step.infos_before = infos_of(entry.at("infos_before"));
  step.infos_after = infos_of(entry.at("infos_after"));
  const std::vector<std::string> none;  // in cases of before
  step.notes_before = entry.value("notes_before", none);
  step.notes_after = entry.value("notes_after", none);
  return step;
}

/// Labels that are led step by step: the bricks that have changed since, over the others.
class Way {
 public:
  explicit Way(const LabelVolume& labels) : labels_(labels) {}
  /// @return false: the step does not begin where the way has come to; back: does not end there.
  bool go(const History::Step& step, bool back) {
    for (const LabelChange& change : step.changes) {
      const auto [place, is_new] = now_.try_emplace(change.number);
      if (is_new) place->second = labels_.brick(change.number);
      if (!is_same(place->second, back ? change.after : change.before)) return false;
      place->second = back ? change.before : change.after;
    }
    return true;
  }

 private:
  /// Nothing is as good as a brick of zeros.
  static bool is_same(const BrickPointer& a, const BrickPointer& b) {
    if (a == b) return true;
    if (a && b) return *a == *b;
    const LabelVolume::Brick& only = a ? *a : *b;
    return std::all_of(only.begin(), only.end(), [](Label label) { return label == 0; });
  }

  const LabelVolume& labels_;
  std::map<std::size_t, BrickPointer> now_;
};

/// Whether all steps that are done lead to the labels, and those that were undone go on from them.
bool leads_to(const History& history, const LabelVolume& labels) {
  Way back(labels), forth(labels);
  bool leads = true;
  for (std::size_t n = history.done(); n > 0 && leads; --n) leads = back.go(*history.steps()[n - 1], true);
  for (std::size_t n = history.done(); n < history.steps().size() && leads; ++n)
    leads = forth.go(*history.steps()[n], false);
  return leads;
}

}  // namespace

void write_history(const fs::path& folder, const History& history) {
  BrickBook book;
  json steps = json::array();
  for (const auto& step : history.steps()) steps.push_back(step_entry(*step, book));
  write_labels(folder / "bricks.nrrd", book.volume(), {});
  write_json(folder / "steps.json", {{"done", history.done()}, {"steps", steps}});
}

History read_history(const fs::path& folder, const LabelVolume& labels) {
  const std::string file = (folder / "steps.json").string();
  const json document = read_json(folder / "steps.json");
  const LabelVolume bricks = read_labels(folder / "bricks.nrrd").voxels;
  try {
    History history;
    for (const json& entry : document.at("steps"))
      history.steps_.push_back(
          std::make_shared<const History::Step>(step_of(entry, bricks, labels.brick_count(), file)));
    history.done_ = document.at("done").get<std::size_t>();
    if (history.done_ > history.steps_.size())
      throw InputError(file, "done", "counts more steps than there are", kRemedy);
    if (!leads_to(history, labels))
      throw InputError(file, "steps", "do not lead to the case's labels", kRemedy);
    return history;
  } catch (const json::exception& failure) {
    throw InputError(file, "", std::string("is malformed (") + failure.what() + ")", kRemedy);
  }
}

}  // namespace glisson::editing
