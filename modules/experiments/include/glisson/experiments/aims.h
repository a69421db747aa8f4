// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"

/// @file
/// What a proof's figures should be, whether they are, and the page that says so.

namespace glisson::experiments {

/// On what a figure was measured: a simulation whose truth is known; a thing made for measuring (a board, a
/// silicone organ) before real cameras; real tissue or a real patient's CT.
enum class Evidence { in_silico, phantom, real };

/// What a figure should be: `key`'s value at least, or at most, `bound`. The bound itself meets it.
struct Aim {
  enum class Sense { at_least, at_most };
  std::string key;   ///< of the figure
  std::string what;  ///< for people, English; marked for translation where the aims are listed
  Evidence evidence = Evidence::in_silico;
  Sense sense = Sense::at_least;
  double bound = 0.0;
  int decimals = 2;  ///< with which the figure is shown
};

/// not_measured: the figure is absent (its data are not there) or not a number.
enum class Verdict { met, missed, not_measured };

/// Of one aim; the unrounded figure is compared.
Verdict verdict(const Aim& aim, const Figures& figures);

/// A proof as it is written down.
struct ProofPage {
  std::string title, introduction;
  std::string command;  ///< by which it is measured again
  std::vector<Aim> aims;
  Figures figures;
  std::vector<std::string> absent;  ///< data that were not there, and what could not be tried
  std::vector<std::string> unused;  ///< data that were there, and that nothing was measured on
  std::vector<std::string> table;   ///< lines of fixed width, the first the heads; may be empty
};
/// Of all together: missed when an aim is; else not_measured when one is, or when something was absent, for
/// then figures hold less than the page says; else met.
Verdict verdict(const ProofPage& page);
/// Markdown: the aims with what was measured, then the table, then all other figures. Holds no dates,
/// and no times but those that are aims, so that the same figures give the same file. Atomic. @throws
/// FileError.
void write_page(const std::filesystem::path& file, const ProofPage& page);

/// packaging/figures of the checkout that `folder` is the root of; empty: it is none.
std::filesystem::path figures_of_checkout(const std::filesystem::path& folder);

}  // namespace glisson::experiments
