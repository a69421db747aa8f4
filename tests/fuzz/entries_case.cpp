// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "a_moment.h"
#include "case_files.h"
#include "entries.h"
#include "glisson/core/json_file.h"
#include "glisson/editing/edit.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/model.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/tree_edits.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/segmentation/segment.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/regions.h"
#include "glisson/stereo/source.h"
#include "moment_files.h"
#include "scratch.h"

namespace glisson::fuzz {
namespace fs = std::filesystem;

engine::KeptMoment a_moment() {
  engine::KeptMoment moment;
  moment.number = 1;
  moment.title = "Segment 6";
  moment.kept_at = "2026-01-31T10:20:30Z";
  moment.left_png = moment.right_png = std::make_shared<const std::string>("PNG");
  moment.margin = Points::Constant(2, 3, 0.01);
  moment.chosen = *structure_named("lesion_1");
  moment.measures = guidance::LesionMeasures{};
  moment.measures->shortest = 0.012;
  moment.place = guidance::SurfacePlace{3, {0.25, 0.25, 0.5}};
  return moment;
}

void cloud(std::string_view bytes) {
  read_file_of("a.ply", bytes, [](const fs::path& path) {
    must(read_cloud(path).points.allFinite(), "a point is not finite");
  });
}
void label_codes(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) { (void)read_label_codes(path); });
}
void seeds(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) {
    must(segmentation::read_seeds(path).liver.allFinite(), "a seed is not finite");
  });
}
void edits(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) { (void)editing::read_edits(path); });
}
void tree_edits(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) { (void)model::read_tree_edits(path); });
}
void regions(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) {
    for (const stereo::Region& region : stereo::read_regions(path).regions)
      for (const Eigen::Vector2d& p : region.polygon)
        must(p.cwiseAbs().maxCoeff() < 1e6, "a vertex lies nowhere");
  });
}
void source(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) { (void)stereo::read_source(path); });
}
void calibration(std::string_view bytes) {
  read_file_of("a.yaml", bytes, [](const fs::path& path) {
    must(stereo::read_calibration(path).left.matrix.allFinite(), "a camera is not finite");
  });
}
void picture(std::string_view bytes) {
  static stereo::PictureReader reader;
  read_file_of("a.png", bytes, [](const fs::path& path) { must(!reader.read(path).empty(), "is empty"); });
}
void video(std::string_view bytes) {
  read_file_of("a.mkv", bytes, [](const fs::path& path) {
    stereo::SourceOptions options;
    options.left = path.string();
    stereo::StereoVideo video(options);  // by its path it would be remembered
    int frames = 0;
    for (StereoFrame frame; frames < 5 && video.read(frame); ++frames)
      must(frame.left.width == video.width() && frame.right.height == video.height(),
           "a frame of another size");
  });
}
void landmarks(std::string_view bytes) {
  read_file_of("a.json", bytes, [](const fs::path& path) {
    const Landmarks read = engine::read_landmarks(path);
    must(read.anterior_margin.allFinite() && read.umbilical_notch.allFinite(), "a landmark is not finite");
  });
}
void vessels(std::string_view bytes) {
  read_file_of("a.vtp", bytes, [](const fs::path& path) {
    for (const VesselTree& tree : engine::read_vessels(path)) {
      must(tree.nodes.allFinite(), "a node is not finite");
      must(static_cast<Eigen::Index>(tree.radii.size()) == tree.nodes.rows(), "radii do not fit");
      for (const auto& beam : tree.beams)
        for (const int end : beam) must(end >= 0 && end < tree.nodes.rows(), "a beam ends nowhere");
    }
  });
}

void moment(std::string_view bytes) {
  static const TemporaryFolder folder;
  static const bool is_made = [] {
    engine::write_moment(folder.path(), folder.path(), a_moment());
    return true;
  }();
  must(is_made, "there is no moment");
  std::ofstream(folder.path() / "moments/0001.json", std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    const engine::KeptMoment read = engine::read_moment(folder.path(), 1);
    must(read.number == 1, "is another moment");
    must(read.margin.allFinite(), "a margin is not finite");
    must(!read.place || (read.place->triangle >= 0 && read.place->weights.allFinite()),
         "a mark lies nowhere");
  } catch (const Error&) {
  }
}

void case_json(std::string_view bytes) {
  static const TemporaryFolder folder;
  static const fs::path path = [] {
    const fs::path made = folder.path() / "a.glisson";
    fs::create_directories(made / "model");
    TetMesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1;
    mesh.tetrahedra.resize(1, 4);
    mesh.tetrahedra << 0, 1, 2, 3;
    write_tet_mesh(made / "model/mesh.vtu", mesh, LengthUnit::millimetre);
    engine::write_vessels(made / "model/vessels.vtp", {});
    return made;
  }();
  std::ofstream(path / "case.json", std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    std::vector<std::string> lost;
    (void)engine::open_case(path, RunContext(), &lost);
  } catch (const Error&) {
  }
}

}  // namespace glisson::fuzz
