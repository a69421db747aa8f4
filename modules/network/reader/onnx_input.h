// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "questions.h"

namespace glisson::network::reader {

/// What an ONNX file (protocol buffers) says of its inputs, without its layers; OpenCV does not tell it.
/// `loaded` and `said` stay 0. Malformed bytes give no inputs.
LoadAnswer onnx_input(std::string_view file);

}  // namespace glisson::network::reader
