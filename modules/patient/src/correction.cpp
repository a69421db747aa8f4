// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/correction.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/core/patient_range.h"
#include "named.h"

namespace glisson {
namespace {

using nlohmann::json;

constexpr const char* kKey = "correct";
constexpr const char* kUndo = "undo";

template <int Size>
Eigen::Matrix<double, Size, 1> numbers(const json& object, const char* field) {
  const json& list = object.at(field);
  Eigen::Matrix<double, Size, 1> result;
  if (!list.is_array() || list.size() != Size)
    throw std::invalid_argument(std::string(field) + " has another size");
  for (std::size_t i = 0; i < Size; ++i) result[static_cast<Eigen::Index>(i)] = list[i].get<double>();
  return result;
}

const char* stereo_view_code(StereoView view) { return view == StereoView::left ? "left" : "right"; }

const char* corrected_feature_code(CorrectedFeature feature) {
  switch (feature) {
    case CorrectedFeature::surface:
      return "surface";
    case CorrectedFeature::margin:
      return "anterior_margin";
    case CorrectedFeature::notch:
      return "umbilical_notch";
    case CorrectedFeature::vessel:
      return "vessel";
  }
  return "unknown";
}

CorrectionLine line_of(const json& object) {
  CorrectionLine line;
  line.frame = whole_number(object, "frame");
  line.seconds = object.value("seconds", 0.0);
  const json& said = object.at(kKey);
  if (said.is_string()) {
    if (said.get<std::string>() != kUndo) throw std::invalid_argument("only 'undo' is a word for it");
    return line;
  }
  Correction correction;
  correction.view = named(kStereoViews, stereo_view_code, said.value("view", "left"), "view");
  correction.from = numbers<2>(said, "from");
  correction.to = numbers<2>(said, "to");
  correction.sigma_px = said.value("sigma_px", correction.sigma_px);
  line.has_place = said.contains("place_mm");
  if (line.has_place) {
    correction.place_in_ct = 1e-3 * numbers<3>(said, "place_mm");
    correction.feature =
        named(kCorrectedFeatures, corrected_feature_code, said.value("feature", "surface"), "feature");
  }
  correction.validate();
  line.correction = correction;
  return line;
}

}  // namespace

void Correction::validate() const {
  const OptionCheck demand("correction");
  if (!from.allFinite() || !to.allFinite() || !place_in_ct.allFinite())
    throw InputError("correction", "a coordinate", "is not a finite number", "Give pixels of the picture");
  constexpr double kMostPixels = 1e5;
  if (from.cwiseAbs().maxCoeff() > kMostPixels || to.cwiseAbs().maxCoeff() > kMostPixels)
    throw InputError("correction", "a coordinate", "lies outside the image", "Give pixels of the picture");
  if (place_in_ct.cwiseAbs().maxCoeff() > kPatientRange)
    throw InputError("correction", "place_mm", "is nowhere near a patient", "Give points of the CT's frame");
  demand(sigma_px > 0.0, "sigma_px", sigma_px, "Give a positive number of pixels");
}

std::string correction_line(const CorrectionMade& made) {
  const Correction& one = made.correction;
  const Eigen::Vector3d place = 1e3 * one.place_in_ct;
  return json{{"frame", made.frame},
              {"seconds", made.seconds},
              {kKey,
               {{"feature", corrected_feature_code(one.feature)},
                {"place_mm", {place.x(), place.y(), place.z()}},
                {"view", stereo_view_code(one.view)},
                {"from", {one.from.x(), one.from.y()}},
                {"to", {one.to.x(), one.to.y()}},
                {"sigma_px", one.sigma_px},
                {"moved_mean_mm", 1e3 * made.moved}}}}
      .dump();
}

std::string undone_line(int frame, double seconds) {
  return json{{"frame", frame}, {"seconds", seconds}, {kKey, kUndo}}.dump();
}

std::vector<CorrectionLine> read_corrections(const std::filesystem::path& path) {
  std::vector<CorrectionLine> lines;
  for_each_json_line(path, "Give lines as 'glisson track --correct' writes them into frames.jsonl",
                     [&lines](const json& object) {
                       if (object.contains(kKey)) lines.push_back(line_of(object));
                     });
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& a, const auto& b) { return a.frame < b.frame; });
  return lines;
}

}  // namespace glisson
