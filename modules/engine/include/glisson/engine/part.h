// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glisson/core/run_context.h"

/// @file
/// A part of the case describes itself: its type, its code, what it is made of, how it is saved, read and
/// compared, and what travels with it. Everything that goes over parts (saving, opening, staleness, what is
/// missing) is a loop over all_parts(). A new part is one file below parts/.

namespace glisson::engine {

class CaseState;
class PartType;

/// A part, as a value: cheap to copy and to compare.
class Part {
 public:
  constexpr Part(const PartType& type) : type_(&type) {}  // NOLINT: a part's type is its name
  const PartType& type() const { return *type_; }
  /// For files and figures: "image", "labels", ...
  std::string_view code() const;
  friend constexpr bool operator==(Part, Part) = default;
  /// Any order, for containers only. For the natural one see all_parts().
  friend bool operator<(Part a, Part b) { return std::less<const PartType*>()(a.type_, b.type_); }

 private:
  const PartType* type_;
};

/// A set of parts.
class Parts {
 public:
  Parts() = default;
  Parts(std::initializer_list<Part> parts);  // NOLINT: reads as {part::image, part::labels}
  /// Every part that there is.
  static Parts all();
  bool has(Part part) const;
  bool meets(const Parts& other) const;
  bool empty() const { return parts_.empty(); }
  void add(Part part);
  Parts operator|(const Parts& other) const;
  bool operator==(const Parts&) const = default;

 private:
  std::vector<Part> parts_;  ///< ascending, each once
};

/// A part that something cannot be done without, or another that does as well.
struct Need {
  Need(Part its) : part(its), instead(its) {}     // NOLINT: a part is needed
  Need(const PartType& its) : Need(Part(its)) {}  // NOLINT: a part is needed
  Part part;                                      ///< what to see to where neither is there
  Part instead;                                   ///< `part` itself: nothing else does
};
using Needs = std::vector<Need>;
/// `part` is needed, or `instead` of it.
Need either(Part part, Part instead);

/// Which edition of a part this is, and of which editions of other parts it was made.
struct Stamp {
  std::uint64_t revision = 0;  ///< 0: absent
  std::map<Part, std::uint64_t> made_from;
};

/// Where a part is written to or read from.
struct CaseFolder {
  std::filesystem::path path;  ///< the folder that holds the files now
  std::filesystem::path home;  ///< where the case stands in the end; the same when it is read
  RunContext context;
  /// What cannot be read but can be made again is told here ("case.cloud_lost SENTENCE") and left out; null:
  /// it is thrown.
  std::vector<std::string>* lost = nullptr;
  /// It is this program's own writing that is read back: nothing that it names is foreign.
  bool is_own = false;
};

/// How a part describes itself.
struct PartSpec {
  std::string_view code;
  /// What it is made of in the natural course of the work: the stage graph. Parts are saved and read in its
  /// order, so that what is read may look at what it is made of.
  std::vector<Part> made_of = {};
  /// What brings it, for errors: "Segment the CT or import labels first".
  std::string_view remedy = {};
  /// Its files in the case's folder, as any edition names them ("cloud.ply"), and the kinds of files in its
  /// folders ("frame/*.png"): what else lies there is somebody's own.
  std::vector<std::string_view> files = {};
  /// Writes its files and gives its entry in case.json. Empty: it is not kept on the disk.
  /// @throws FileError.
  std::function<nlohmann::json(const CaseState&, const CaseFolder&)> save = {};
  /// Its entry in case.json where its files stand already, taken over from an earlier edition (SavedImage).
  /// Empty: its files are written each time.
  std::function<nlohmann::json(const CaseState&)> entry = {};
  /// Reads it back into the state. Leaves it out when cancelled, or when it is lost (CaseFolder::lost).
  /// @throws FileError, InputError naming file and field.
  std::function<void(CaseState&, const nlohmann::json& entry, const CaseFolder&)> load = {};
  /// Share of the time in which a case is read, of a part that takes long and tells how far it is; 0: one of
  /// those that share what is left.
  double reading_share = 0.0;
  /// Whether what was read back is what was written, but for what files round. Every part that is saved says
  /// so.
  std::function<bool(const CaseState& written, const CaseState& read)> same = {};
  /// Whether what the state holds is fit to be kept. Empty: always.
  std::function<bool(const CaseState&)> is_savable = {};
  /// What is copied along with it: values of their own without a stamp. Saved and read by this part.
  std::vector<const PartType*> companions = {};
  /// Whether it stands refused: it is there, and nothing may go on from it before a person has accepted it.
  /// Empty: never.
  std::function<bool(const CaseState&)> is_refused = {};
  /// What to do then, for errors.
  std::string_view refused_remedy = {};
  /// Parts that it goes on from without learning of their changes: while it is there, only commands that
  /// write it as well may write these.
  std::vector<Part> follows = {};
  /// Changes with every frame of the live view: no reason to draw the case anew.
  bool is_live = false;
  /// A person's word, or what knows itself whether it still holds: made from nothing, and nothing becomes
  /// stale by it.
  bool stands_alone = false;
  /// Of no use to others: nothing becomes stale by it.
  bool is_input = true;
  /// Inputs that it no longer counts as made from once a command has changed it instead of making it anew.
  std::vector<Part> changed_frees_from = {};
  /// Inputs that it no longer counts as made from where a case was opened without them: what the case holds
  /// is not out of date by what was left out.
  std::vector<Part> outlives = {};
};

/// The description of a part, but for its type in C++. One object for each part lives as long as the program.
class PartType {
 public:
  explicit PartType(PartSpec spec) : spec_(std::move(spec)) {}
  virtual ~PartType() = default;
  PartType(const PartType&) = delete;
  PartType& operator=(const PartType&) = delete;
  const PartSpec& spec() const { return spec_; }
  bool is_saved() const { return static_cast<bool>(spec_.save); }
  /// The address of the value in a slot of the state; null: none.
  virtual const void* value_in(const std::any& slot) const = 0;

 private:
  PartSpec spec_;
};

/// A part whose value is a T: `state[part::labels]` is a `shared_ptr<const LabelMap>`.
template <class T>
class PartOf final : public PartType {
 public:
  using PartType::PartType;
  using Value = std::shared_ptr<const T>;
  const void* value_in(const std::any& slot) const override {
    const auto* value = std::any_cast<Value>(&slot);
    return value == nullptr ? nullptr : value->get();
  }
};

/// PartSpec::files of all parts.
std::vector<std::string_view> files_of_parts();

/// Makes a part known that is not below parts/: define one of namespace scope beside it.
class RegisteredPart {
 public:
  explicit RegisteredPart(const PartType& type);
};

/// Every part, each after those that it is made of. The same order in every run.
const std::vector<Part>& all_parts();

/// The parts by name, each declared in parts/NAME.h.
namespace part {}

}  // namespace glisson::engine

namespace glisson {
namespace part = engine::part;  // said in every room above
}  // namespace glisson
