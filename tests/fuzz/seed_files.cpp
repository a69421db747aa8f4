// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <map>

#include "a_moment.h"
#include "case_files.h"
#include "entries.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/correction.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/volume/io.h"
#include "message_bytes.h"
#include "moment_files.h"
#include "onnx_bytes.h"
#include "phantom.h"
#include "shapes.h"
#include "tar_bytes.h"
#include "zip_bytes.h"

namespace glisson::fuzz {
namespace fs = std::filesystem;
namespace {

using Files = std::vector<std::string>;
constexpr LengthUnit kUnit = LengthUnit::millimetre;

/// What a writer of ours leaves under that name.
std::string written(const char* name, const std::function<void(const fs::path&)>& write) {
  const TemporaryFolder folder;
  write(folder.path() / name);
  return read_file(folder.path() / name);
}

TetFile tetrahedra() {
  TetFile file;
  file.mesh.vertices.resize(5, 3);
  file.mesh.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0.1, 0.1, 0.12;
  file.mesh.tetrahedra.resize(2, 4);
  file.mesh.tetrahedra << 0, 1, 2, 3, 1, 2, 3, 4;
  file.mesh.labels = {1, 16};
  file.point_data["displacement_mm"] = Eigen::MatrixXd::Ones(5, 3);
  file.field_data["cloud_from_model"] = Eigen::MatrixXd::Identity(4, 4);
  return file;
}

std::string tet_file(const char* name) {
  return written(name, [](const fs::path& path) { write_tet_mesh(path, tetrahedra(), kUnit); });
}
std::string surface(const char* name) {
  return written(name, [](const fs::path& path) {
    write_triangle_mesh(path, test::box({0.1, 0.1, 0.1}), kUnit);
  });
}
std::string image(const char* name) {
  return written(name, [](const fs::path& path) { write_image(path, test::stored_world(11)); });
}

std::string calibration_file() {
  return written("a.yaml", [](const fs::path& path) {
    StereoRig rig;
    for (Camera* camera : {&rig.left, &rig.right}) {
      camera->width = 640;
      camera->height = 480;
      camera->matrix << 600, 0, 320, 0, 600, 240, 0, 0, 1;
    }
    rig.right_from_left.translation = {-0.005, 0, 0};
    stereo::write_calibration(path, rig);
  });
}

std::string vessel_file() {
  return written("a.vtp", [](const fs::path& path) {
    VesselTree tree;
    tree.structure = 2;
    tree.nodes.resize(3, 3);
    tree.nodes << 0, 0, 0, 0.01, 0, 0, 0.02, 0, 0;
    tree.radii = {0.003, 0.002, 0.001};
    tree.beams = {{0, 1}, {1, 2}};
    tree.root = 0;
    engine::write_vessels(path, {tree, tree});
  });
}

std::string picture_file(const char* name, int channels) {
  return written(name, [&](const fs::path& path) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(24 * 16 * channels));
    for (std::size_t n = 0; n < bytes.size(); ++n) bytes[n] = static_cast<std::uint8_t>(n * 37 % 251);
    stereo::write_picture(path, {24, 16, channels, std::make_shared<const std::vector<std::uint8_t>>(bytes)});
  });
}

/// Eight frames, side by side.
std::string film_file() {
  return written("a.mkv", [](const fs::path& path) {
    stereo::VideoWriter writer(path, 64, 32, 25.0);
    for (int frame = 0; frame < 8; ++frame) {
      std::vector<std::uint8_t> bytes(64 * 32 * 3);
      for (std::size_t n = 0; n < bytes.size(); ++n)
        bytes[n] = static_cast<std::uint8_t>((n / 7 + 9 * static_cast<std::size_t>(frame)) % 200);
      writer.write({64, 32, 3, std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))});
    }
    writer.close();
  });
}

const std::string kMsh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 100 100 100 1 16 "
    "0\n$EndEntities\n$Nodes\n1 4 1 "
    "4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n100 0 0\n0 100 0\n0 0 100\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 "
    "3 4\n"
    "$EndElements\n";
const std::string kMsh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 100 0 0\n5 0 100 0\n7 0 0 "
    "100\n$EndNodes\n$Elements\n2\n1 "
    "15 2 0 1 1\n3 4 2 1 1 1 2 5 7\n$EndElements\n";
