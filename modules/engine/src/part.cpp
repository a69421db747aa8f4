// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/part.h"

#include <algorithm>

#include "built_in_parts.h"
#include "glisson/core/error.h"

namespace glisson::engine {
namespace {

/// Parts that were registered besides the built-in ones. In a function: others register before main().
std::vector<Part>& registered() {
  static std::vector<Part> parts;
  return parts;
}

/// Each after those that it is made of, otherwise by code.
std::vector<Part> in_order(std::vector<Part> parts) {
  std::sort(parts.begin(), parts.end(), [](Part a, Part b) { return a.code() < b.code(); });
  std::vector<Part> ordered;
  const auto is_placed = [&](Part part) {
    return std::find(ordered.begin(), ordered.end(), part) != ordered.end();
  };
  while (!parts.empty()) {
    const auto next = std::find_if(parts.begin(), parts.end(), [&](Part part) {
      const auto& inputs = part.type().spec().made_of;
      return std::all_of(inputs.begin(), inputs.end(), is_placed);
    });
    require(next != parts.end(), "no part is made of itself, and every part's inputs are known");
    ordered.push_back(*next);
    parts.erase(next);
  }
  return ordered;
}

}  // namespace

std::string_view Part::code() const { return type_->spec().code; }

Parts::Parts(std::initializer_list<Part> parts) {
  for (const Part part : parts) add(part);
}

Parts Parts::all() {
  Parts parts;
  for (const Part part : all_parts()) parts.add(part);
  return parts;
}

Need either(Part part, Part instead) {
  Need need(part);
  need.instead = instead;
  return need;
}

bool Parts::has(Part part) const { return std::binary_search(parts_.begin(), parts_.end(), part); }

bool Parts::meets(const Parts& other) const {
  return std::any_of(parts_.begin(), parts_.end(), [&](Part part) { return other.has(part); });
}

void Parts::add(Part part) {
  const auto place = std::lower_bound(parts_.begin(), parts_.end(), part);
  if (place == parts_.end() || *place != part) parts_.insert(place, part);
}

Parts Parts::operator|(const Parts& other) const {
  Parts both = *this;
  for (const Part part : other.parts_) both.add(part);
  return both;
}

std::vector<std::string_view> files_of_parts() {
  std::vector<std::string_view> names;
  for (const Part part : all_parts())
    names.insert(names.end(), part.type().spec().files.begin(), part.type().spec().files.end());
  return names;
}

RegisteredPart::RegisteredPart(const PartType& type) { registered().emplace_back(type); }

const std::vector<Part>& all_parts() {
  static const std::vector<Part> kParts = [] {
    std::vector<Part> parts = built_in_parts();
    parts.insert(parts.end(), registered().begin(), registered().end());
    return in_order(std::move(parts));
  }();
  return kParts;
}

}  // namespace glisson::engine
