// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_patients.h"

#include "glisson/experiments/synthetic_model.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/io.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

using Kind = ProofPatient::Kind;

Cancellable<ProofModel> synthetic(int seed, const RunContext& context) {
  auto synthetic = synthetic_model(static_cast<std::uint64_t>(seed), context);
  if (!synthetic) return std::nullopt;
  ProofModel made;
  made.model = std::move(synthetic->model);
  made.shown.surfaces = std::move(synthetic->patient.surfaces);
  made.shown.landmarks = std::move(synthetic->patient.landmarks);
  return made;
}

/// The files' headers claim that left is right: see the data's README.
LabelFile turned_right(LabelFile file) {
  VolumeGrid grid = file.voxels.grid();
  grid.direction = Eigen::Vector3d(1.0, -1.0, 1.0).asDiagonal();
  file.voxels = LabelVolume(grid, file.voxels.dense());
  return file;
}

Cancellable<ProofModel> from_labels(const fs::path& path, const RunContext& context) {
  const LabelCodes codes = {
      {6, structure::kParenchyma}, {9, structure::kVenaCava}, {10, structure::kPortalVein}};
  const LabelMap labels = recode(turned_right(read_labels(path)), codes, path.string());
  auto built = model::build_from_labels(labels, {}, context);
  if (!built) return std::nullopt;
  return ProofModel{built->model, built->model};
}

Cancellable<ProofModel> from_surfaces(const fs::path& path, const RunContext& context) {
  auto built = model::build_from_surfaces(model::read_surfaces(path, LengthUnit::millimetre), {}, context);
  if (!built) return std::nullopt;
  return ProofModel{built->model, built->model};
}

}  // namespace

const std::vector<ProofPatient>& proof_patients() {
  using enum ProofSet;
  static const std::vector<ProofPatient> kPatients = {
      {"synthetic_101", development, Kind::synthetic, 101, ""},
      {"synthetic_102", development, Kind::synthetic, 102, ""},
      {"liver_models", development, Kind::surfaces, 0, "liver_models"},
      {"labels_0002", development, Kind::labels, 2, "liver_labelmaps/0002.nii.gz"},
      {"labels_0006", development, Kind::labels, 6, "liver_labelmaps/0006.nii.gz"},
      {"synthetic_7", validation, Kind::synthetic, 7, ""},
      {"synthetic_8", validation, Kind::synthetic, 8, ""},
      {"liver_ply", validation, Kind::surfaces, 0, "liver_models/liver.ply"},
      {"labels_0001", validation, Kind::labels, 1, "liver_labelmaps/0001.nii.gz"},
      {"labels_0005", validation, Kind::labels, 5, "liver_labelmaps/0005.nii.gz"},
  };
  return kPatients;
}

Cancellable<ProofModel> load(const ProofPatient& patient, const fs::path& data, const RunContext& context) {
  switch (patient.kind) {
    case Kind::synthetic:
      return synthetic(patient.number, context);
    case Kind::labels:
      return from_labels(data / patient.path, context);
    case Kind::surfaces:
      break;
  }
  return from_surfaces(data / patient.path, context);
}

}  // namespace glisson::experiments
