// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/calibration_io.h"

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>
#include <stdexcept>
#include <string>

#include "camera_cv.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/units.h"
#include "rig_check.h"

namespace glisson::stereo {
namespace {

constexpr const char* kCalibrateAgain = "Write the calibration anew or calibrate again";
class Reader {
 public:
  Reader(std::string file, const std::string& content) : file_(std::move(file)) {
    // Text only: the parser trusts the structure of what looks like binary blocks.
    if (content.size() > (1u << 20) || content.find('\0') != std::string::npos)
      throw InputError(file_, "", "is not a calibration (too large, or not text)", kCalibrateAgain);
    try {
      if (!storage_.open(content, cv::FileStorage::READ | cv::FileStorage::MEMORY))
        throw InputError(file_, "", "is not an OpenCV YAML file", kCalibrateAgain);
    } catch (const cv::Exception& failure) {
      throw InputError(file_, "", "is not valid OpenCV YAML (" + first_line(failure.err) + ")",
                       kCalibrateAgain);
    } catch (const std::length_error&) {  // its parser lets the standard library's own errors out
      throw InputError(file_, "", "is not valid OpenCV YAML", kCalibrateAgain);
    }
  }

  cv::FileNode node(const char* name) const {
    cv::FileNode found;
    try {
      found = storage_[name];
    } catch (const cv::Exception&) {
      found = cv::FileNode();
    }
    if (found.empty()) throw InputError(file_, name, "is missing", kCalibrateAgain);
    return found;
  }

  cv::Mat matrix(const char* name) const {
    cv::Mat read, values;
    const cv::FileNode found = node(name);
    try {
      // OpenCV would reserve whatever size the file claims.
      const auto side = [&](const char* key) {
        return found[key].isInt() ? static_cast<int>(found[key]) : 0;
      };
      const int rows = side("rows"), columns = side("cols");
      if (rows < 1 || rows > 16 || columns < 1 || columns > 16)
        throw InputError(file_, name, "is not a matrix of a calibration's size", kCalibrateAgain);
      found >> read;
      read.convertTo(values, CV_64F);
    } catch (const cv::Exception&) {
      throw InputError(file_, name, "is not a matrix", kCalibrateAgain);
    }
    if (values.empty() || values.channels() != 1 || values.dims != 2)
      throw InputError(file_, name, "is not a matrix", kCalibrateAgain);
    for (int r = 0; r < values.rows; ++r)
      for (int c = 0; c < values.cols; ++c)
        if (!std::isfinite(values.at<double>(r, c)))
          throw InputError(file_, name, "has an entry that is not a number", kCalibrateAgain);
    return values;
  }

  Eigen::Matrix3d square(const char* name) const {
    const cv::Mat values = matrix(name);
    if (values.rows != 3 || values.cols != 3)
      throw InputError(file_, name,
                       "is " + std::to_string(values.rows) + "x" + std::to_string(values.cols) + ", not 3x3",
                       kCalibrateAgain);
    Eigen::Matrix3d result;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) result(r, c) = values.at<double>(r, c);
    return result;
  }

  /// A row or a column. @param least, most allowed lengths.
  std::vector<double> vector(const char* name, int least, int most) const {
    const cv::Mat values = matrix(name);
    const int length = static_cast<int>(values.total());
    if (std::min(values.rows, values.cols) != 1 || length < least || length > most)
      throw InputError(file_, name,
                       "is " + std::to_string(values.rows) + "x" + std::to_string(values.cols) +
                           ", not a vector of " + std::to_string(least) + (most > least ? " or more" : "") +
                           " numbers",
                       kCalibrateAgain);
    std::vector<double> result;
    result.reserve(values.total());
    for (int i = 0; i < length; ++i)
      result.push_back(values.rows == 1 ? values.at<double>(0, i) : values.at<double>(i, 0));
    return result;
  }

  int pixels(const char* name) const {
    const cv::FileNode found = node(name);
    if (!found.isInt() || static_cast<int>(found) < 16 || static_cast<int>(found) > 16384)
      throw InputError(file_, name, "is not a number of pixels from 16 to 16384", kCalibrateAgain);
    return static_cast<int>(found);
  }

  double metres_per_unit() const {
    const cv::FileNode found = node("unit");
    const std::string unit = found.isString() ? static_cast<std::string>(found) : std::string();
    if (unit == "mm") return metres_per(LengthUnit::millimetre);
    if (unit == "cm") return metres_per(LengthUnit::centimetre);
    if (unit == "m") return metres_per(LengthUnit::metre);
    throw InputError(file_, "unit", "is \"" + unit.substr(0, 20) + "\", which is no unit of length here",
                     "Write mm, cm or m: the unit of T");
  }

  Camera camera(const char* matrix_name, const char* distortion_name, int width, int height) const {
    Camera result;
    result.width = width;
    result.height = height;
    result.matrix = square(matrix_name);
    check_camera(file_, matrix_name, result);
    const std::vector<double> d = vector(distortion_name, 4, 14);
    for (std::size_t i = 0; i < d.size(); ++i) {
      if (i < 5)
        result.distortion[static_cast<Eigen::Index>(i)] = d[i];
      else if (d[i] != 0.0)
        throw InputError(file_, distortion_name, "uses more than the five terms k1 k2 p1 p2 k3",
                         "Calibrate without the rational, thin-prism and tilted models");
    }
    return result;
  }

  const std::string& file() const { return file_; }

 private:
  static std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n')).substr(0, 120);
  }

  std::string file_;
  cv::FileStorage storage_;
};

}  // namespace

StereoRig read_calibration(const std::filesystem::path& path) {
  const Reader reader(path.string(), read_file(path));
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

}  // namespace glisson::stereo
