// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom_pixels.h"

#include <gdcmByteValue.h>

#include <cstring>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

/// Such pixels are a list of fragments in explicit little endian, closed by a mark of its own.
bool fragments_are_closed(const std::string& bytes) {
  static const std::string kStart("\xE0\x7F\x10\x00OB\x00\x00\xFF\xFF\xFF\xFF", 12);
  static const std::string kEnd("\xFE\xFF\xDD\xE0\x00\x00\x00\x00", 8);
  const std::size_t start = bytes.rfind(kStart);
  return start != std::string::npos && bytes.find(kEnd, start) != std::string::npos;
}

std::string bytes_of(std::uint32_t value, bool big) {
  std::string bytes(4, '\0');
  for (unsigned n = 0; n < 4; ++n) bytes[big ? 3 - n : n] = static_cast<char>(value >> (8 * n) & 0xFFU);
  return bytes;
}

template <class T>
void append_rescaled(const std::vector<char>& bytes, const gdcm::Image& image, std::vector<float>& voxels) {
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
    T stored{};
    std::memcpy(&stored, bytes.data() + at, sizeof(T));
    voxels.push_back(
        static_cast<float>(image.GetSlope() * static_cast<double>(stored) + image.GetIntercept()));
  }
}

/// Whether what follows the pixels can: nothing, the padding of a medium's sectors, or elements of a higher
/// tag. Bytes that were put in among the pixels push the last ones out behind them.
bool can_follow(const std::string& bytes, std::size_t at, bool big) {
  constexpr std::size_t kElement = 8;  // the shortest: tag and length
  if (at == bytes.size()) return true;
  if (bytes.size() - at < kElement) return false;
  if (bytes.find_first_not_of('\0', at) == std::string::npos) return true;
  const auto half = [&](std::size_t first) {
    const auto byte = [&](std::size_t n) {
      return static_cast<unsigned>(static_cast<unsigned char>(bytes[n]));
    };
    return big ? byte(first) << 8U | byte(first + 1) : byte(first + 1) << 8U | byte(first);
  };
  const auto is_capital = [&](std::size_t n) { return bytes[n] >= 'A' && bytes[n] <= 'Z'; };
  const bool has_type = is_capital(at + 4) && is_capital(at + 5);
  const bool fits = (half(at + 6) << 16U | half(at + 4)) <= bytes.size() - at - kElement;  // without types
  return (half(at) << 16U | half(at + 2)) > 0x7FE00010U && (has_type || fits);
}

}  // namespace

StoredValue value_in(const std::string& bytes, std::uint32_t length) {
  for (const bool big : {false, true}) {
    const std::string tag = big ? std::string("\x7F\xE0\x00\x10", 4) : std::string("\xE0\x7F\x10\x00", 4);
    for (const char* type : {"OW", "OB", ""}) {
      const std::string head =
          tag + (*type == '\0' ? "" : type + std::string(2, '\0')) + bytes_of(length, big);
      const std::size_t at = bytes.rfind(head);
      if (at == std::string::npos) continue;
      const std::size_t begin = at + head.size();
      if (bytes.size() - begin < length) return StoredValue::cut;
      return can_follow(bytes, begin + length, big) ? StoredValue::whole : StoredValue::shifted;
    }
  }
  return StoredValue::whole;
}

void check_same_rule(const Request& request, const std::string& modality, const std::string& first_file,
                     const PixelRule& first, const std::string& file, const PixelRule& rule) {
  static constexpr std::array kBits = {"BitsAllocated (0028|0100)", "BitsStored (0028|0101)",
                                       "HighBit (0028|0102)", "PixelRepresentation (0028|0103)"};
  const std::string remedy = "Export the series again";
  for (std::size_t n = 0; n < kBits.size(); ++n)
    if (rule.bits[n] != first.bits[n])
      refuse(request, file + ", " + kBits[n],
             "is \"" + rule.bits[n] + "\" where " + first_file + " says \"" + first.bits[n] + "\"", remedy);
  const bool each_its_own = modality == "MR" || modality == "PT" || modality == "NM";
  const auto compare = [&](const char* field, const std::optional<double>& value,
                           const std::optional<double>& other) {
    if (value.has_value() != other.has_value())
      refuse(request, file + ", " + field, "stands in some slices and is missing in others", remedy);
    if (!each_its_own && value != other)
      refuse(request, file + ", " + field, "is another than in " + first_file, remedy);
  };
  compare("RescaleSlope (0028|1053)", rule.slope, first.slope);
  compare("RescaleIntercept (0028|1052)", rule.intercept, first.intercept);
}

void check_pixel_bytes(const Request& request, const fs::path& path, const gdcm::Image& image,
                       std::size_t bytes) {
  const std::string file = path.filename().string();
  const gdcm::ByteValue* plain = image.GetDataElement().GetByteValue();
  const std::string content = read_file(path);
  if (plain == nullptr) {
    if (!fragments_are_closed(content))
      refuse(request, file, "has pixels that cannot be decoded", "Export the series again, uncompressed");
    return;
  }
  const std::size_t announced = plain->GetLength();
  const StoredValue value = value_in(content, static_cast<std::uint32_t>(announced));
  if (announced < bytes || value == StoredValue::cut)
    refuse(request, file + ", PixelData (7fe0|0010)", "ends early: the slice was cut",
           "Export the series again");
  if (announced > bytes + 1)  // lengths are even
    refuse(request, file + ", Rows, Columns (0028|0010, 0028|0011)", "say fewer pixels than the slice holds",
           "Export the series again");
  if (value == StoredValue::shifted)
    refuse(request, file + ", PixelData (7fe0|0010)",
           "is followed by no element: bytes were put in among them", "Export the series again");
}

void append_slice(const Request& request, const fs::path& path, const Eigen::Vector2i& size,
                  std::vector<float>& voxels) {
  const auto refuse_pixels = [&] {
    refuse(request, path.filename().string(), "has pixels that cannot be decoded",
           "Export the series again, uncompressed");
  };
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read()) refuse_pixels();
  if (reader.GetFile().GetDataSet().FindDataElement(gdcm::Tag(0x0028, 0x3000)))
    refuse(request, path.filename().string(),
           "gives its intensities by a table (Modality LUT), which is not read",
           "Export the series with RescaleSlope and RescaleIntercept");
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  const auto pixels = static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y());
  std::vector<char> bytes(image.GetBufferLength());
  check_pixel_bytes(request, path, image, bytes.size());
  if (format.GetSamplesPerPixel() != 1 || bytes.size() != pixels * format.GetPixelSize() ||
      !image.GetBuffer(bytes.data()))
    refuse_pixels();
  switch (format.GetScalarType()) {
    case gdcm::PixelFormat::UINT8:
      return append_rescaled<std::uint8_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT8:
      return append_rescaled<std::int8_t>(bytes, image, voxels);
    case gdcm::PixelFormat::UINT16:
      return append_rescaled<std::uint16_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT16:
      return append_rescaled<std::int16_t>(bytes, image, voxels);
    case gdcm::PixelFormat::UINT32:
      return append_rescaled<std::uint32_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT32:
      return append_rescaled<std::int32_t>(bytes, image, voxels);
    default:
      refuse(request, path.filename().string(), "has pixels in a number format that is not known",
             "Export the series again as 16-bit integers");
  }
}

}  // namespace glisson::reader
