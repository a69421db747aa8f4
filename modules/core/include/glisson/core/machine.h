// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

/// @file
/// What this machine gives the program, and what of it is too little.

namespace glisson {

/// As the system tells it.
struct Machine {
  unsigned cores = 0;            ///< processor cores
  std::optional<double> memory;  ///< bytes; empty: the system does not say
  std::filesystem::path work;    ///< where folders for work in progress are made
  std::optional<double> space;   ///< bytes that are left there; empty: likewise
};
/// The machine that this runs on. Never throws for what the system does not say.
Machine this_machine();

/// What a machine has too little of: the live view needs two cores, large CTs 8 GB of memory, archives that
/// are unpacked 5 GB of space.
enum class MachineLack { cores, memory, space };
/// In the order of the list above. What is not known is not missed.
std::vector<MachineLack> lacks_of(const Machine& machine);

/// Holds a file in the work folder, as a case is held. @throws FileError its file system has no locks.
void try_locks();

}  // namespace glisson
