// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

#include "claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"

namespace glisson::reader {
namespace {

constexpr int kHeaderBytes = 348;

/// The header's bytes with typed access, in the file's byte order.
class Header {
 public:
  explicit Header(const Request& request) {
    // zlib reads plain files as they are.
    gzFile file = gzopen(request.path.c_str(), "rb");
    if (file == nullptr) throw FileError(request.name + ": cannot be opened. Check the path.");
    const int got = gzread(file, bytes_.data(), kHeaderBytes);
    gzclose(file);
    if (got != kHeaderBytes)
      throw InputError(request.name, "header", "ends early", "The file is damaged: export it again");
    swapped_ = at<std::int32_t>(0) != kHeaderBytes;
    if (at<std::int32_t>(0) != kHeaderBytes)
      throw InputError(request.name, "header", "is not that of a NIfTI-1 file", "Export it as NIfTI-1");
    if (std::memcmp(bytes_.data() + 344, "n+1", 4) != 0)
      throw InputError(request.name, "magic", "is not that of a NIfTI-1 file that holds its voxels itself",
                       "Export it as one .nii or .nii.gz file");
  }
  template <class T>
  T at(int offset) const {
    std::array<char, sizeof(T)> raw;
    std::copy_n(bytes_.begin() + offset, sizeof(T), raw.begin());
    if (swapped_) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return value;
  }
  double number(int offset) const { return at<float>(offset); }

