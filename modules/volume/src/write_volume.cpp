// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>

#include "compressed.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "slicer_segments.h"

// The three formats are simple to write, and writing them here lets a full disk be noticed: the library
// writers report success then. Tests read them back through ITK.

namespace glisson {
namespace {

static_assert(std::endian::native == std::endian::little, "voxels are written as they lie in memory");

enum class Number { uint8, int16, uint16 };

/// Voxels to be written, whatever they mean.
struct Payload {
  const VolumeGrid& grid;
  Number number;
  const void* data;
  std::vector<std::pair<std::string, std::string>> keys;
  std::size_t bytes() const {
    return static_cast<std::size_t>(grid.voxel_count()) * (number == Number::uint8 ? 1 : 2);
  }
};

std::ostringstream exact_stream() {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(17);
  return stream;
}

/// NRRD keeps line breaks and backslashes of a value escaped.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\\')
      result += "\\\\";
    else if (letter == '\n' || letter == '\r')
      result += letter == '\n' ? "\\n" : " ";
    else
      result += letter;
  }
  return result;
}

/// http://teem.sourceforge.net/nrrd/format.html
std::string nrrd(const Payload& payload) {
  std::ostringstream header = exact_stream();
  const auto vector = [&](const Eigen::Vector3d& v) {
    header << '(' << v.x() << ',' << v.y() << ',' << v.z() << ')';
  };
  const VolumeGrid& grid = payload.grid;
  header << "NRRD0004\n# Written by Glisson\ntype: "
         << (payload.number == Number::uint8   ? "unsigned char"
             : payload.number == Number::int16 ? "short"
                                               : "unsigned short")
         << "\ndimension: 3\nspace: left-posterior-superior\nsizes: " << grid.size.x() << ' ' << grid.size.y()
         << ' ' << grid.size.z() << "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis) {
    header << ' ';
    vector(grid.direction.col(axis) * grid.spacing_mm[axis]);
  }
  header << "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: ";
  vector(grid.origin_mm);
  header << "\nspace units: \"mm\" \"mm\" \"mm\"\n";
  for (const auto& [key, value] : payload.keys) header << key << ":=" << escaped(value) << '\n';
  header << '\n';
  return header.str() + compressed(payload.data, payload.bytes(), Wrapper::gzip);
}

template <class T>
void put(std::string& bytes, std::size_t offset, T value) {
  std::memcpy(bytes.data() + offset, &value, sizeof(T));
}

/// nifti1.h, methods 2 and 3 (the same affine in both).
std::string nifti(const Payload& payload) {
  const VolumeGrid& grid = payload.grid;
  std::string header(352, '\0');
  put<std::int32_t>(header, 0, 348);
  const std::array<int, 8> dim = {3, grid.size.x(), grid.size.y(), grid.size.z(), 1, 1, 1, 1};
  if (grid.size.maxCoeff() > 32767)
    throw InputError("", "size", "is more than NIfTI can hold", "Write .nrrd instead");
  for (std::size_t i = 0; i < 8; ++i) put(header, 40 + 2 * i, static_cast<std::int16_t>(dim[i]));
  put<std::int16_t>(header, 70,
                    payload.number == Number::uint8   ? 2
                    : payload.number == Number::int16 ? 4
                                                      : 512);
  put<std::int16_t>(header, 72, payload.number == Number::uint8 ? 8 : 16);
  put(header, 108, 352.0F);   // vox_offset
  put(header, 112, 1.0F);     // scl_slope
  put<char>(header, 123, 2);  // xyzt_units: mm
  put<std::int16_t>(header, 252, 1);
  put<std::int16_t>(header, 254, 1);

  const Eigen::Vector3d ras_from_lps(-1.0, -1.0, 1.0);
  const Eigen::Matrix3d direction = ras_from_lps.asDiagonal() * grid.direction;
  const Eigen::Vector3d origin = ras_from_lps.cwiseProduct(grid.origin_mm);
  Eigen::Matrix3d rotation = direction;
  const float handedness = direction.determinant() < 0.0 ? -1.0F : 1.0F;
  rotation.col(2) *= static_cast<double>(handedness);
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0.0) q.coeffs() *= -1.0;  // NIfTI stores b, c, d and takes a >= 0
  put(header, 76, handedness);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    put(header, 80 + 4 * axis, static_cast<float>(grid.spacing_mm[i]));
    put(header, 256 + 4 * axis, static_cast<float>(q.vec()[i]));
    put(header, 268 + 4 * axis, static_cast<float>(origin[i]));
    for (std::size_t column = 0; column < 3; ++column) {
      const auto j = static_cast<Eigen::Index>(column);
      put(header, 280 + 16 * axis + 4 * column, static_cast<float>(direction(i, j) * grid.spacing_mm[j]));
    }
    put(header, 280 + 16 * axis + 12, static_cast<float>(origin[i]));
  }
  std::memcpy(header.data() + 344, "n+1", 4);
  return header.append(static_cast<const char*>(payload.data), payload.bytes());
}

