// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>

#include "phantom.h"

namespace glisson::test {

/// A DICOM slice of the phantom's world, written byte by byte, so that nothing is mended on the way.
struct HandSlice {
  std::string series = "1.2.826.0.1.3680043.2.1125.1", number = "4", description = "portal venous";
  std::string sop_class = "1.2.840.10008.5.1.4.1.1.2", photometric = "MONOCHROME2";
  double slope = 1.0, intercept = -1024.0;
  int stored_bits = 16, samples = 1;
  bool is_signed = false;
  std::uint16_t high_bits = 0;  ///< rubbish above the stored bits, as old scanners leave it
  int instance = 1;
  int zoom = 1;  ///< each of the world's pixels becomes so many a side (the JPEG 2000 encoder needs 32)
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();
  double tilt_degrees = 0.0;  ///< of the gantry: slices turned about the patient's left-right axis
  /// More elements, or others in the place of those above ("0028|0008" -> "2"); an empty text leaves one out.
  std::map<std::string, std::string> other = {};
};

inline void put_number(std::string& bytes, std::uint32_t value, int size) {
  for (int n = 0; n < size; ++n) bytes.push_back(static_cast<char>(value >> (8 * n) & 0xFFU));
}

/// One element in explicit VR, little endian.
inline void put_element(std::string& bytes, const std::string& tag, const std::string& vr,
                        std::string value) {
  if (value.size() % 2 != 0) value.push_back(vr == "UI" || vr == "OB" ? '\0' : ' ');
  put_number(bytes, static_cast<std::uint32_t>(std::stoul(tag.substr(0, 4), nullptr, 16)), 2);
  put_number(bytes, static_cast<std::uint32_t>(std::stoul(tag.substr(5, 4), nullptr, 16)), 2);
  bytes += vr;
  const bool wide = vr == "OB" || vr == "OW";
  if (wide) put_number(bytes, 0, 2);
  put_number(bytes, static_cast<std::uint32_t>(value.size()), wide ? 4 : 2);
  bytes += value;
}

/// Preamble and file meta information, explicit VR, little endian.
inline std::string file_beginning(const std::string& sop_class, const std::string& sop_instance) {
  std::string meta;
  put_element(meta, "0002|0001", "OB", std::string("\0\1", 2));
  put_element(meta, "0002|0002", "UI", sop_class);
  put_element(meta, "0002|0003", "UI", sop_instance);
  put_element(meta, "0002|0010", "UI", "1.2.840.10008.1.2.1");
  put_element(meta, "0002|0012", "UI", "1.2.826.0.1.3680043.2.1125.2");
  std::string bytes(128, '\0');
  bytes += "DICM";
  std::string length;
  put_number(length, static_cast<std::uint32_t>(meta.size()), 4);
  put_element(bytes, "0002|0000", "UL", length);
  return bytes + meta;
}

inline std::string short_of(int value) {
  std::string bytes;
  put_number(bytes, static_cast<std::uint32_t>(value), 2);
  return bytes;
}

inline std::string numbers_of(std::initializer_list<double> values) {
  std::ostringstream text;
  const char* between = "";
  for (const double value : values) text << between << value, between = "\\";
  return text.str();
}

/// Slice k of the world (axial, 6 x 5 pixels) as a file.
inline std::string dicom_of(int k, const HandSlice& slice) {
  std::string pixels;
  for (int j = 0; j < slice.zoom * kWorldSize.y(); ++j)
    for (int i = 0; i < slice.zoom * kWorldSize.x(); ++i)
      for (int sample = 0; sample < slice.samples; ++sample) {
        const auto stored = static_cast<int>(
            std::lround((world_value({i / slice.zoom, j / slice.zoom, k}) - slice.intercept) / slice.slope));
        if (slice.stored_bits == 8)
          put_number(pixels, static_cast<std::uint32_t>(stored), 1);
        else
          put_number(
              pixels,
              (static_cast<std::uint32_t>(stored) & ((1U << slice.stored_bits) - 1U)) | slice.high_bits, 2);
      }
  const double angle = slice.tilt_degrees * M_PI / 180.0;
  const Eigen::Vector3d p = kWorldOrigin + Eigen::Vector3d(0, 0, k * kWorldSpacing.z()) + slice.shift_mm;
  // In the order of the tags, as the standard wants it.
  std::map<std::string, std::pair<std::string, std::string>> data = {
      {"0008|0016", {"UI", slice.sop_class}},
      {"0008|0018", {"UI", slice.series + ".9." + std::to_string(k + 1)}},
      {"0008|0060", {"CS", "CT"}},
      {"0008|103e", {"LO", slice.description}},
      {"0020|000d", {"UI", "1.2.826.0.1.3680043.2.1125.7"}},
      {"0020|000e", {"UI", slice.series}},
      {"0020|0011", {"IS", slice.number}},
      {"0020|0013", {"IS", std::to_string(slice.instance)}},
      {"0020|0032", {"DS", numbers_of({p.x(), p.y(), p.z()})}},
      {"0020|0037", {"DS", numbers_of({1, 0, 0, 0, std::cos(angle), std::sin(angle)})}},
      {"0028|0002", {"US", short_of(slice.samples)}},
      {"0028|0004", {"CS", slice.photometric}},
      {"0028|0010", {"US", short_of(slice.zoom * kWorldSize.y())}},
      {"0028|0011", {"US", short_of(slice.zoom * kWorldSize.x())}},
      {"0028|0030", {"DS", numbers_of({kWorldSpacing.y(), kWorldSpacing.x()})}},
      {"0028|0100", {"US", short_of(slice.stored_bits == 8 ? 8 : 16)}},
      {"0028|0101", {"US", short_of(slice.stored_bits)}},
      {"0028|0102", {"US", short_of(slice.stored_bits - 1)}},
      {"0028|0103", {"US", short_of(slice.is_signed ? 1 : 0)}},
      {"0028|1052", {"DS", numbers_of({slice.intercept})}},
      {"0028|1053", {"DS", numbers_of({slice.slope})}},
      {"7fe0|0010", {slice.stored_bits == 8 ? "OB" : "OW", pixels}}};
  if (slice.samples > 1) data["0028|0006"] = {"US", short_of(0)};
  for (const auto& [tag, value] : slice.other) {
    if (value.empty())
      data.erase(tag);
    else
      data[tag] = {data.contains(tag) ? data[tag].first : "IS", value};
  }
  std::string bytes = file_beginning(slice.sop_class, slice.series + ".9." + std::to_string(k + 1));
  for (const auto& [tag, content] : data) put_element(bytes, tag, content.first, content.second);
  return bytes;
}

}  // namespace glisson::test