const std::string kCase =
    R"({"format": "glisson-case", "version": 1, "parts": {"model": {"revision": 2, "made_from": {"labels": 1}, )"
    R"("surfaces": [], "notes": ["a"], "quality": {"vertices": 4, "tetrahedra": 1, "min_dihedral_deg": 50, )"
    R"("max_dihedral_deg": 90, "volume_error": 0, "vertices_to_fine_mean_mm": 0, "mesh_to_fine_mean_mm": 0, )"
    R"("fine_to_mesh_mean_mm": 0, "fine_to_mesh_max_mm": 0}}, "video": {"revision": 1, "made_from": {}, )"
    R"("left": "../film.mkv", "right": ""}}})";
const std::string kLoad =
    R"({"gravity": {"from": "supine", "to": "left_flank"}, "pressure": {"pascal": 1600, "triangles": [0, 1]}, )"
    R"("forces": [{"point_mm": [1, 2, 3], "newton": [0, 0, 0.5]}, {"region": {"centre_mm": [0, 0, 0], )"
    R"("radius_mm": 20}, "newton": [0, 1, 0]}], "springs": [{"node": 3, "newton_per_metre": 50, )"
    R"("target_mm": [1, 1, 1]}], "fixed": {"nodes": [0, 1, 2]}, "moved": [{"nodes": [4], "by_mm": [1, 0, 0]}], )"
    R"("ramp_s": 0.5})";
const std::string kFrames =
    R"({"frame": 0, "seconds": 0.04, "doubtful": false, "level": "valid", "reason": "valid", "mesh": null, )"
    R"("points": {"left": 90, "right": 80, "pairs": 70}, "follow_ms": 20, )"
    R"("nodes": [[0, 0, 100], [10, 0, 100], [0, 10, 100], [0, 0, 110]], "unit": "mm", "residual_mm": 1, )"
    R"("camera_from_model": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 100], [0, 0, 0, 1]], "lesions": []})"
    "\n"
    R"({"complete": true, "frames": 1})"
    "\n";
const std::string kAtlas =
    R"({"format": "glisson-atlas", "version": 1, "name": "a", "usual": 1, "log_size": -2, )"
    R"("log_size_deviation": 0.1, "members": [{"name": "m", "weight": 1, "size_mm": 150, "unusual": 1, )"
    R"("mean_distance_mm": 3}], "structures": [], "variances_mm2": [4, 2], "total_variance_mm2": 7, )"
    R"("vertices": 4, "triangles": 4})";
const std::string kCloud =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nproperty "
    "uchar "
    "feature\nend_header\n1 2 30 0\n2 2 31 1\n";

