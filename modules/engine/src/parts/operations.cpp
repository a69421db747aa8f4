// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/operations.h"

#include <nlohmann/json.hpp>
#include <type_traits>

#include "case_files.h"
#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/label_map.h"
#include "ranged.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr const char* kFile = "operations.vtu";
constexpr const char* kModes = "modes_m";  // N x 3 K: x, y, z of the first mode, of the second, ...

/// Every number of the options by its name in case.json, with its bounds there.
template <class Options, class Visit>
void each_option(Options& options, const Visit& visit) {
  visit("operations", options.operations, 40.0, 1e5);
  visit("modes", options.modes, 1.0, 1e4);
  visit("gravity", options.gravity, 0.0, 20.0);
  visit("gas_pa", options.gas_pa, 0.0, 4000.0);
  visit("bed_m", options.bed_m, 0.0, 0.1);
  visit("ligament_m", options.ligament_m, 0.0, 0.1);
  visit("contact_spread", options.contact_spread, 0.0, 2.0);
  visit("unforeseen_m", options.unforeseen_m, 0.0, 0.05);
}

/// @return rows of a mode, one a node, and back: both are 3 N numbers a mode, node after node.
Eigen::MatrixXd by_node(const fem::NodalColumns& modes) {
  Eigen::MatrixXd rows(modes.rows() / 3, 3 * modes.cols());
  for (Eigen::Index k = 0; k < modes.cols(); ++k)
    rows.middleCols<3>(3 * k) = modes.col(k).reshaped<Eigen::RowMajor>(rows.rows(), 3);
  return rows;
}

fem::NodalColumns by_mode(const Eigen::MatrixXd& rows) {
  fem::NodalColumns modes(3 * rows.rows(), rows.cols() / 3);
  for (Eigen::Index k = 0; k < modes.cols(); ++k)
    modes.col(k) = rows.middleCols<3>(3 * k).reshaped<Eigen::RowMajor>();
  return modes;
}

json lesions_of(const registration::OperationOptions& options) {
  json lesions = json::object();
  for (const auto& [label, modulus] : options.lesions) lesions[structure_name(label)] = modulus;
  return lesions;
}

/// Cases of before say nothing of stiffness: all was healthy parenchyma.
void read_stiffness(registration::OperationOptions& options, const json& entry, const CaseFolder& folder) {
  if (entry.contains("young_modulus"))
    options.young_modulus = ranged<double>(folder.path, entry, "young_modulus", 1.0, 1e9);
  if (entry.contains("poisson_ratio"))
    options.poisson_ratio = ranged<double>(folder.path, entry, "poisson_ratio", 0.0, 0.4999);
  if (!entry.contains("lesions")) return;
  const json& lesions = entry.at("lesions");
  for (const auto& [name, modulus] : lesions.items()) {
    const auto label = structure_named(name);
    if (!label)
      throw InputError((folder.path / kCaseFile).string(), "operations, lesions, " + name,
                       "names what is no lesion", "Restore the case from a copy");
    options.lesions[*label] = ranged<double>(folder.path, lesions, name.c_str(), 1.0, 1e9);
  }
}

json save(const CaseState& state, const CaseFolder& folder) {
  const SimulatedOperations& known = *state[part::operations];
  TetFile file;
  file.mesh = known.model->model.mesh;
  file.point_data[kModes] = by_node(known.prior->modes);
  write_tet_mesh(folder.path / kFile, file, LengthUnit::millimetre);
  json entry{{"seed", known.seed},
             {"simulated", known.prior->operations},
             {"motion_mean_mm", 1e3 * known.prior->mean_motion},
             {"young_modulus", known.options.young_modulus},
             {"poisson_ratio", known.options.poisson_ratio},
             {"lesions", lesions_of(known.options)}};
  each_option(known.options,
              [&](const char* name, const auto& value, double, double) { entry[name] = value; });
  return entry;
}

std::shared_ptr<const SimulatedOperations> read(const CaseState& state, const json& entry,
                                                const CaseFolder& folder) {
  const auto path = folder.path / kFile;
  auto known = std::make_shared<SimulatedOperations>();
  known->model = state[part::model];
  known->landmarks = state[part::landmarks];
  if (!known->model)
    throw InputError((folder.path / kCaseFile).string(), "operations",
                     "there is no model that they belong to", "Restore the case from a copy");
  each_option(known->options, [&](const char* name, auto& value, double least, double most) {
    value = ranged<std::remove_reference_t<decltype(value)>>(folder.path, entry, name, least, most);
  });
  read_stiffness(known->options, entry, folder);
  known->seed = ranged<std::uint64_t>(folder.path, entry, "seed", 0.0, 1.8e19);
  TetFile file = read_tet_file(path, LengthUnit::millimetre);
  const Eigen::MatrixXd& rows = file.point_data[kModes];
  const TetMesh& mesh = known->model->model.mesh;
  if (!same_points(file.mesh.vertices, mesh.vertices) || rows.rows() != mesh.vertex_count() ||
      rows.cols() == 0 || rows.cols() % 3 != 0 || !rows.allFinite())
    throw InputError(path.string(), kModes, "does not belong to this case's model",
                     "Remove the file: operations are simulated anew");
  auto prior = std::make_shared<registration::OperationPrior>();
  prior->modes = by_mode(rows);
  prior->operations = ranged<int>(folder.path, entry, "simulated", 1.0, 1e5);
  prior->mean_motion = 1e-3 * ranged<double>(folder.path, entry, "motion_mean_mm", 0.0, 1e3);
  known->prior = std::move(prior);
  return known;
}

bool same(const CaseState& written, const CaseState& read) {
  return read[part::operations]->prior->modes == written[part::operations]->prior->modes &&
         read[part::operations]->options == written[part::operations]->options;
}

}  // namespace

const PartOf<SimulatedOperations> part::operations{
    {.code = "operations",
     .made_of = {part::model, part::landmarks, part::tissue},
     .remedy = "Simulate operations first",
     .files = {kFile},
     .save = save,
     .load =
         [](CaseState& state, const json& entry, const CaseFolder& folder) {
           or_lost(folder, "case.operations_lost",
                   [&] { state[part::operations] = read(state, entry, folder); });
         },
     .same = same,
     .is_savable = has_operations,
     .stands_alone = true,
     .is_input = false}};

bool has_operations(const CaseState& state) {
  const auto& known = state[part::operations];
  return known && known->model == state[part::model] && known->landmarks == state[part::landmarks] &&
         known->options == with_tissue_of(state, known->options);
}

registration::OperationOptions with_tissue_of(const CaseState& state,
                                              registration::OperationOptions options) {
  registration::RegisterOptions said;
  said.tissue = tissue_of(state);
  const registration::OperationOptions plain;
  options.young_modulus = plain.young_modulus;
  options.poisson_ratio = plain.poisson_ratio;
  options.lesions = plain.lesions;
  said.operation = std::move(options);
  return registration::operation_of(said, state[part::model]->model);
}

registration::KnownOperations known_operations(const CaseState& state, std::uint64_t seed) {
  if (!has_operations(state) || state[part::operations]->seed != seed) return {};
  return {state[part::operations]->options, state[part::operations]->prior};
}

void keep_operations(CaseState& state, const registration::OperationOptions& options, std::uint64_t seed,
                     std::shared_ptr<const registration::OperationPrior> prior) {
  state[part::operations] = std::make_shared<const SimulatedOperations>(
      SimulatedOperations{state[part::model], state[part::landmarks], options, seed, std::move(prior)});
}

}  // namespace glisson::engine
