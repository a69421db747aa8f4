// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.h"

#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_header.h>
#include <igtl_polydata.h>
#include <igtl_util.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "glisson/core/units.h"

namespace glisson::openigtlink {
namespace {

constexpr double kMillimetresPerMetre = 1.0 / metres_per(LengthUnit::millimetre);

/// Whole seconds and a 2^-32 part of them.
struct Stamp {
  explicit Stamp(double seconds) {
    const double whole = std::floor(std::max(0.0, seconds));
    second = static_cast<std::uint32_t>(whole);
    fraction =
        static_cast<std::uint32_t>(std::min((std::max(0.0, seconds) - whole) * 4294967296.0, 4294967295.0));
  }
  std::uint32_t second, fraction;
};

template <class Message>
std::string packed(Message& message, const std::string& name, double seconds) {
  const Stamp stamp(seconds);
  message->SetDeviceName(name.substr(0, kLongestName).c_str());
  message->SetTimeStamp(stamp.second, stamp.fraction);
  message->Pack();
  return {static_cast<const char*>(message->GetPackPointer()),
          static_cast<std::size_t>(message->GetPackSize())};
}

std::string header_of(std::string_view type, const std::string& name, double seconds, std::string& body) {
  const Stamp stamp(seconds);
  igtl_header header = {};
  header.version = IGTL_HEADER_VERSION;
  std::memcpy(header.name, type.data(), std::min<std::size_t>(type.size(), IGTL_HEADER_TYPE_SIZE));
  std::memcpy(header.device_name, name.data(), std::min(name.size(), kLongestName));
  header.timestamp = (static_cast<igtl_uint64>(stamp.second) << 32) | stamp.fraction;
  header.body_size = body.size();
  header.crc = crc64(reinterpret_cast<unsigned char*>(body.data()), body.size(), 0);
  igtl_header_convert_byte_order(&header);
  std::string bytes(IGTL_HEADER_SIZE, '\0');
  std::memcpy(bytes.data(), &header, IGTL_HEADER_SIZE);
  return bytes;
}

}  // namespace

std::string transform_message(const std::string& name, double seconds, const Eigen::Matrix4d& pose_mm) {
  auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix[row][column] = static_cast<float>(pose_mm(row, column));
  message->SetMatrix(matrix);
  return packed(message, name, seconds);
}

std::string status_message(const std::string& name, double seconds, Level level, const std::string& text) {
  auto message = igtl::StatusMessage::New();
  message->SetCode(level == Level::valid ? igtl::StatusMessage::STATUS_OK
                                         : igtl::StatusMessage::STATUS_NOT_READY);
  message->SetSubCode(static_cast<int>(level));
  message->SetErrorName(level_code(level));
  message->SetStatusString(text.c_str());
  return packed(message, name, seconds);
}

std::string string_message(const std::string& name, double seconds, const std::string& text) {
  auto message = igtl::StringMessage::New();
  message->SetString(text.c_str());
  return packed(message, name, seconds);
}

// By the library's C functions: its class keeps each triangle in a list of its own, and packs nothing where
// there is no point.
std::string poly_data_message(const std::string& name, double seconds, const Points& vertices,
                              const Triangles& triangles) {
  std::vector<igtl_float32> points;
  points.reserve(static_cast<std::size_t>(vertices.size()));
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      points.push_back(static_cast<float>(kMillimetresPerMetre * vertices(i, axis)));
  std::vector<igtl_uint32> cells;
  cells.reserve(4 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index i = 0; i < triangles.rows(); ++i) {
    cells.push_back(3);
    for (int corner = 0; corner < 3; ++corner)
      cells.push_back(static_cast<igtl_uint32>(triangles(i, corner)));
  }
  igtl_polydata_info info;
  igtl_polydata_init_info(&info);
  info.header.npoints = static_cast<igtl_uint32>(vertices.rows());
  info.header.npolygons = static_cast<igtl_uint32>(triangles.rows());
  info.header.size_polygons = static_cast<igtl_uint32>(cells.size() * sizeof(igtl_uint32));
  info.points = points.data();
  info.polygons = cells.data();

  // A buffer of its own: the library writes whole words to it.
  std::string body(static_cast<std::size_t>(igtl_polydata_get_size(&info, IGTL_TYPE_PREFIX_NONE)), '\0');
  igtl_polydata_pack(&info, body.data(), IGTL_TYPE_PREFIX_NONE);
  return header_of("POLYDATA", name, seconds, body) + body;
}

}  // namespace glisson::openigtlink
