// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_xml_bytes.h"

#include <cstdint>
#include <cstring>
#include <utility>

namespace glisson::vtk_xml {
namespace {

template <class T>
double as(const unsigned char* raw) {
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return static_cast<double>(value);
}

int value_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

}  // namespace

std::size_t size_of(Number number) {
  static constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<int>(number)];
}

std::optional<Number> number_named(const std::string& name) {
  static constexpr std::pair<const char*, Number> kNames[] = {
      {"Int8", Number::i8},     {"UInt8", Number::u8},   {"Int16", Number::i16}, {"UInt16", Number::u16},
      {"Int32", Number::i32},   {"UInt32", Number::u32}, {"Int64", Number::i64}, {"UInt64", Number::u64},
      {"Float32", Number::f32}, {"Float64", Number::f64}};
  for (const auto& [known, number] : kNames)
    if (name == known) return number;
  return std::nullopt;
}

double decode(const unsigned char* raw, Number number) {
  switch (number) {
    case Number::i8:
      return as<std::int8_t>(raw);
    case Number::u8:
      return as<std::uint8_t>(raw);
    case Number::i16:
      return as<std::int16_t>(raw);
    case Number::u16:
      return as<std::uint16_t>(raw);
    case Number::i32:
      return as<std::int32_t>(raw);
    case Number::u32:
      return as<std::uint32_t>(raw);
    case Number::i64:
      return as<std::int64_t>(raw);
    case Number::u64:
      return as<std::uint64_t>(raw);
    case Number::f32:
      return as<float>(raw);
    case Number::f64:
      break;
  }
  return as<double>(raw);
}

bool ByteSource::take(std::size_t size, std::string& bytes) {
  if (size > remaining() + pending_.size()) return false;
  if (!base64_) {
    bytes.assign(text_.substr(0, size));
    text_.remove_prefix(size);
    return true;
  }
  while (pending_.size() < size)
    if (!take_group()) return false;
  bytes = pending_.substr(0, size);
  pending_.erase(0, size);
  return true;
}

bool ByteSource::take_group() {
  std::uint32_t bits = 0;
  int letters = 0, padding = 0;
  while (letters + padding < 4) {
    if (text_.empty()) return false;
    const char c = text_.front();
    text_.remove_prefix(1);
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c == '=' && letters >= 2) {
      ++padding;
      bits <<= 6;
      continue;
    }
    const int value = value_of(c);
    if (value < 0 || padding > 0) return false;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    ++letters;
  }
  for (int byte = 0; byte < 3 - padding; ++byte)
    pending_ += static_cast<char>(bits >> (16 - 8 * byte) & 0xFFU);
  return true;
}

}  // namespace glisson::vtk_xml
