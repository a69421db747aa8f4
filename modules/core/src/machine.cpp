// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/machine.h"

#include <sys/statvfs.h>
#include <sys/sysinfo.h>

#include <thread>

#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson {

Machine this_machine() {
  Machine machine;
  machine.cores = std::thread::hardware_concurrency();
  struct sysinfo memory = {};
  if (::sysinfo(&memory) == 0) machine.memory = static_cast<double>(memory.totalram) * memory.mem_unit;
  machine.work = work_folder();
  struct statvfs disk = {};
  if (::statvfs(machine.work.c_str(), &disk) == 0)
    machine.space = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  return machine;
}

std::vector<MachineLack> lacks_of(const Machine& machine) {
  constexpr unsigned kLeastCores = 2;
  // A machine of 8 GB keeps some for itself.
  constexpr double kLeastMemory = 7.5e9, kLeastSpace = 5e9;
  std::vector<MachineLack> lacks;
  if (machine.cores < kLeastCores) lacks.push_back(MachineLack::cores);
  if (machine.memory && *machine.memory < kLeastMemory) lacks.push_back(MachineLack::memory);
  if (machine.space && *machine.space < kLeastSpace) lacks.push_back(MachineLack::space);
  return lacks;
}

void try_locks() {
  const TemporaryFolder folder;
  Claim one;
  if (Claim::make_file(folder.path(), "", one).empty() || !one.take())
    throw FileError(
        folder.path().string() +
        ": this file system has no locks, so that two programs may write one case. Keep cases elsewhere.");
}

}  // namespace glisson
