// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/atlas_livers.h"

#include <algorithm>

#include "glisson/atlas/transfer.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/liver_population.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/io.h"
#include "readings.h"

namespace glisson::experiments {
namespace {
namespace fs = std::filesystem;

constexpr double kMemberSpacingMm = 2.5, kTemplateSpacingMm = 7.0;
constexpr std::uint64_t kTemplateSeed = 5000;
constexpr double kSliver = 0.0015;  // metres: closer vertices of the template are one
constexpr int kSmoothing = 20;

/// Vertices drift to the middle of their neighbours along the surface.
TriangleMesh evened(TriangleMesh mesh, const TriangleMesh& surface) {
  const auto neighbours = vertex_neighbours(mesh);
  const ClosestPointTree tree(surface);
  for (int pass = 0; pass < kSmoothing; ++pass) {
    const Points before = mesh.vertices;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (const int other : neighbours[static_cast<std::size_t>(v)]) middle += before.row(other);
      middle /= static_cast<double>(neighbours[static_cast<std::size_t>(v)].size());
      const Eigen::Vector3d wanted = (0.5 * (before.row(v) + middle)).transpose();
      mesh.vertices.row(v) = tree.closest(wanted).point.transpose();
    }
  }
  return mesh;
}

}  // namespace

atlas::Member synthetic_member(std::uint64_t seed) {
  using atlas::Structure;
  insilico::PopulationLiver liver = insilico::population_liver(seed, kMemberSpacingMm);
  return {"synthetic_" + std::to_string(seed),
          std::move(liver.surface),
          {{Structure::umbilical_notch, std::move(liver.umbilical_notch)},
           {Structure::falciform_line, std::move(liver.falciform_line)},
           {Structure::anterior_margin, std::move(liver.anterior_margin)},
           {Structure::vena_cava, std::move(liver.vena_cava)},
           {Structure::portal_entrance, std::move(liver.portal_entrance)},
           {Structure::gallbladder_bed, std::move(liver.gallbladder_bed)}}};
}

TriangleMesh synthetic_template() {
  const TriangleMesh fine = insilico::population_liver(kTemplateSeed, kMemberSpacingMm).surface;
  const TriangleMesh coarse = insilico::population_liver(kTemplateSeed, kTemplateSpacingMm).surface;
  return evened(merge_vertices(coarse, kSliver), fine);
}

std::vector<std::string> label_map_names(const fs::path& data) {
  std::vector<std::string> names;
  const fs::path folder = data / "liver_labelmaps";
  if (!fs::is_directory(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string file = entry.path().filename().string(); file.ends_with(".nii.gz"))
      names.push_back(file.substr(0, file.size() - 7));
  std::sort(names.begin(), names.end());
  return names;
}

bool is_for_development(const std::string& label_map) { return (label_map.back() - '0') % 2 == 0; }

Cancellable<LabelMapLiver> label_map_liver(const fs::path& data, const std::string& name,
                                           const RunContext& context) {
  const LabelFile file = read_labels(data / "liver_labelmaps" / (name + ".nii.gz"));
  VolumeGrid grid = file.voxels.grid();
  grid.direction = Eigen::Vector3d(1, -1, 1).asDiagonal();
  const LabelCodes codes = {{4, structure::kGallbladder},
                            {6, structure::kParenchyma},
                            {9, structure::kVenaCava},
                            {10, structure::kPortalVein}};
  const LabelMap labels = recode({LabelVolume(grid, file.voxels.dense()), file.infos}, codes, name);
  model::ModelOptions options;
  options.mesh.target_vertices = 150;  // only the fine surfaces and the trees are wanted
  const auto built = model::build_from_labels(labels, options, context);
  if (!built) return {};
  return LabelMapLiver{atlas::member_of(name, built->model, {}),
                       atlas::evidence_of(built->model).portal_vein};
}

Cancellable<std::vector<atlas::Member>> read_livers(const fs::path& data, const fs::path& readings,
                                                    const RunContext& context) {
  std::vector<atlas::Member> livers;
  for (const auto& [name, all] : read_readings(readings)) {
    if (!is_for_development(name)) continue;
    auto liver = label_map_member(data, name, context.quiet());
    if (!liver) return {};
    livers.push_back({name, std::move(liver->liver), truth_of(all)});
  }
  return livers;
}

Cancellable<atlas::Member> label_map_member(const fs::path& data, const std::string& name,
                                            const RunContext& context) {
  auto liver = label_map_liver(data, name, context);
  if (!liver) return {};
  return std::move(liver->member);
}

}  // namespace glisson::experiments
