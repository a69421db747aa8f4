// SPDX-License-Identifier: GPL-3.0-or-later
// From the CT to the model: import, segment, model.
#include "cli.h"
#include "commands.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

void declare_case(Arguments& arguments) {
  arguments.option("case", Cli::tr("The case's folder, NAME.glisson."), "CASE");
}

void open_case(const Arguments& arguments, Session& session) {
  session.post(engine::OpenCase{arguments.required_path("case")});
}

void save_case(const Arguments& arguments, Session& session) {
  session.post(engine::SaveCase{arguments.required_path("case")});
  session.texts["case"] = arguments.path("case").string();
}

/// What the option's file says that foreign codes mean; nothing without the option.
LabelCodes codes_of(const Arguments& arguments, const QString& option) {
  return arguments.has(option) ? read_label_codes(arguments.path(option)) : LabelCodes{};
}

std::vector<std::uint8_t> truth_mask(const fs::path& path, const LabelCodes& codes, const VolumeGrid& grid) {
  const LabelFile file = read_labels(path);
  require_same_grid(file.voxels.grid(), grid, path.string());
  return inside_liver(codes.empty() ? LabelMap{file.voxels, file.infos} : recode(file, codes, path.string()));
}

}  // namespace

int run_import(const QStringList& given) {
  Arguments arguments(
      "import",
      Cli::tr("Reads a CT (a folder of DICOM slices, a .tar.gz of one, NIfTI, NRRD, MetaImage) into a case, "
              "which is made if there is none."));
  arguments.positional("INPUT", Cli::tr("The volume."));
  declare_case(arguments);
  if (!arguments.parse(given)) return 0;
  const QString input = arguments.positionals(1, 1).front();
  const fs::path folder = arguments.required_path("case");
  Session session(arguments);
  if (fs::exists(folder)) open_case(arguments, session);
  session.post(engine::ImportImage{input.toStdString()});
  save_case(arguments, session);
  session.finish();
  return 0;
}

int run_segment(const QStringList& given) {
  Arguments arguments("segment", Cli::tr("Segments the liver, its vessels and lesions from seeds."));
  declare_case(arguments);
  arguments.option("seeds", Cli::tr("What was clicked (JSON, LPS mm)."), "FILE");
  arguments.option("truth",
                   Cli::tr("Labels of an expert: adds the Dice coefficient. Read after everything else."),
                   "FILE");
  arguments.option("truth-codes", Cli::tr("What the expert's codes mean (JSON)."), "FILE");
  arguments.option("labels-out", Cli::tr("Also write the labels here (.seg.nrrd, .nii.gz)."), "FILE");
  if (!arguments.parse(given)) return 0;
  const fs::path seeds = arguments.required_path("seeds");
  if (arguments.has("labels-out")) arguments.output_file("labels-out", {".nrrd", ".nii.gz", ".nii", ".mha"});
  arguments.require_existing("truth");
  const LabelCodes truth_codes = codes_of(arguments, "truth-codes");
  Session session(arguments);
  open_case(arguments, session);
  session.post(engine::SetSeeds{segmentation::read_seeds(seeds)});
  session.post(engine::Segment{});
  const LabelMap& labels = *session.state().labels;
  if (arguments.has("truth"))
    session.figures["dice_liver"] = segmentation::dice(
        inside_liver(labels), truth_mask(arguments.path("truth"), truth_codes, labels.voxels.grid()));
  save_case(arguments, session);
  if (arguments.has("labels-out")) write_labels(arguments.path("labels-out"), labels.voxels, labels.infos);
  session.finish();
  return 0;
}

int run_model(const QStringList& given) {
  model::ModelOptions options;
  Arguments arguments("model",
                      Cli::tr("Builds the biomechanical model: tetrahedra, vessels, anterior margin."));
  declare_case(arguments);
  arguments.option("labels", Cli::tr("Labels to take instead of the case's."), "FILE");
  arguments.option(
      "codes", Cli::tr("What their codes mean: JSON, {\"6\": \"parenchyma\", \"10\": \"portal_vein\", ...}."),
      "FILE");
  arguments.option("surfaces",
                   Cli::tr("Closed surfaces to take instead of labels: a folder by structure, or one file."),
                   "PATH");
  arguments.option("unit", Cli::tr("Unit of the surfaces: mm, cm or m."), "UNIT", "mm");
  arguments.option("vertices", Cli::tr("Vertices wanted."), "N", options.mesh.target_vertices);
  arguments.option("truth",
                   Cli::tr("A fine surface of the liver: adds the distances. Read after everything else."),
                   "FILE");
  arguments.option("mesh-out", Cli::tr("Also write the mesh here (.vtu, .vtk)."), "FILE");
  if (!arguments.parse(given)) return 0;
  options.mesh.target_vertices = arguments.integer("vertices", 50, 200000);
  if (arguments.has("mesh-out")) arguments.output_file("mesh-out", {".vtu", ".vtk"});
  arguments.require_existing("truth");
  const LabelCodes codes = codes_of(arguments, "codes");
  Session session(arguments);
  if (fs::exists(arguments.required_path("case"))) open_case(arguments, session);
  if (arguments.has("surfaces")) {
    session.post(engine::ImportSurfaces{arguments.path("surfaces"), arguments.unit("unit"), options});
  } else {
    if (arguments.has("labels")) session.post(engine::ImportLabels{arguments.path("labels"), codes});
    session.post(engine::BuildModel{options});
  }
  const PatientModel& model = session.state().model->model;
  if (arguments.has("truth")) {
    const SurfaceDistance distance = surface_distance(
        model.surface.mesh, read_triangle_mesh(arguments.path("truth"), arguments.unit("unit")));
    session.figures["surface_to_truth_mean_mm"] = 1e3 * distance.forward.mean;
    session.figures["truth_to_surface_mean_mm"] = 1e3 * distance.backward.mean;
    session.figures["truth_to_surface_max_mm"] = 1e3 * distance.backward.maximum;
  }
  save_case(arguments, session);
  if (arguments.has("mesh-out"))
    write_tet_mesh(arguments.path("mesh-out"), model.mesh, LengthUnit::millimetre);
  session.finish();
  return 0;
}

}  // namespace glisson::app
