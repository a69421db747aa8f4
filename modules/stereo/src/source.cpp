// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/source.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reach.h"
#include "picture_cv.h"
#include "rig_check.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kDevicePrefix = "device:", kIgtlPrefix = "igtl:";

constexpr const char* kRemedy =
    "Expected {\"left\": \"scope.mkv\", \"layout\": \"side_by_side\" or \"top_bottom\" or "
    "\"row_interleaved\" or \"separate\", ...}";

constexpr std::pair<const char*, Layout> kLayouts[] = {{"side_by_side", Layout::side_by_side},
                                                       {"top_bottom", Layout::top_bottom},
                                                       {"row_interleaved", Layout::row_interleaved},
                                                       {"separate", Layout::separate}};

/// What a description that lies in a folder names: paths are relative to it.
std::string source_in(const fs::path& folder, const std::string& named) {
  if (named.empty() || is_live(named) || fs::path(named).is_absolute()) return named;
  return (folder / named).string();
}

/// The fields of a description, each checked.
class Fields {
 public:
  explicit Fields(const fs::path& path)
      : file_(path.string()), folder_(path.parent_path()), json_(read_json(path)) {
    if (!json_.is_object()) refuse("", "is no description of a source");
    for (const auto& [key, value] : json_.items())
      if (std::find(std::begin(kKnown), std::end(kKnown), key) == std::end(kKnown))
        refuse(key.c_str(), "is not known");
  }

  std::string source(const char* key) const {
    if (!json_.contains(key)) return {};
    if (!json_[key].is_string()) refuse(key, "is no text");
    return source_in(folder_, json_[key].get<std::string>());
  }
  bool flag(const char* key) const {
    if (!json_.contains(key)) return false;
    if (!json_[key].is_boolean()) refuse(key, "is neither true nor false");
    return json_[key].get<bool>();
  }
  double number(const char* key, double fallback) const {
    if (!json_.contains(key)) return fallback;
    if (!json_[key].is_number()) refuse(key, "is no number");
    return json_[key].get<double>();
  }
  Layout layout(Layout fallback) const {
    if (!json_.contains("layout")) return fallback;
    for (const auto& [name, layout] : kLayouts)
      if (json_["layout"] == name) return layout;
    refuse("layout", "is none");
  }
  Crop crop() const {
    if (!json_.contains("crop")) return {};
    const nlohmann::json& list = json_["crop"];
    if (!list.is_array() || list.size() != 4) refuse("crop", "is not [x, y, width, height]");
    for (const nlohmann::json& side : list)
      if (!side.is_number_integer() || side.get<std::int64_t>() < 0 || side.get<std::int64_t>() > 100000)
        refuse("crop", "holds what is no number of pixels");
    return {list[0].get<int>(), list[1].get<int>(), list[2].get<int>(), list[3].get<int>()};
  }

 private:
  static constexpr const char* kKnown[] = {
      "left",           "right", "layout", "right_first", "deinterlace", "crop", "pictures_per_second",
      "largest_skew_ms"};
  [[noreturn]] void refuse(const char* field, const char* problem) const {
    throw InputError(file_, field, problem, kRemedy);
  }

  std::string file_;
  fs::path folder_;
  nlohmann::json json_;
};

}  // namespace

bool is_device(std::string_view source) { return source.starts_with(kDevicePrefix); }

std::string device_of(std::string_view source) {
  require(is_device(source), "a device is named by its source");
  return std::string(source.substr(kDevicePrefix.size()));
}

std::string device_source(std::string_view device) {
  return std::string(kDevicePrefix) + std::string(device);
}

bool is_igtl(std::string_view source) { return source.starts_with(kIgtlPrefix); }

std::string igtl_source(std::string_view pictures) {
  return std::string(kIgtlPrefix) + std::string(pictures);
}

bool is_pattern(std::string_view source) { return source.find_first_of("*?") != std::string_view::npos; }

bool is_live(std::string_view source) { return is_device(source) || is_igtl(source); }

