// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// @file
/// What the arrays of VTK's XML files are made of: bytes as they are or as base64, and numbers.

namespace glisson::vtk_xml {

enum class Number { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

std::size_t size_of(Number number);
/// By VTK's name, "Float32".
std::optional<Number> number_named(const std::string& name);
/// @param raw size_of(number) bytes in the order of this machine.
double decode(const unsigned char* raw, Number number);

/// Bytes one after the other, from base64 (where any group of four may be the padded end of a part) or as
/// they are.
class ByteSource {
 public:
  ByteSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

  /// Upper bound of what is left.
  std::size_t remaining() const { return base64_ ? text_.size() / 4 * 3 + 3 : text_.size(); }
  /// False: the data end early, or hold what is no base64.
  bool take(std::size_t size, std::string& bytes);

 private:
  bool take_group();

  std::string_view text_;
  bool base64_;
  std::string pending_;
};

}  // namespace glisson::vtk_xml
