// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/stopwatch.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::insilico {
namespace {

std::string numbered(const char* stem, int frame, const char* extension) {
  std::array<char, 64> name{};
  std::snprintf(name.data(), name.size(), "%s_%04d%s", stem, frame, extension);
  return name.data();
}

Picture side_by_side(const StereoFrame& frame) {
  const auto row = static_cast<std::size_t>(frame.left.width) * 3;
  const auto rows = static_cast<std::size_t>(frame.left.height);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(2 * row * rows);
  for (std::size_t y = 0; y < rows; ++y) {
    std::copy_n(frame.left.bytes->data() + y * row, row, bytes->data() + 2 * y * row);
    std::copy_n(frame.right.bytes->data() + y * row, row, bytes->data() + (2 * y + 1) * row);
  }
  return {2 * frame.left.width, frame.left.height, 3, std::move(bytes)};
}

nlohmann::json in_mm(const Eigen::Vector3d& p) { return {1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z()}; }

/// Where every lesion is in every frame, and what the theatre did.
nlohmann::json targets_document(const Theatre& theatre, const FilmOptions& options) {
  nlohmann::json targets = nlohmann::json::array();
  for (const Target& target : theatre.targets())
    targets.push_back({{"name", structure_name(target.structure)},
                       {"label", target.structure},
                       {"centre_in_ct_mm", in_mm(target.centre_in_ct)},
                       {"in_camera_mm", nlohmann::json::array()}});
  for (int frame = 0; frame < options.frames; ++frame) {
    const Points centres = theatre.truth(frame).targets_in_camera;
    for (std::size_t i = 0; i < targets.size(); ++i)
      targets[i]["in_camera_mm"].push_back(in_mm(centres.row(static_cast<Eigen::Index>(i)).transpose()));
  }
  const TheatreFigures& figures = theatre.figures();
  const Eigen::Matrix4d pose = theatre.camera_from_ct().matrix();
  nlohmann::json rows = nlohmann::json::array();
  for (int r = 0; r < 4; ++r)
    rows.push_back({pose(r, 0), pose(r, 1), pose(r, 2), r < 3 ? 1e3 * pose(r, 3) : 1.0});
  return {{"targets", targets},
          {"camera_from_ct_mm", rows},
          {"frames_per_second", theatre.options().frames_per_second},
          {"mean_displacement_mm", figures.mean_displacement_mm},
          {"elastic_motion_mm", figures.elastic_motion_mm},
          {"pressure_pa", figures.pressure_pa},
          {"breathing_mm", figures.breathing_mm},
          {"heartbeat_mm", figures.heartbeat_mm}};
}

void write_loss_free(const Theatre& theatre, const std::filesystem::path& folder, const StereoFrame& frame,
                     Film& made) {
  made.left_pictures.push_back(folder / numbered("left", frame.index, ".png"));
  made.right_pictures.push_back(folder / numbered("right", frame.index, ".png"));
  stereo::write_picture(made.left_pictures.back(), frame.left);
  stereo::write_picture(made.right_pictures.back(), frame.right);
  write_depth(made.truth / numbered("depth", frame.index, ".pfm"), theatre.depth(frame.index),
              theatre.options().width, theatre.options().height);
}

}  // namespace

void FilmOptions::validate(const Theatre& theatre) const {
  if (frames < 0 || frames > theatre.frame_count())
    throw InputError("film", "frames", std::to_string(frames) + " frames are wanted",
                     "give 0 to " + std::to_string(theatre.frame_count()));
  for (const int frame : picture_frames)
    if (frame < 0 || frame >= theatre.frame_count())
      throw InputError("film", "picture_frames", "there is no frame " + std::to_string(frame),
                       "give 0 to " + std::to_string(theatre.frame_count() - 1));
}