/// https://itk.org/Wiki/ITK/MetaIO/Documentation
std::string meta_image(const Payload& payload) {
  const VolumeGrid& grid = payload.grid;
  const std::string voxels = compressed(payload.data, payload.bytes(), Wrapper::zlib);
  std::ostringstream header = exact_stream();
  header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = True\nCompressedDataSize = "
         << voxels.size() << "\nTransformMatrix =";
  for (int column = 0; column < 3; ++column)  // MetaIO lists the axes one after the other
    for (int row = 0; row < 3; ++row) header << ' ' << grid.direction(row, column);
  header << "\nOffset = " << grid.origin_mm.x() << ' ' << grid.origin_mm.y() << ' ' << grid.origin_mm.z()
         << "\nCenterOfRotation = 0 0 0\nElementSpacing = " << grid.spacing_mm.x() << ' '
         << grid.spacing_mm.y() << ' ' << grid.spacing_mm.z() << "\nDimSize = " << grid.size.x() << ' '
         << grid.size.y() << ' ' << grid.size.z() << "\nElementType = "
         << (payload.number == Number::uint8   ? "MET_UCHAR"
             : payload.number == Number::int16 ? "MET_SHORT"
                                               : "MET_USHORT")
         << "\nElementDataFile = LOCAL\n";
  return header.str() + voxels;
}

void write_payload(const std::filesystem::path& path, const Payload& payload) {
  const std::string name = path.filename().string();
  const auto ends = [&](const char* end) { return name.ends_with(end); };
  if (ends(".nrrd")) {
    write_file_atomically(path, nrrd(payload));
  } else if (ends(".nii.gz")) {
    const std::string plain = nifti(payload);
    write_file_atomically(path, compressed(plain.data(), plain.size(), Wrapper::gzip));
  } else if (ends(".nii")) {
    write_file_atomically(path, nifti(payload));
  } else if (ends(".mha")) {
    write_file_atomically(path, meta_image(payload));
  } else {
    throw InputError(path.string(), "", "has an extension that volumes are not written to",
                     "Use .nrrd, .nii.gz, .nii or .mha");
  }
}

/// `infos` with an entry for each label present, and none for labels that are not.
std::vector<LabelInfo> infos_for(const LabelVolume& labels, const std::vector<LabelInfo>& infos) {
  std::vector<LabelInfo> result;
  const std::vector<long> counts = labels.histogram();
  for (std::size_t code = 1; code < counts.size(); ++code) {
    if (counts[code] == 0) continue;
    const auto found =
        std::find_if(infos.begin(), infos.end(), [&](const LabelInfo& info) { return info.code == code; });
    result.push_back(found != infos.end() ? *found
                                          : LabelInfo{static_cast<Label>(code), "", "", {0.5, 0.5, 0.5}});
  }
  return result;
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image) {
  require(!image.empty() && static_cast<long>(image.voxels->size()) == image.grid.voxel_count(),
          "an image that is written has one value a voxel");
  Payload payload{image.grid, Number::int16, image.voxels->data(), {}};
  payload.keys.emplace_back("modality", modality_code(image.modality));
  if (!image.description.empty()) payload.keys.emplace_back("description", image.description);
  write_payload(path, payload);
}

void write_labels(const std::filesystem::path& path, const LabelVolume& labels,
                  const std::vector<LabelInfo>& infos) {
  require(!labels.empty(), "labels that are written have a voxel");
  const std::vector<Label> dense = labels.dense();
  std::vector<std::pair<std::string, std::string>> keys;
  if (path.filename().string().ends_with(".seg.nrrd"))
    keys = slicer_keys(labels.grid(), infos_for(labels, infos));
  const Label largest = *std::max_element(dense.begin(), dense.end());
  if (largest > 255) {
    write_payload(path, {labels.grid(), Number::uint16, dense.data(), std::move(keys)});
    return;
  }
  const std::vector<std::uint8_t> bytes(dense.begin(), dense.end());
  write_payload(path, {labels.grid(), Number::uint8, bytes.data(), std::move(keys)});
}

}  // namespace glisson
