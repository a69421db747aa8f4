// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace glisson {

/// Base of everything that Glisson throws. what() is one sentence for a person, remedy included.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// The input is not usable. Names the file (or the parameter), the field and the remedy, in that order.
class InputError : public Error {
 public:
  /// @param file path or parameter name; may be empty.
  /// @param field what in it is wrong ("direction", "vertex 12", "D1"); may be empty.
  /// @param problem what is wrong with it, values included.
  /// @param remedy what the person can do.
  InputError(std::string file, std::string field, std::string problem, std::string remedy);

  const std::string& file() const { return file_; }
  const std::string& field() const { return field_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string file_, field_, problem_, remedy_;
};

/// A file could not be read or written (missing, permission, disk full, short write).
class FileError : public Error {
 public:
  using Error::Error;
};

/// A computation has no trustworthy result (singular matrix, no convergence, too few points).
class NumericalError : public Error {
 public:
  using Error::Error;
};

/// A caller broke a documented precondition (@pre).
class PreconditionError : public Error {
 public:
  using Error::Error;
};

/// Refuses numbers among a set of options.
class OptionCheck {
 public:
  /// @param options what they are called in the sentence ("tracker options").
  explicit OptionCheck(const char* options) : options_(options) {}
  /// @throws InputError "OPTIONS: FIELD: is VALUE. REMEDY." unless good.
  void operator()(bool good, const char* field, double value, const char* remedy) const;

 private:
  const char* options_;
};

/// Throws PreconditionError with `message` unless `condition` holds.
void require(bool condition, const char* message);

}  // namespace glisson
