// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/error.h"

#include <utility>

namespace glisson {
namespace {

std::string sentence(const std::string& file, const std::string& field, const std::string& problem,
                     const std::string& remedy) {
  std::string text;
  if (!file.empty()) text += file + ": ";
  if (!field.empty()) text += field + ": ";
  text += problem;
  if (!remedy.empty()) text += ". " + remedy;
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

}  // namespace

InputError::InputError(std::string file, std::string field, std::string problem, std::string remedy)
    : Error(sentence(file, field, problem, remedy)),
      file_(std::move(file)),
      field_(std::move(field)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

void OptionCheck::operator()(bool good, const char* field, double value, const char* remedy) const {
  if (!good) throw InputError(options_, field, "is " + std::to_string(value) + ", out of range", remedy);
}

void require(bool condition, const char* message) {
  if (!condition) throw PreconditionError(message);
}

}  // namespace glisson