Cancellable<Film> film(const Theatre& theatre, const std::filesystem::path& folder, const FilmOptions& wanted,
                       const RunContext& context) {
  wanted.validate(theatre);
  FilmOptions options = wanted;
  if (options.frames == 0) options.frames = theatre.frame_count();
  const Stopwatch watch;
  Film made;
  made.video = folder / "stereo.mkv";
  made.calibration = folder / "calibration.yaml";
  made.truth = folder / "truth";
  std::error_code failure;
  std::filesystem::create_directories(made.truth, failure);
  if (failure) throw FileError("cannot make the folder " + made.truth.string() + ": " + failure.message());

  stereo::write_calibration(made.calibration, theatre.rig());
  write_tet_mesh(made.truth / "mesh.vtu", theatre.mesh(), LengthUnit::millimetre);
  write_json(made.truth / "targets.json", targets_document(theatre, options));
  made.visible_share = theatre.visible_share(0);

  const TheatreOptions& stage = theatre.options();
  std::optional<stereo::VideoWriter> video(std::in_place, made.video, 2 * stage.width, stage.height,
                                           stage.frames_per_second);
  std::vector<int> pictures = options.picture_frames;
  std::sort(pictures.begin(), pictures.end());
  const int last = std::max(options.frames, pictures.empty() ? 0 : pictures.back() + 1);
  for (int frame = 0; frame < last; ++frame) {
    if (context.cancelled()) return std::nullopt;  // the writer leaves no video behind
    const bool filmed = frame < options.frames;
    const bool picture = std::binary_search(pictures.begin(), pictures.end(), frame);
    if (!filmed && !picture) continue;
    context.progress(static_cast<double>(frame) / last, "theatre.film");
    const StereoFrame seen = theatre.render(frame);
    if (filmed) {
      video->write(side_by_side(seen));
      ++made.frames;
      if (options.node_truth)
        write_node_list(made.truth / numbered("nodes", frame, ".xyz"), theatre.truth(frame).nodes_in_camera,
                        LengthUnit::millimetre);
    }
    if (picture) write_loss_free(theatre, folder, seen, made);
  }
  video->close();
  made.seconds = watch.seconds();
  context.progress(1.0, "theatre.film");
  return made;
}

void write_depth(const std::filesystem::path& path, const std::vector<float>& depth, int width, int height) {
  static_assert(std::endian::native == std::endian::little, "a PFM of scale -1 is little-endian");
  require(depth.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
          "a depth map has one value a pixel");
  std::string content = "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
  const std::size_t header = content.size(), row = static_cast<std::size_t>(width);
  content.resize(header + depth.size() * sizeof(float));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t x = 0; x < row; ++x) {
      const float millimetres = 1e3F * depth[y * row + x];
      const std::size_t place = (static_cast<std::size_t>(height) - 1 - y) * row + x;
      std::memcpy(content.data() + header + place * sizeof(float), &millimetres, sizeof(float));
    }
  }
  write_file_atomically(path, content);
}

std::vector<float> read_depth(const std::filesystem::path& path, int& width, int& height) {
  const std::string content = read_file(path);
  std::istringstream stream(content);
  std::string magic;
  double scale = 0.0;
  width = height = 0;
  stream >> magic >> width >> height >> scale;
  stream.get();  // the one white space after the header
  if (!stream || magic != "Pf" || width <= 0 || height <= 0 || width > 16384 || height > 16384 ||
      scale >= 0.0)
    throw InputError(path.string(), "header", "this is not a little-endian grey PFM",
                     "give a depth map that the theatre wrote");
  const auto header = static_cast<std::size_t>(stream.tellg());
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (content.size() != header + count * sizeof(float))
    throw InputError(path.string(), "size",
                     "it holds " + std::to_string(content.size() - header) + " bytes for " +
                         std::to_string(count) + " pixels",
                     "copy the file again");
  std::vector<float> depth(count);
  const std::size_t row = static_cast<std::size_t>(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    for (std::size_t x = 0; x < row; ++x) {
      float millimetres = 0.0F;
      const std::size_t place = (static_cast<std::size_t>(height) - 1 - y) * row + x;
      std::memcpy(&millimetres, content.data() + header + place * sizeof(float), sizeof(float));
      depth[y * row + x] = 1e-3F * millimetres;
    }
  }
  return depth;
}

}  // namespace glisson::insilico
