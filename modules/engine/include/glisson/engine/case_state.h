// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>

#include "glisson/engine/part.h"

namespace glisson::engine {

/// Everything that is known of one patient. Each part is immutable and shared, so that a copy is cheap;
/// absent parts are null.
class CaseState {
 public:
  std::filesystem::path path;  ///< of the case's folder; empty: never saved

  template <class T>
  const std::shared_ptr<const T>& operator[](const PartOf<T>& part) const {
    static const std::shared_ptr<const T> kNone;
    const auto slot = slots_.find(part);
    if (slot == slots_.end()) return kNone;
    const auto* value = std::any_cast<std::shared_ptr<const T>>(&slot->second.value);
    return value == nullptr ? kNone : *value;
  }
  template <class T>
  std::shared_ptr<const T>& operator[](const PartOf<T>& part) {
    std::any& value = slots_[part].value;
    if (!value.has_value()) value = std::shared_ptr<const T>();
    return *std::any_cast<std::shared_ptr<const T>>(&value);
  }

  bool has(Part part) const { return address(part) != nullptr; }
  const Stamp& stamp(Part part) const;
  Stamp& stamp(Part part) { return slots_[part].stamp; }
  /// Copies one part with its companions (not its stamp) from another state.
  void take(Part part, const CaseState& from);
  /// Whether this part is the very same object in both.
  bool shares(Part part, const CaseState& with) const { return address(part) == with.address(part); }

 private:
  struct Slot {
    std::any value;
    Stamp stamp;
  };
  const void* address(Part part) const;
  void take_value(Part part, const CaseState& from);

  std::map<Part, Slot> slots_;
};

/// Revisions of the parts that a case keeps on the disk.
using Editions = std::map<Part, std::uint64_t>;
Editions editions(const CaseState& state);

enum class StageState { absent, current, stale };
/// A part is stale when anything that it was made from has changed since, or is itself stale.
StageState stage_state(const CaseState& state, Part part);

}  // namespace glisson::engine