const std::map<std::string, std::function<Files()>>& makers() {
  static const std::map<std::string, std::function<Files()>> all = {
      {"vtk_xml",
       [] {
         return Files{tet_file("a.vtu"), surface("a.vtp")};
       }},
      {"legacy_vtk",
       [] {
         return Files{tet_file("a.vtk"), surface("a.vtk")};
       }},
      {"msh",
       [] {
         return Files{kMsh, kMsh2};
       }},
      {"ply", [] { return Files{surface("a.ply")}; }},
      {"stl", [] { return Files{surface("a.stl")}; }},
      {"obj", [] { return Files{surface("a.obj")}; }},
      {"node_list",
       [] {
         return Files{"# nodes\n1 2 3\n4 5 6\n", "0 1 2 17\n"};
       }},
      {"nifti_header", [] { return Files{image("a.nii")}; }},
      {"nrrd_header", [] { return Files{image("a.nrrd")}; }},
      {"meta_header", [] { return Files{image("a.mha")}; }},
      {"archive",
       [] {
         return Files{test::tar_entry("a/b", "content") + test::tar_entry("c", "", '2', "a") +
                      test::tar_entry("././@PaxHeader", "17 path=long/name\n", 'x') +
                      test::tar_entry("d", "x") + test::tar_end()};
       }},
      {"zip_archive",
       [] {
         return Files{test::zip_of({{"a/", ""},
                                    {"a/b", std::string(300, 'x'), true},
                                    {"c", "a", false, false, false, 0, 0, 0120777},
                                    {"d", "content", false, true}})};
       }},
      {"onnx_input",
       [] {
         return Files{test::OnnxNetwork({1, 1, 16, 16}).conv(2, 1, 1, {-1.0F, 1.0F}, {1.0F, 0.0F}).bytes(),
                      test::OnnxNetwork({1, 1, 8, 8, 8}).conv(2, 1, 1, {-1.0F, 1.0F}, {1.0F, 0.0F}).bytes()};
       }},
      {"label_sheet",
       [] {
         return Files{R"({"window_hu": [-100, 300], "mean_hu": 80, "sd_hu": 40, "spacing_mm": [3, 1, 1], )"
                      R"("axes": "IPL", "tile": [32, 64, 64], "overlap": 0.25, )"
                      R"("channels": ["background", "parenchyma", "lesions"], "least_lesion_ml": 0.1})"};
       }},
      {"mask_sheet",
       [] {
         return Files{
             R"({"colours": "rgb", "mean": [0.5, 0.4, 0.3], "sd": [0.2, 0.2, 0.2], "size": [64, 96], )"
             R"("channels": ["background", "liver", "tool"], "liver": ["liver"], "threshold": 0.5, )"
             R"("oldest_seconds": 0.4})"};
       }},
      {"messages", [] { return Files{test::image_bytes() + test::transform_bytes()}; }},
      {"picture_header",
       [] {
         return Files{picture_file("a.png", 3), picture_file("a.jpg", 3), picture_file("a.bmp", 1)};
       }},
      {"cloud", [] { return Files{kCloud}; }},
      {"label_codes", [] { return Files{R"({"1": "parenchyma", "2": "portal_vein"})"}; }},
      {"seeds", [] { return Files{R"({"liver": [[1, 2, 3]], "lesions": [[[4, 5, 6]]]})"}; }},
      {"edits", [] { return Files{R"({"edits": [{"tool": "island_keep", "label": 1, "at": [1, 2, 3]}]})"}; }},
      {"tree_edits",
       [] {
         return Files{
             R"({"frame": "LPS", "unit": "mm", "edits": [{"edit": "join", "at": [1, 2, 3], "to": [0, 0, 0]}]})"};
       }},
      {"regions",
       [] {
         return Files{
             R"({"image": "left", "frame": 3, "regions": [{"label": "surface", "polygon": [[0, 0], [9, 0], [9, 9]]}, )"
             R"({"label": "anterior_margin", "curve": [[0, 0], [9, 9]], "half_width_px": 5, "image": "right"}]})"};
       }},
      {"source",
       [] {
         return Files{
             R"({"left": "scope.mkv", "layout": "top_bottom", "deinterlace": true, "crop": [0, 4, 0, 532]})"};
       }},
      {"calibration", [] { return Files{calibration_file()}; }},
      {"load", [] { return Files{kLoad}; }},
      {"overlay_record", [] { return Files{kFrames}; }},
      {"corrections",
       [] {
         CorrectionMade made;
         made.frame = 3;
         made.seconds = 0.1;
         return Files{correction_line(made) + "\n" + undone_line(7, 0.2) + "\n"};
       }},
      {"start", [] { return Files{"1 0 0 10\n0 1 0 -20\n0 0 1 120\n0 0 0 1\n"}; }},
      {"surface_list",
       [] {
         return Files{
             R"({"unit": "mm", "structures": {"liver": "liver.stl", "lesions": [{"file": "a.ply", "unit": "m"}]}})"};
       }},
      {"atlas_sheet", [] { return Files{kAtlas}; }},
      {"picture",
       [] {
         return Files{picture_file("a.png", 3), picture_file("a.jpg", 3), picture_file("a.bmp", 1)};
       }},
      {"video", [] { return Files{film_file()}; }},
      {"landmarks",
       [] { return Files{R"({"frame": "LPS", "unit": "mm", "anterior_margin": [[1, 2, 3], [4, 5, 6]]})"}; }},
      {"vessels", [] { return Files{vessel_file()}; }},
      {"moment",
       [] {
         return Files{written("case", [](const fs::path& path) {
           engine::write_moment(path.parent_path(), path.parent_path(), a_moment());
           fs::rename(path.parent_path() / "moments/0001.json", path);
         })};
       }},
      {"case_json", [] { return Files{kCase}; }}};
  return all;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> seed_files(const std::string& entry) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& bytes : makers().at(entry)())
    files.emplace_back("seed_" + std::to_string(files.size()), bytes);
  return files;
}

}  // namespace glisson::fuzz
