// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <concepts>
#include <map>
#include <typeindex>
#include <utility>

namespace glisson::ui {

/// One value of each type that is asked for, with the type's defaults until it is changed. A value itself:
/// copies are apart, and two are equal when they give the same values.
class ValueOfEach {
 public:
  template <std::regular T>
  const T& get() const {
    static const T kDefaults{};
    const auto found = values_.find(typeid(T));
    return found == values_.end() ? kDefaults : *std::any_cast<T>(&found->second.value);
  }
  template <std::regular T>
  T& get() {
    Kept& kept = values_.try_emplace(typeid(T), Kept{T{}, &is_same<T>}).first->second;
    return *std::any_cast<T>(&kept.value);
  }

  bool operator==(const ValueOfEach& other) const { return agrees(other) && other.agrees(*this); }

 private:
  using Same = bool (*)(const ValueOfEach&, const ValueOfEach&);
  struct Kept {
    std::any value;
    Same same;
  };

  template <class T>
  static bool is_same(const ValueOfEach& a, const ValueOfEach& b) {
    return a.get<T>() == b.get<T>();
  }
  /// In all that this one keeps.
  bool agrees(const ValueOfEach& other) const {
    for (const auto& [type, kept] : values_)
      if (!kept.same(*this, other)) return false;
    return true;
  }

  std::map<std::type_index, Kept> values_;
};

}  // namespace glisson::ui
