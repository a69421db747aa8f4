// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_io.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <stdio.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "case_files.h"
#include "case_stereo.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/tree_edits.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr const char* kFormat = "glisson-case";
/// Coordinates go through millimetres in text or floats; a micrometre is lost to nobody.
constexpr double kTolerance = 1e-6;
constexpr LengthUnit kUnit = LengthUnit::millimetre;

// ---- model ----

json write_model(const fs::path& folder, const model::BuiltModel& built) {
  fs::create_directory(folder / "model");
  write_tet_mesh(folder / "model/mesh.vtu", built.model.mesh, kUnit);
  write_vessels(folder / "model/vessels.vtp", built.model.vessels);
  if (!built.tree_edits.empty()) {
    write_vessels(folder / "model/vessels_as_built.vtp", built.trees_as_built);
    model::write_tree_edits(folder / "model/tree_edits.json", built.tree_edits);
  }
  if (!built.model.landmarks.empty() || built.model.landmarks.vena_cava.rows() > 0)
    write_landmarks(folder / "model/landmarks.json", built.model.landmarks);
  json surfaces = json::array();
  for (std::size_t i = 0; i < built.model.surfaces.size(); ++i) {
    const NamedSurface& surface = built.model.surfaces[i];
    const std::string name = "model/surface_" + std::to_string(i) + ".vtp";
    write_triangle_mesh(folder / name, surface.mesh, kUnit);
    surfaces.push_back({{"file", name}, {"structure", surface.structure}, {"name", surface.name}});
  }
  const model::MeshQuality& q = built.report.quality;
  return {{"surfaces", surfaces},
          {"notes", built.report.notes},
          {"quality",
           {{"vertices", q.vertices},
            {"tetrahedra", q.tetrahedra},
            {"min_dihedral_deg", q.min_dihedral_deg},
            {"max_dihedral_deg", q.max_dihedral_deg},
            {"volume_error", q.volume_error},
            {"vertices_to_fine_mean_mm", q.vertices_to_fine_mean_mm},
            {"mesh_to_fine_mean_mm", q.mesh_to_fine_mean_mm},
            {"fine_to_mesh_mean_mm", q.fine_to_mesh_mean_mm},
            {"fine_to_mesh_max_mm", q.fine_to_mesh_max_mm}}}};
}

model::BuiltModel read_model(const fs::path& folder, const json& entry) {
  model::BuiltModel built;
  built.model.mesh = read_tet_mesh(folder / "model/mesh.vtu", kUnit);
  built.model.surface = boundary_surface(built.model.mesh);
  built.model.vessels = read_vessels(folder / "model/vessels.vtp");
  if (fs::exists(folder / "model/tree_edits.json")) {
    built.tree_edits = model::read_tree_edits(folder / "model/tree_edits.json");
    built.trees_as_built = read_vessels(folder / "model/vessels_as_built.vtp");
  }
  if (fs::exists(folder / "model/landmarks.json"))
    built.model.landmarks = read_landmarks(folder / "model/landmarks.json");
  for (const json& surface : entry.at("surfaces"))
    built.model.surfaces.push_back(
        {surface.at("structure").get<Label>(), surface.at("name").get<std::string>(),
         read_triangle_mesh(folder / surface.at("file").get<std::string>(), kUnit)});
  built.report.notes = entry.at("notes").get<std::vector<std::string>>();
  model::MeshQuality& q = built.report.quality;
  const json& sheet = entry.at("quality");
  q.vertices = sheet.at("vertices");
  q.tetrahedra = sheet.at("tetrahedra");
  q.min_dihedral_deg = sheet.at("min_dihedral_deg");
  q.max_dihedral_deg = sheet.at("max_dihedral_deg");
  q.volume_error = sheet.at("volume_error");
  q.vertices_to_fine_mean_mm = sheet.at("vertices_to_fine_mean_mm");
  q.mesh_to_fine_mean_mm = sheet.at("mesh_to_fine_mean_mm");
  q.fine_to_mesh_mean_mm = sheet.at("fine_to_mesh_mean_mm");
  q.fine_to_mesh_max_mm = sheet.at("fine_to_mesh_max_mm");
  return built;
}

// ---- registration ----

json registration_entry(const Registration& registration) {
  return {{"termination", static_cast<int>(registration.termination)},
          {"plateaus", registration.plateaus},
          {"steps", registration.steps},
          {"residual_mm", 1e3 * registration.residual},
          {"seen_share", registration.seen_share},
          {"doubts", registration.doubts}};
}

// ---- the case ----

/// Whether the registration is of the case's model: one of a former model has other nodes, is of no use any
/// more, and is not written.
bool is_of_its_model(const CaseState& state) {
  return state.registration && state.model &&
         state.registration->nodes_in_camera.rows() == state.model->model.mesh.vertex_count();
}