 private:
  std::array<char, kHeaderBytes> bytes_{};
  bool swapped_ = false;
};

using Affine = Eigen::Matrix<double, 3, 4>;

Affine qform(const Header& header) {
  const double b = header.number(256), c = header.number(260), d = header.number(264);
  const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
  Eigen::Matrix3d rotation = Eigen::Quaterniond(a, b, c, d).normalized().toRotationMatrix();
  if (header.number(76) < 0.0) rotation.col(2) *= -1.0;
  Affine affine;
  for (int axis = 0; axis < 3; ++axis) {
    affine.col(axis) = rotation.col(axis) * header.number(80 + 4 * axis);
    affine(axis, 3) = header.number(268 + 4 * axis);
  }
  return affine;
}

Affine sform(const Header& header) {
  Affine affine;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      affine(row, column) = header.number(280 + 16 * row + 4 * column);
  return affine;
}

[[noreturn]] void refuse(const Request& request, const std::string& field, const std::string& problem) {
  refuse(request, field, problem, "Correct the header, or export the volume again");
}

/// nifti1.h: bytes of a number by its code.
int bytes_of_type(const Request& request, int datatype) {
  static const std::map<int, int> kBytes = {{2, 1},   {4, 2},   {8, 4},   {16, 4},   {64, 8},
                                            {256, 1}, {512, 2}, {768, 4}, {1024, 8}, {1280, 8}};
  if (datatype == 128 || datatype == 2304)
    refuse(request, "datatype", "is that of a colour picture", "Export a volume with one value a voxel");
  const auto known = kBytes.find(datatype);
  if (known == kBytes.end())
    refuse(request, "datatype",
           "is \"" + std::to_string(datatype) + "\", which is no number format that is known",
           "Export it as 16-bit integers");
  return known->second;
}

void read_sizes(const Request& request, const Header& header, Claim& claim) {
  const int dimensions = header.at<std::int16_t>(40);
  if (dimensions < 1 || dimensions > 7)
    refuse(request, "dim[0]", "is " + std::to_string(dimensions) + ", not 3");
  if (dimensions < 3)
    refuse(request, "dim[0]", "is that of a flat picture, not of a volume", "Name a volume");
  for (int axis = 1; axis <= dimensions; ++axis) {
    const int size = header.at<std::int16_t>(40 + 2 * axis);
    const std::string field = "dim[" + std::to_string(axis) + "]";
    if (size < 1) refuse(request, field, "is " + std::to_string(size) + ", which is no number of voxels");
    if (axis <= 3) claim.size[axis - 1] = size;
    if (axis == 5) claim.components = size;
    if (axis > 3 && axis != 5 && size > 1)
      refuse(request, field, "is a series of " + std::to_string(size) + " volumes, not one volume",
             "Export a single time point");
  }
  check_value_count(request, claim.size, claim.components);
}

void check_units_and_scale(const Request& request, const Header& header) {
  const int unit = header.at<std::uint8_t>(123) & 7;
  if (unit != 0 && unit != 2)
    refuse(request, "xyzt_units",
           unit == 1   ? "says metres"
           : unit == 3 ? "says micrometres"
                       : "is no unit of length",
           "Convert the volume to millimetres");
  // No slope means no scale (nifti1.h): an intercept beside it says the opposite. A negative one turns light
  // into dark, a tiny one makes all voxels one value.
  const double slope = header.number(112), intercept = header.number(116);
  if (!(slope >= 0.0 && slope <= 1e6) || (slope > 0.0 && slope < 1e-6) || !(std::abs(intercept) <= 1e6) ||
      (slope == 0.0 && intercept != 0.0))
    refuse(request, "scl_slope, scl_inter", "are no scale of intensities", "Set them to 1 and 0");
}

/// The data's place and length.
void check_data(const Request& request, const Header& header, const Claim& claim) {
  const int bytes = bytes_of_type(request, header.at<std::int16_t>(70));
  if (header.at<std::int16_t>(72) != 8 * bytes)
    refuse(request, "bitpix",
           "is " + std::to_string(header.at<std::int16_t>(72)) + " where the datatype says " +
               std::to_string(8 * bytes));
  const double offset = header.number(108);
  if (!(offset >= kHeaderBytes && offset < 1e7) || offset != std::floor(offset))
    refuse(request, "vox_offset", "is no place in the file behind its header");
  Stored stored;
  stored.file = request.path;
  stored.packed = lower_name(request.path).ends_with("z");
  stored.packed_field = "";
  stored.row_bytes = static_cast<double>(bytes) * claim.size.x();
  stored.bytes = offset + stored.row_bytes * claim.components * claim.size.y() * claim.size.z();
  check_stored(request, stored);
}

/// What the quaternion is made of. Without one, pixdim still has to tell the spacing of the sform: libraries
/// take it from there.
void check_quaternion(const Request& request, const Header& header, bool has_qform) {
  const Eigen::Vector3d q(header.number(256), header.number(260), header.number(264));
  if (has_qform && !(q.squaredNorm() <= 1.0 + 1e-3))
    refuse(request, "quatern", "is no rotation: b, c and d are longer than 1 together");
  const double side = header.number(76);
  if (has_qform && side != 0.0 && std::abs(side) != 1.0) refuse(request, "pixdim[0]", "is neither 1 nor -1");
  for (int axis = 1; axis <= 3; ++axis)
    if (const double length = header.number(76 + 4 * axis); !(length > 0.0 && length < 1e6))
      refuse(request, "pixdim[" + std::to_string(axis) + "]",
             "is " + std::to_string(length) + " mm, which is no voxel's");
}

Claim placed(const Request& request, const Affine& ras, Claim claim) {
  Affine lps = ras;
  lps.topRows<2>() *= -1.0;
  set_axes(request, "sform", lps.leftCols<3>(), claim);
  if (!lps.col(3).allFinite()) refuse(request, "sform", "has an origin that is not finite");
  claim.origin_mm = lps.col(3);
  claim.precision = 1e-3;  // the quaternion is stored in single precision: near half turns no better
  return claim;
}

}  // namespace

Claim claim_of_nifti(const Request& request) {
  const Header header(request);
  Claim claim;
  read_sizes(request, header, claim);
  check_units_and_scale(request, header);
  check_data(request, header, claim);
  const bool has_qform = header.at<std::int16_t>(252) > 0, has_sform = header.at<std::int16_t>(254) > 0;
  if (!has_qform && !has_sform)
    throw InputError(request.name, "qform_code, sform_code",
                     "are both 0: the file does not say which way the patient lies",
                     "Set one of them, or convert the original DICOM series");
  check_quaternion(request, header, has_qform);
  const Affine s = has_sform ? sform(header) : qform(header);
  const Affine q = has_qform ? qform(header) : s;
  claim = placed(request, s, claim);
  for (int axis = 0; axis < 3; ++axis)
    if (const double said = header.number(80 + 4 * axis);
        std::abs(said - claim.spacing_mm[axis]) > 0.01 * said)
      refuse(request, "pixdim[" + std::to_string(axis + 1) + "]",
             "says " + std::to_string(said) + " mm from voxel to voxel, and the sform " +
                 std::to_string(claim.spacing_mm[axis]),
             "Find out which is right and write the file anew with that one");
  const Eigen::Vector3d far = (claim.size - Eigen::Vector3i::Ones()).cast<double>();
  const double spacing = claim.spacing_mm.minCoeff();
  double worst = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index =
        far.cwiseProduct(Eigen::Vector3d(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1));
    const Eigen::Vector4d h = index.homogeneous();
    worst = std::max(worst, (s * h - q * h).norm());
  }
  // The quaternion is stored in single precision: near half turns it is good to about a thousandth.
  const double tolerance = 0.5 * spacing + 1e-3 * (s.leftCols<3>() * far).norm();
  if (!(worst <= tolerance))
    throw InputError(request.name, "sform, qform",
                     "place the volume differently, by up to " + std::to_string(worst) + " mm",
                     "Find out which is right and write the file anew with that one");
  return claim;
}

}  // namespace glisson::reader
