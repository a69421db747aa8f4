// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/core/run_context.h"

/// @file
/// What a tool of the editor is: a value with settings, and the one description of its kind, from which
/// scripts, refusals, names of steps and the manual's table follow.

namespace glisson::editing {

class Canvas;
class ScriptEntry;
class ScriptFields;
class Tool;
struct EditableRegion;
struct StepName;
struct Task;

/// A setting of a tool, as scripts write it.
struct ToolField {
  enum class Kind { label, labels, flag, choice, whole, number, length, point, path, matrix, object };
  std::string code;  ///< "radius_mm"
  Kind kind = Kind::number;
  std::string unit = {};                  ///< "mm", "HU", "ml"; empty: has none
  std::vector<std::string> choices = {};  ///< of a choice
  std::optional<double> most = {};        ///< the largest that is taken, in the unit
  bool has_default = false;               ///< a script may leave it out
  std::string needed = {};                ///< when a script may not: "for a disc"; empty: see has_default
  std::string note = {};                  ///< for the manual: "negative: shrinks"
  std::vector<ToolField> parts = {};      ///< of an object
};

/// The description of a kind of tool: one object for each kind, which lives as long as the program.
/// Thread-safe.
class ToolKind {
 public:
  ToolKind() = default;
  virtual ~ToolKind() = default;
  ToolKind(const ToolKind&) = delete;
  ToolKind& operator=(const ToolKind&) = delete;

  /// "paint", "grow_from_seeds": in scripts, refusals and histories.
  virtual const std::string& code() const = 0;
  /// Kinds are listed by rising place; those that are there stand 10 apart.
  virtual int place() const = 0;
  virtual std::vector<ToolField> fields() const = 0;
  /// All codes of StepName that its edits can have.
  virtual const std::vector<std::string>& steps() const = 0;
  virtual Tool with_defaults() const = 0;

  // The following ask for a tool of this kind.
  virtual bool same(const Tool& a, const Tool& b) const = 0;
  virtual StepName step(const Tool& tool) const = 0;
  virtual bool is_local(const Tool& tool) const = 0;
  /// @throws InputError settings that no image can make good; names the tool as file, its setting as field.
  virtual void check(const Tool& tool, const EditableRegion& region) const = 0;
  /// @pre check() has passed. Empty: cancelled.
  virtual Cancellable<Canvas> apply(const Tool& tool, Task& task) const = 0;
  /// @throws InputError naming the entry and its field.
  virtual Tool read(ScriptEntry& entry) const = 0;
  virtual void write(const Tool& tool, ScriptFields& fields) const = 0;
};

/// A tool with its settings: a value of any struct that has `static const ToolKind& kind()`, does not change,
/// and is cheap to copy.
class Tool {
 public:
  template <class Settings>
  requires std::same_as<decltype(Settings::kind()), const ToolKind&>
  // NOLINTNEXTLINE(google-explicit-constructor): an edit is written as {Paint{...}, region}
  Tool(Settings settings)
      : kind_(&Settings::kind()), settings_(std::make_shared<const Settings>(std::move(settings))) {}
  /// A brush that has drawn nothing.
  Tool();

  const ToolKind& kind() const { return *kind_; }
  /// Null: it is of another kind.
  template <class Settings>
  const Settings* get_if() const {
    return kind_ == &Settings::kind() ? static_cast<const Settings*>(settings_.get()) : nullptr;
  }
  /// @throws PreconditionError it is of another kind.
  template <class Settings>
  const Settings& as() const {
    const Settings* settings = get_if<Settings>();
    if (settings == nullptr) refuse(Settings::kind());
    return *settings;
  }
  bool operator==(const Tool& other) const { return kind_ == other.kind_ && kind_->same(*this, other); }

 private:
  [[noreturn]] void refuse(const ToolKind& wanted) const;

  const ToolKind* kind_;
  std::shared_ptr<const void> settings_;
};

/// All kinds, in the order of the manual.
const std::vector<const ToolKind*>& tools();
/// Null: there is none.
const ToolKind* tool_called(std::string_view code);
/// The manual's table of what scripts may say: a row for each tool with its fields, and one for the region.
std::string script_table(const std::vector<const ToolKind*>& kinds = tools());

}  // namespace glisson::editing