/// Writes the files of every part that there is into `folder`, for a case that will stand at `path`.
/// @return case.json, or nothing when cancelled.
std::optional<json> write_parts(const fs::path& folder, const fs::path& path, const CaseState& state,
                                const RunContext& context) {
  json parts = json::object();
  const auto write = [&](Part part, const std::function<json()>& files) {
    if (context.cancelled() || !state.has(part)) return;
    context.progress(0.8 * static_cast<double>(part) / kPartCount, "case.write");
    json entry = files();
    entry["revision"] = state.stamp(part).revision;
    json made_from = json::object();
    for (const auto& [input, revision] : state.stamp(part).made_from)
      made_from[std::string(part_code(input))] = revision;
    entry["made_from"] = made_from;
    parts[std::string(part_code(part))] = entry;
  };
  const auto file = [&](const auto& writer) {
    return [&writer] {
      writer();
      return json::object();
    };
  };
  write(Part::image, [&] {
    write_image(folder / "image.nrrd", *state.image);
    return json{{"modality", static_cast<int>(state.image->modality)},
                {"description", state.image->description}};
  });
  const auto seeds = [&] { segmentation::write_seeds(folder / "seeds.json", *state.seeds); };
  write(Part::seeds, file(seeds));
  write(Part::labels, [&] {
    write_labels(folder / "labels.seg.nrrd", state.labels->voxels, reviewed_infos(state));
    if (state.history && !state.history->steps().empty()) {
      fs::create_directory(folder / "history");
      editing::write_history(folder / "history", *state.history);
    }
    return json::object();
  });
  write(Part::review, [&] {
    json states = json::array();
    for (const auto& [label, review] : *state.review) states.push_back({label, slicer_status(review)});
    return json{{"states", states}};
  });
  write(Part::model, [&] { return write_model(folder, *state.model); });
  write(Part::check, [&] { return json{{"is_right", state.check->is_right}}; });
  const auto landmarks = [&] { write_landmarks(folder / "landmarks.json", *state.landmarks); };
  write(Part::landmarks, file(landmarks));
  const auto rig = [&] { stereo::write_calibration(folder / "calibration.yaml", *state.rig); };
  write(Part::rig, file(rig));
  // Videos are large: the case says where they lie, relative to itself where they lie beside it, so that both
  // can move.
  write(Part::video, [&] {
    const auto place = [&](const fs::path& video) {
      if (video.empty()) return std::string();
      if (stereo::is_device(video.string())) return video.string();
      const fs::path relative = fs::absolute(video).lexically_normal().lexically_relative(path);
      const bool beside = !relative.empty() && relative.begin() != relative.end() &&
                          std::next(relative.begin()) != relative.end() &&
                          *std::next(relative.begin()) != "..";
      return beside ? relative.string() : fs::absolute(video).lexically_normal().string();
    };
    return json{{"left", place(state.video->left)}, {"right", place(state.video->right)}};
  });
  write(Part::frame, [&] { return write_frame(folder, *state.frame); });
  const auto regions = [&] { stereo::write_regions(folder / "regions.json", *state.regions); };
  write(Part::regions, file(regions));
  write(Part::cloud, [&] {
    write_cloud(folder / "cloud.ply", *state.cloud, kUnit);
    if (state.points) write_points(folder, state, *state.points);
    return json{{"has_points", state.points != nullptr}};
  });
  if (is_of_its_model(state))
    write(Part::registration, [&] {
      write_registration(folder / "registration.vtu", state.model->model, *state.registration, kUnit);
      return registration_entry(*state.registration);
    });
  if (context.cancelled()) return {};
  return json{{"format", kFormat}, {"version", kCaseFormatVersion}, {"parts", parts}};
}

/// Reads what can be made again. @return false when it could not be read and that was told to `lost`.
bool or_lost(std::vector<std::string>* lost, const char* code, const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const Error& failure) {
    if (lost == nullptr) throw;
    lost->push_back(std::string(code) + ' ' + failure.what());
    return false;
  }
}

