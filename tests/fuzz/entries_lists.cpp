// SPDX-License-Identifier: GPL-3.0-or-later
#include "entries.h"
#include "glisson/atlas/atlas.h"
#include "glisson/fem/loads_io.h"
#include "glisson/model/build.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/registration/registration_files.h"
#include "scratch.h"

namespace glisson::fuzz {
namespace fs = std::filesystem;

void load(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) {
    const fem::LoadCase read = fem::read_load_case(path);
    must(read.gravity_change.norm() < 1e3, "gravity of no planet");
    for (const auto& force : read.forces) must(force.force.norm() < 1e5, "a force of no hand");
  });
}
void overlay_record(std::string_view bytes) {
  read_file_of("a.jsonl", bytes, [](const fs::path& path) {
    for (const OverlayLine& line : read_overlay_record(path).frames)
      must(!line.camera_from_model || line.camera_from_model->allFinite(), "a pose is not finite");
  });
}
void corrections(std::string_view bytes) {
  read_file_of("a.jsonl", bytes, [](const fs::path& path) {
    for (const CorrectionLine& line : read_corrections(path))
      must(!line.correction || line.correction->to.allFinite(), "a correction leads nowhere");
  });
}
void start(std::string_view bytes) {
  read_file_of("a.txt", bytes, [](const fs::path& path) {
    must(registration::read_start(path, LengthUnit::millimetre).matrix().allFinite(), "a pose is not finite");
  });
}
void surface_list(std::string_view bytes) {
  read_file_of("a.json", bytes,
               [](const fs::path& path) { (void)model::read_surfaces(path, LengthUnit::millimetre); });
}
void atlas_sheet(std::string_view bytes) {
  read_file_of("atlas.json", bytes,
               [](const fs::path& path) { (void)atlas::read_atlas(path.parent_path()); });
}

}  // namespace glisson::fuzz
