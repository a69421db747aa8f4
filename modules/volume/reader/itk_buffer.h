// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <itkImageIOBase.h>

#include <vector>

#include "glisson/core/error.h"
#include "raw_volume.h"

namespace glisson::reader {

template <class T>
void append_floats(const std::vector<char>& bytes, std::size_t count, std::vector<float>& values) {
  const T* from = reinterpret_cast<const T*>(bytes.data());
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<float>(from[i]));
}

/// Reads everything that `io` has announced, as floats. Its information must have been read.
inline std::vector<float> read_buffer(const Request& request, itk::ImageIOBase& io) {
  using Type = itk::IOComponentEnum;
  itk::ImageIORegion region(io.GetNumberOfDimensions());
  for (unsigned axis = 0; axis < io.GetNumberOfDimensions(); ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io.GetDimensions(axis));
  }
  io.SetIORegion(region);
  const auto count = static_cast<std::size_t>(io.GetImageSizeInComponents());
  std::vector<char> bytes(static_cast<std::size_t>(io.GetImageSizeInBytes()));
  io.Read(bytes.data());
  std::vector<float> values;
  values.reserve(count);
  switch (io.GetComponentType()) {
    case Type::UCHAR:
      append_floats<unsigned char>(bytes, count, values);
      break;
    case Type::CHAR:
      append_floats<signed char>(bytes, count, values);
      break;
    case Type::USHORT:
      append_floats<unsigned short>(bytes, count, values);
      break;
    case Type::SHORT:
      append_floats<short>(bytes, count, values);
      break;
    case Type::UINT:
      append_floats<unsigned>(bytes, count, values);
      break;
    case Type::INT:
      append_floats<int>(bytes, count, values);
      break;
    case Type::ULONG:
    case Type::ULONGLONG:
      append_floats<unsigned long>(bytes, count, values);
      break;
    case Type::LONG:
    case Type::LONGLONG:
      append_floats<long>(bytes, count, values);
      break;
    case Type::FLOAT:
      append_floats<float>(bytes, count, values);
      break;
    case Type::DOUBLE:
      append_floats<double>(bytes, count, values);
      break;
    default:
      throw InputError(request.name, "type", "is a number format that is not known",
                       "Export it as 16-bit integers");
  }
  return values;
}

}  // namespace glisson::reader
