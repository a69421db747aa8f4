// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/source.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/image.h"
#include "same_value.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder&) {
  const DicomSource& source = *state[part::source];
  return {{"patient", source.patient},
          {"patient_id", source.patient_id},
          {"birth_date", source.birth_date},
          {"study_uid", source.study_uid},
          {"series_uid", source.series_uid},
          {"frame_of_reference_uid", source.frame_of_reference_uid},
          {"slice_class_uid", source.slice_class_uid},
          {"slice_uids", source.slice_uids}};
}

void load(CaseState& state, const json& entry, const CaseFolder&) {
  DicomSource source;
  for (const auto& [key, text] : {std::pair{"patient", &source.patient},
                                  {"patient_id", &source.patient_id},
                                  {"birth_date", &source.birth_date},
                                  {"study_uid", &source.study_uid},
                                  {"series_uid", &source.series_uid},
                                  {"frame_of_reference_uid", &source.frame_of_reference_uid},
                                  {"slice_class_uid", &source.slice_class_uid}})
    *text = entry.at(key).get<std::string>();
  source.slice_uids = entry.at("slice_uids").get<std::vector<std::string>>();
  state[part::source] = std::make_shared<const DicomSource>(std::move(source));
}

}  // namespace

const PartOf<DicomSource> part::source{{.code = "source",
                                        .made_of = {part::image},
                                        .remedy = "Import a CT from its DICOM folder first",
                                        .save = save,
                                        .load = load,
                                        .same = same_value(part::source),
                                        .stands_alone = true,
                                        .is_input = false}};

}  // namespace glisson::engine
