// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <igtlImageMessage.h>
#include <igtlTransformMessage.h>

#include <string>

/// @file
/// Messages as the library itself packs them.

namespace glisson::test {

inline std::string bytes_of(igtl::MessageBase* message) {
  message->SetDeviceName("Here");
  message->SetTimeStamp(1000, 1U << 31);
  message->Pack();
  return {static_cast<char*>(message->GetPackPointer()), static_cast<std::size_t>(message->GetPackSize())};
}

inline std::string image_bytes(int width = 32, int height = 16, int components = 3) {
  auto message = igtl::ImageMessage::New();
  message->SetDimensions(width, height, 1);
  message->SetNumComponents(components);
  message->SetScalarType(igtl::ImageMessage::TYPE_UINT8);
  message->AllocateScalars();
  auto* to = static_cast<unsigned char*>(message->GetScalarPointer());
  for (int i = 0; i < width * height * components; ++i) to[i] = static_cast<unsigned char>(i);
  return bytes_of(message);
}

inline std::string transform_bytes(float first = 0.0F, float x = 10.0F) {
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix = {{first, -1, 0, x}, {1, 0, 0, -20}, {0, 0, 1, 120}, {0, 0, 0, 1}};
  message->SetMatrix(matrix);
  return bytes_of(message);
}

}  // namespace glisson::test