/// @param lost see open_case.
void read_part(CaseState& state, Part part, const json& entry, const fs::path& folder,
               const RunContext& context, std::vector<std::string>* lost) {
  switch (part) {
    case Part::image: {
      auto image = read_image(folder / "image.nrrd", context);
      if (!image) return;
      image->modality = static_cast<Modality>(entry.at("modality").get<int>());
      image->description = entry.at("description");
      state.image = std::make_shared<const Image>(std::move(*image));
      break;
    }
    case Part::seeds:
      state.seeds =
          std::make_shared<const segmentation::Seeds>(segmentation::read_seeds(folder / "seeds.json"));
      break;
    case Part::labels: {
      LabelFile file = read_labels(folder / "labels.seg.nrrd");
      state.labels =
          std::make_shared<const LabelMap>(LabelMap{std::move(file.voxels), std::move(file.infos)});
      if (fs::exists(folder / "history"))
        state.history = std::make_shared<const editing::History>(
            editing::read_history(folder / "history", state.labels->voxels));
      const bool measurable = state.image && state.image->grid.same_as(state.labels->voxels.grid());
      state.statistics = std::make_shared<const segmentation::LabelStatistics>(
          *state.labels, measurable ? state.image.get() : nullptr);
      break;
    }
    case Part::review: {
      Review review;
      for (const json& state_of_one : entry.at("states"))
        review[state_of_one.at(0).get<Label>()] = review_state(state_of_one.at(1).get<std::string>());
      state.review = std::make_shared<const Review>(std::move(review));
      break;
    }
    case Part::model:
      state.model = std::make_shared<const model::BuiltModel>(read_model(folder, entry));
      break;
    case Part::check:
      state.check = std::make_shared<const ModelCheck>(ModelCheck{entry.at("is_right").get<bool>()});
      break;
    case Part::landmarks:
      state.landmarks = std::make_shared<const Landmarks>(read_landmarks(folder / "landmarks.json"));
      break;
    case Part::rig:
      state.rig = std::make_shared<const StereoRig>(stereo::read_calibration(folder / "calibration.yaml"));
      break;
    case Part::video: {
      const auto place = [&](const char* side) {
        const fs::path video = entry.at(side).get<std::string>();
        return video.empty() || video.is_absolute() || stereo::is_device(video.string())
                   ? video
                   : (folder / video).lexically_normal();
      };
      state.video = std::make_shared<const VideoSource>(VideoSource{place("left"), place("right")});
      break;
    }
    case Part::frame:
      state.frame = std::make_shared<const StereoInput>(read_frame(folder, entry));
      break;
    case Part::regions:
      state.regions = std::make_shared<const stereo::Regions>(stereo::read_regions(folder / "regions.json"));
      break;
    case Part::cloud:
      if (!or_lost(lost, "case.cloud_lost", [&] {
            state.cloud = std::make_shared<const LabelledCloud>(read_cloud(folder / "cloud.ply", kUnit));
          }))
        break;
      if (!entry.value("has_points", false)) break;  // imported, or of a case of before
      or_lost(lost, "case.points_lost", [&] { state.points = read_points(folder, state); });
      break;
    case Part::registration: {
      if (!state.model)
        throw InputError((folder / "case.json").string(), "registration",
                         "there is no model that it belongs to", "Restore the case from a copy");
      Registration registration = read_registration(folder / "registration.vtu", state.model->model, kUnit);
      registration.termination = static_cast<Termination>(entry.at("termination").get<int>());
      registration.plateaus = entry.at("plateaus");
      registration.steps = entry.at("steps");
      registration.residual = 1e-3 * entry.at("residual_mm").get<double>();
      registration.seen_share = entry.value("seen_share", 0.0);  // cases of before have none
      registration.doubts = entry.at("doubts").get<std::vector<std::string>>();
      state.registration = std::make_shared<const Registration>(std::move(registration));
      break;
    }
    case Part::preview:
    case Part::live:
      break;
  }
}

Stamp read_stamp(const json& entry) {
  Stamp stamp;
  stamp.revision = entry.at("revision");
  for (int i = 0; i < kPartCount; ++i) {
    const std::string code(part_code(static_cast<Part>(i)));
    if (entry.at("made_from").contains(code))
      stamp.made_from[static_cast<Part>(i)] = entry["made_from"][code];
  }
  return stamp;
}

bool close(const Points& a, const Points& b) {
  return a.rows() == b.rows() && (a.rows() == 0 || (a - b).cwiseAbs().maxCoeff() < kTolerance);
}

/// Compares what was written with what was to be. @throws FileError.
void verify(const fs::path& folder, const CaseState& state) {
  const auto read = open_case(folder, RunContext());
  bool same = read.has_value();
  for (int i = 0; same && i < kPartCount; ++i) {
    const Part part = static_cast<Part>(i);
    if (part != Part::live && part != Part::preview)
      same = read->has(part) == (part == Part::registration ? is_of_its_model(state) : state.has(part));
  }
  if (same && state.image)
    same = *read->image->voxels == *state.image->voxels && read->image->grid.same_as(state.image->grid);
  if (same && state.labels)
    same = read->labels->voxels == state.labels->voxels &&
           (!state.history || state.history->steps().empty() ||
            (read->history && read->history->steps().size() == state.history->steps().size()));
  if (same && state.review) same = *read->review == *state.review;
  if (same && state.model)
    same = close(read->model->model.mesh.vertices, state.model->model.mesh.vertices) &&
           read->model->model.mesh.tetrahedra == state.model->model.mesh.tetrahedra &&
           read->model->model.vessels.size() == state.model->model.vessels.size();
  if (same && state.cloud)
    same = close(read->cloud->points, state.cloud->points) &&
           (read->points != nullptr) == (state.points != nullptr) &&
           (!state.points || same_points(*read->points, *state.points));
  if (same && is_of_its_model(state))
    same = close(read->registration->nodes_in_camera, state.registration->nodes_in_camera);
  if (!same)
    throw FileError(folder.string() +
                    ": the case reads back differently from what was written. Check the disk's free space; "
                    "the old case stands.");
}

