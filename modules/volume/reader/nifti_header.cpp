// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "glisson/core/error.h"
#include "raw_volume.h"

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

/// The library fills up a file that ends early with zeros: count its bytes ourselves.
void check_complete(const Request& request, const Header& header) {
  double values = 1.0;
  const int dimensions = std::clamp<int>(header.at<std::int16_t>(40), 0, 7);
  for (int axis = 1; axis <= dimensions; ++axis)
    values *= std::max<int>(1, header.at<std::int16_t>(40 + 2 * axis));
  const double expected = header.number(108) + values * header.at<std::int16_t>(72) / 8.0;
  gzFile file = gzopen(request.path.c_str(), "rb");
  std::vector<char> buffer(1u << 20);
  double total = 0.0;
  int got = 0;
  while ((got = gzread(file, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) total += got;
  const int state = gzclose(file);
  if (got < 0 || state != Z_OK || total < expected)
    throw InputError(request.name, "voxels", "end early: the file is damaged", "Export it again");
}

}  // namespace

void check_nifti_header(const Request& request) {
  const Header header(request);
  check_complete(request, header);
  const bool has_qform = header.at<std::int16_t>(252) > 0, has_sform = header.at<std::int16_t>(254) > 0;
  if (!has_qform && !has_sform)
    throw InputError(request.name, "qform_code, sform_code",
                     "are both 0: the file does not say which way the patient lies",
                     "Set one of them, or convert the original DICOM series");
  const Affine s = has_sform ? sform(header) : qform(header);
  const Affine q = has_qform ? qform(header) : s;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    if (!(std::abs(s.col(a).normalized().dot(s.col(b).normalized())) < 1e-3))
      throw InputError(request.name, "sform", "has axes that are not at right angles (a sheared volume)",
                       "Resample the volume to a rectangular grid");
  }
  const Eigen::Vector3d far(header.at<std::int16_t>(42) - 1.0, header.at<std::int16_t>(44) - 1.0,
                            header.at<std::int16_t>(46) - 1.0);
  const double spacing = std::min({s.col(0).norm(), s.col(1).norm(), s.col(2).norm()});
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
}

}  // namespace glisson::reader