void SourceOptions::validate() const {
  const auto refuse = [&](const char* field, const std::string& problem, const char* remedy) {
    throw InputError(left.empty() ? "source" : left, field, problem, remedy);
  };
  if (left.empty()) refuse("left", "is empty", "Name a video, a folder of pictures or a device");
  if ((layout == Layout::separate) == right.empty() &&
      !(right.empty() && !is_live(left) && fs::is_directory(left)))
    refuse("right", right.empty() ? "is missing" : "is one file too many for this layout",
           "Separate views have a left and a right source, others one");
  if (is_igtl(right) || (is_igtl(left) && layout != Layout::side_by_side))
    refuse("layout", "is not that of a server, which sends both views",
           "Name both devices in one source, as igtl:127.0.0.1:18944/LEFT,RIGHT, without a layout");
  if (crop.x < 0 || crop.y < 0 || crop.width < 0 || crop.height < 0)
    refuse("crop", "has a negative number", "Crop within the picture");
  if (!(pictures_per_second > 0.0) || pictures_per_second > 1000.0)
    refuse("pictures_per_second", "is " + number_text(pictures_per_second),
           "Give a number from 0.01 to 1000");
  if (!(largest_skew >= 0.0) || largest_skew > 1.0)
    refuse("largest_skew_ms", "is " + number_text(1e3 * largest_skew),
           "Give up to a second; 0 is half a frame");
}

SourceOptions read_source(const fs::path& path) {
  const Fields fields(path);
  SourceOptions options;
  options.left = fields.source("left");
  options.right = fields.source("right");
  options.layout = fields.layout(options.right.empty() ? Layout::side_by_side : Layout::separate);
  options.right_first = fields.flag("right_first");
  options.deinterlace = fields.flag("deinterlace");
  options.crop = fields.crop();
  options.pictures_per_second = fields.number("pictures_per_second", options.pictures_per_second);
  options.largest_skew = 1e-3 * fields.number("largest_skew_ms", 0.0);
  options.validate();
  return options;
}

void write_source(const fs::path& path, const SourceOptions& options) {
  options.validate();
  nlohmann::json document = {
      {"left", options.left},
      {"right_first", options.right_first},
      {"deinterlace", options.deinterlace},
      {"crop", {options.crop.x, options.crop.y, options.crop.width, options.crop.height}},
      {"pictures_per_second", options.pictures_per_second},
      {"largest_skew_ms", 1e3 * options.largest_skew}};
  if (!options.right.empty()) document["right"] = options.right;
  for (const auto& [name, layout] : kLayouts)
    if (layout == options.layout) document["layout"] = name;
  write_json(path, document);
  std::vector<std::string> entered = {path.string()};
  for (const std::string& source : {options.left, options.right})
    entered.push_back(source_in(path.parent_path(), source));
  remember_sources(entered);
}

bool leaves(const Cut& cut, int width, int height) {
  if (width <= 0 || height <= 0) return true;
  const Crop& crop = cut.crop;
  return width == (crop.width > 0 ? crop.width : cut.whole_width - crop.x) &&
         height == (crop.height > 0 ? crop.height : cut.whole_height - crop.y);
}

std::optional<Cut> cut_of(const fs::path& video, int width, int height) {
  if (video.extension() != ".json") return {};
  const SourceOptions source = read_entered_source(video);
  if (!source.crop.any()) return {};  // not opened for nothing
  const std::optional<Cut> cut = StereoVideo(source).cut();
  return cut && leaves(*cut, width, height) ? cut : std::nullopt;
}

StereoRig cropped(const StereoRig& rig, const Crop& crop) {
  StereoRig result = rig;
  for (Camera* camera : {&result.left, &result.right}) {
    camera->matrix(0, 2) -= crop.x;
    camera->matrix(1, 2) -= crop.y;
    camera->width = crop.width > 0 ? crop.width : camera->width - crop.x;
    camera->height = crop.height > 0 ? crop.height : camera->height - crop.y;
    if (camera->width < 16 || camera->height < 16)
      throw InputError("crop", "", "leaves nothing of the picture", "Crop within the picture");
    check_camera("crop", "", *camera);
  }
  return result;
}

cv::Mat one_field(const cv::Mat& image, int first) {
  cv::Mat result = image.clone();
  const auto row = [&](int y) {  // of the field, mirrored at the borders
    y = std::clamp(y, first, first + (image.rows - 1 - first) / 2 * 2);
    return image.ptr<std::uint8_t>(y);
  };
  const int bytes = image.cols * image.channels();
  for (int y = 1 - first; y < image.rows; y += 2) {
    const std::uint8_t *a = row(y - 3), *b = row(y - 1), *c = row(y + 1), *d = row(y + 3);
    std::uint8_t* to = result.ptr<std::uint8_t>(y);
    for (int i = 0; i < bytes; ++i)  // the cubic through four rows, at their middle
      to[i] = static_cast<std::uint8_t>(std::clamp((9 * (b[i] + c[i]) - a[i] - d[i] + 8) / 16, 0, 255));
  }
  return result;
}

}  // namespace glisson::stereo