void flush_tree(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) flush_to_disk(entry.path());
  flush_to_disk(folder);
}

fs::path former_name(const fs::path& path) {
  return path.parent_path() / ("." + path.filename().string() + ".former");
}

/// Puts `fresh` where `path` is, in one step as seen from outside.
void exchange(const fs::path& fresh, const fs::path& path) {
  std::error_code failure;
  if (!fs::exists(path)) {
    fs::rename(fresh, path, failure);
  } else if (::syscall(SYS_renameat2, AT_FDCWD, fresh.c_str(), AT_FDCWD, path.c_str(), RENAME_EXCHANGE) ==
             0) {
    fs::remove_all(fresh, failure);  // the old case, now under the temporary name
    failure.clear();
  } else {
    // A file system without exchange: between the two renames the case stands under its former name, where
    // open_case looks too.
    fs::rename(path, former_name(path), failure);
    if (!failure) fs::rename(fresh, path, failure);
    if (!failure) fs::remove_all(former_name(path), failure);
  }
  if (failure) throw FileError(path.string() + ": could not be replaced (" + failure.message() + ").");
}

}  // namespace

bool save_case(const fs::path& given, const CaseState& state, const RunContext& context) {
  fs::path path = fs::absolute(given).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (path.extension() != ".glisson")
    throw InputError(given.string(), "", "a case is a folder whose name ends in .glisson",
                     "Choose such a name");
  if (fs::exists(path) && !fs::exists(path / "case.json"))
    throw InputError(given.string(), "", "exists and is not a case", "Choose another name");
  if (!fs::is_directory(path.parent_path()))
    throw FileError(given.string() + ": its folder does not exist. Create it or choose another.");
  const TemporaryFolder temporary(path.parent_path());
  const fs::path fresh = temporary.path() / path.filename();
  fs::create_directory(fresh);
  const auto document = write_parts(fresh, path, state, context);
  if (!document) return false;
  write_json(fresh / "case.json", *document);
  context.progress(0.85, "case.verify");
  verify(fresh, state);
  if (context.cancelled()) return false;
  flush_tree(fresh);
  exchange(fresh, path);
  flush_to_disk(path.parent_path());
  context.progress(1.0, "case.saved");
  return true;
}

Cancellable<CaseState> open_case(const fs::path& given, const RunContext& context,
                                 std::vector<std::string>* lost) {
  fs::path path = fs::absolute(given).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  if (!fs::exists(path) && fs::exists(former_name(path) / "case.json")) path = former_name(path);
  if (!fs::exists(path)) throw FileError(given.string() + ": does not exist. Check the path.");
  if (!fs::exists(path / "case.json"))
    throw InputError(given.string(), "case.json", "is missing: this folder is not a case",
                     "Choose a folder NAME.glisson");
  const json document = read_json(path / "case.json");
  const std::string file = (path / "case.json").string();
  try {
    if (document.at("format") != kFormat)
      throw InputError(file, "format", "is not a Glisson case", "Choose a folder NAME.glisson");
    if (document.at("version").get<int>() > kCaseFormatVersion)
      throw InputError(file, "version",
                       "is " + std::to_string(document.at("version").get<int>()) +
                           ", this program reads up to " + std::to_string(kCaseFormatVersion),
                       "Open it with a newer Glisson");
    CaseState state;
    state.path = fs::absolute(given).lexically_normal();
    for (int i = 0; i < kPartCount; ++i) {
      const Part part = static_cast<Part>(i);
      const std::string code(part_code(part));
      if (!document.at("parts").contains(code)) continue;
      context.progress(static_cast<double>(i) / kPartCount, "case.read");
      const json& entry = document["parts"][code];
      read_part(state, part, entry, path, context, lost);
      if (context.cancelled()) return {};
      if (state.has(part)) state.stamp(part) = read_stamp(entry);
    }
    return state;
  } catch (const json::exception& failure) {
    throw InputError(file, "", std::string("is malformed (") + failure.what() + ")",
                     "Restore the case from a copy");
  }
}

}  // namespace glisson::engine
