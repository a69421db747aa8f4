// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/calibration_io.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>
#include <string>
#include <utility>
#include <vector>

#include "camera_cv.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/units.h"
#include "opencv_text.h"
#include "rig_check.h"

namespace glisson::stereo {
namespace {

constexpr const char* kCalibrateAgain = "Write the calibration anew or calibrate again";
class Reader {
 public:
  Reader(std::string file, const std::string& content) : file_(std::move(file)), text_(content, file_) {}

  Eigen::Matrix3d square(const char* name) const {
    const Eigen::MatrixXd values = text_.matrix(name);
    if (values.rows() != 3 || values.cols() != 3)
      throw InputError(
          file_, name,
          "is " + std::to_string(values.rows()) + "x" + std::to_string(values.cols()) + ", not 3x3",
          kCalibrateAgain);
    return values;
  }

  /// A row or a column. @param least, most allowed lengths.
  std::vector<double> vector(const char* name, int least, int most) const {
    const Eigen::MatrixXd values = text_.matrix(name);
    if (std::min(values.rows(), values.cols()) != 1 || values.size() < least || values.size() > most)
      throw InputError(file_, name,
                       "is " + std::to_string(values.rows()) + "x" + std::to_string(values.cols()) +
                           ", not a vector of " + std::to_string(least) +
                           (most > least ? " or more numbers" : " numbers"),
                       kCalibrateAgain);
    return std::vector<double>(values.data(), values.data() + values.size());
  }

  int pixels(const char* name) const {
    const std::string text = scalar(name);
    int value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size() || value < 16 || value > 16384)
      throw InputError(file_, name, "is not a number of pixels from 16 to 16384", kCalibrateAgain);
    return value;
  }

  double metres_per_unit() const {
    const std::string unit = scalar("unit");
    if (const auto known = unit_named(unit)) return metres_per(*known);
    throw InputError(file_, "unit", "is \"" + unit.substr(0, 20) + "\", which is no unit of length here",
                     "Write mm, cm or m: the unit of T");
  }

  Camera camera(const char* matrix_name, const char* distortion_name, int width, int height) const {
    Camera result;
    result.width = width;
    result.height = height;
    result.matrix = square(matrix_name);
    check_camera(file_, matrix_name, result);
    result = without_skew(file_, matrix_name, result);
    const std::vector<double> d = vector(distortion_name, 4, 14);
    for (std::size_t i = 0; i < d.size(); ++i) {
      if (i < 5)
        result.distortion[static_cast<Eigen::Index>(i)] = d[i];
      else if (d[i] != 0.0)
        throw InputError(file_, distortion_name, "uses more than the five terms k1 k2 p1 p2 k3",
                         "Calibrate without the rational, thin-prism and tilted models");
    }
    check_distortion(file_, distortion_name, result);
    return result;
  }

  const std::string& file() const { return file_; }

 private:
  std::string scalar(const char* name) const {
    if (!text_.has(name)) throw InputError(file_, name, "is missing", kCalibrateAgain);
    return text_.scalar(name).value_or("");
  }

  std::string file_;
  OpenCvText text_;
};

}  // namespace

StereoRig read_calibration(const std::filesystem::path& path) {
  constexpr std::size_t kMostBytes = 2U << 20U;  // twice what OpenCvText takes
  const Reader reader(path.string(), read_file(path, kMostBytes));
  const double metres = reader.metres_per_unit();
  const int width = reader.pixels("image_width"), height = reader.pixels("image_height");
  StereoRig rig;
  rig.left = reader.camera("M1", "D1", width, height);
  rig.right = reader.camera("M2", "D2", width, height);
  rig.right_from_left.rotation = checked_rotation(reader.file(), "R", reader.square("R"));
  const std::vector<double> t = reader.vector("T", 3, 3);
  rig.right_from_left.translation = metres * Eigen::Vector3d(t[0], t[1], t[2]);
  check_rig(reader.file(), rig);
  return rig;
}

void write_calibration(const std::filesystem::path& path, const StereoRig& rig) {
  require(rig.left.width == rig.right.width && rig.left.height == rig.right.height,
          "both cameras of a rig have one image size");
  cv::FileStorage storage(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << "image_width" << rig.left.width << "image_height" << rig.left.height << "unit"
          << "mm";
  storage << "M1" << to_cv(rig.left.matrix) << "D1" << to_cv(rig.left.distortion.transpose());
  storage << "M2" << to_cv(rig.right.matrix) << "D2" << to_cv(rig.right.distortion.transpose());
  storage << "R" << to_cv(rig.right_from_left.rotation) << "T"
          << to_cv(1e3 * rig.right_from_left.translation);
  write_file_atomically(path, storage.releaseAndGetString());
}

bool is_text_calibration(const std::filesystem::path& path) { return std::filesystem::is_directory(path); }

StereoRig read_calibration_for(const std::filesystem::path& path, int width, int height,
                               const std::optional<Cut>& cut) {
  if (cut) width = cut->whole_width, height = cut->whole_height;
  const StereoRig rig =
      is_text_calibration(path) ? read_text_calibration(path, width, height) : read_calibration(path);
  const bool of_whole = cut && rig.left.width == width && rig.left.height == height;
  return of_whole ? cropped(rig, cut->crop) : rig;
}

std::vector<std::string> calibration_doubts(const StereoRig& rig) {
  constexpr double kShare = 0.01;  // less is in the very corners, where a scope's circle leaves no light
  std::vector<std::string> doubts;
  for (const auto& [code, camera] :
       {std::pair<const char*, const Camera*>{"left", &rig.left}, {"right", &rig.right}})
    if (const double share = share_without_rays(*camera); share > kShare)
      doubts.push_back(std::string("calibration.") + code + "_lens_turns_back " +
                       std::to_string(std::lround(100.0 * share)));
  return doubts;
}

}  // namespace glisson::stereo
