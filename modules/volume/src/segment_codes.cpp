// SPDX-License-Identifier: GPL-3.0-or-later
#include "segment_codes.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace glisson {
namespace {

std::vector<std::string> parts_of(const std::string& text, char between) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, between);) parts.push_back(part);
  return parts;
}

void take(const std::vector<std::string>& parts, std::size_t n, Code& code) {
  if (n >= parts.size()) return;
  const std::vector<std::string> words = parts_of(parts[n], '^');
  if (words.size() == 3 && std::ranges::none_of(words, &std::string::empty))
    code = {words[0], words[1], words[2]};
}

std::string text_of(const Code& code) { return code.scheme + '^' + code.value + '^' + code.meaning; }

// sRGB (IEC 61966-2-1), and the white of D65 that it is for; DICOM's is D50 by Bradford's adaptation.
const Eigen::Matrix3d& xyz_of_rgb() {
  static const Eigen::Matrix3d matrix = (Eigen::Matrix3d() << 0.4360747, 0.3850649, 0.1430804, 0.2225045,
                                         0.7168786, 0.0606169, 0.0139322, 0.0971045, 0.7141733)
                                            .finished();
  return matrix;
}
const Eigen::Vector3d kWhite(0.96422, 1.0, 0.82521);

double bent(double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; }
double straight(double f) {
  const double cube = f * f * f;
  return cube > 216.0 / 24389.0 ? cube : (116.0 * f - 16.0) * 27.0 / 24389.0;
}
double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double gamma(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055; }

}  // namespace

SegmentCodes codes_of_terminology(const std::string& entry) {
  const std::vector<std::string> parts = parts_of(entry, '~');
  SegmentCodes codes;
  take(parts, 1, codes.category);
  take(parts, 2, codes.type);
  take(parts, 5, codes.region);
  return codes;
}

std::string terminology_of(const SegmentCodes& codes) {
  return "Segmentation category and type - DICOM master list~" + text_of(codes.category) + '~' +
         text_of(codes.type) + "~^^~Anatomic codes - DICOM master list~" + text_of(codes.region) + "~^^";
}

std::array<unsigned short, 3> dicom_lab(const std::array<double, 3>& rgb) {
  const Eigen::Vector3d xyz = xyz_of_rgb() * Eigen::Vector3d(linear(rgb[0]), linear(rgb[1]), linear(rgb[2]));
  const Eigen::Vector3d f = xyz.cwiseQuotient(kWhite).unaryExpr(&bent);
  const auto stored = [](double share) {
    return static_cast<unsigned short>(std::lround(std::clamp(share, 0.0, 1.0) * 65535.0));
  };
  return {stored((116.0 * f.y() - 16.0) / 100.0), stored((500.0 * (f.x() - f.y()) + 128.0) / 255.0),
          stored((200.0 * (f.y() - f.z()) + 128.0) / 255.0)};
}

std::array<double, 3> rgb_of_dicom_lab(const std::array<unsigned short, 3>& lab) {
  const double l = 100.0 * lab[0] / 65535.0, a = 255.0 * lab[1] / 65535.0 - 128.0,
               b = 255.0 * lab[2] / 65535.0 - 128.0;
  const double y = (l + 16.0) / 116.0;
  const Eigen::Vector3d f(y + a / 500.0, y, y - b / 200.0);
  const Eigen::Vector3d xyz = f.unaryExpr(&straight).cwiseProduct(kWhite);
  const Eigen::Vector3d rgb = xyz_of_rgb().inverse() * xyz;
  const auto shown = [](double c) { return std::clamp(gamma(std::max(c, 0.0)), 0.0, 1.0); };
  return {shown(rgb.x()), shown(rgb.y()), shown(rgb.z())};
}

}  // namespace glisson
