// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/core/run_context.h"
#include "glisson/network/mask_sheet.h"
#include "glisson/network/runner.h"
#include "glisson/patient/picture.h"

namespace glisson::network {

/// Says by a person's own network (ONNX) what of a laparoscope's picture is not liver: tools, hands, gauze.
/// Not for two threads at once.
class MaskNetwork {
 public:
  /// @param threads of the processor that a picture may take; 0: all.
  /// @return null: cancelled.
  /// @throws FileError, InputError naming file, field and remedy.
  static std::unique_ptr<MaskNetwork> open(const std::filesystem::path& path, const RunContext& context,
                                           int threads = 0);

  const MaskSheet& sheet() const { return sheet_; }
  /// @return one channel of the picture's size, 255 where it is not liver. Empty: cancelled, as for
  ///   NetworkRunner::run(). @throws InputError naming the file. @pre the picture is not empty
  Cancellable<Picture> not_liver(const Picture& picture, const RunContext& context);

 private:
  MaskNetwork(std::unique_ptr<NetworkRunner> runner, MaskSheet sheet, int rows, int columns);

  std::unique_ptr<NetworkRunner> runner_;
  MaskSheet sheet_;
  int rows_, columns_;
};

}  // namespace glisson::network
