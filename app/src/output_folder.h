// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/core/files.h"

namespace glisson::app {

/// A folder that a command fills: made beside the wanted one and moved there by commit(). Without it nothing
/// remains.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& wanted);
  std::filesystem::path path() const;
  /// Replaces files of the same name in the wanted folder, leaves others alone. Links are written through. A
  /// case is replaced whole, as saving does it: not one that somebody has open for writing.
  /// @param whole false: the work was cut short, which a file INCOMPLETE says until a whole result comes.
  /// @throws Error nothing was replaced then.
  void commit(bool whole = true);

 private:
  std::filesystem::path told_, wanted_;
  std::unique_ptr<TemporaryFolder> working_;
};

}  // namespace glisson::app
