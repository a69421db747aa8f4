// SPDX-License-Identifier: GPL-3.0-or-later
// From labels or surfaces to the model.
#include <algorithm>
#include <string>

#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/edit_trees.h"
#include "glisson/engine/commands/export_surfaces.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/simulate_operations.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/surface_export.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/tree_edits.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "model_argument.h"

namespace glisson::app {
namespace {

/// Looked at before the work.
std::string surface_ending(const Arguments& arguments) {
  const std::string ending = "." + arguments.value("format").toStdString();
  const auto& known = engine::surface_endings();
  if (std::find(known.begin(), known.end(), ending) == known.end())
    throw UsageError(
        Cli::tr("--format %1: write stl, ply, obj or vtp.").arg(arguments.value("format")).toStdString());
  if (arguments.has("format") && !arguments.has("surfaces-out"))
    throw UsageError("--format: needs a folder. Give --surfaces-out FOLDER.");
  return ending;
}

void declare_model_command(Arguments& arguments) {
  const model::ModelOptions options;
  declare_case(arguments);
  arguments.option("labels", Cli::tr("Labels to take instead of the case's."), "FILE");
  arguments.option(
      "codes", Cli::tr("What their codes mean: JSON, {\"6\": \"parenchyma\", \"10\": \"portal_vein\", ...}."),
      "FILE");
  arguments.option("surfaces",
                   Cli::tr("Closed surfaces to take instead of labels: a folder by structure, a list "
                           "(JSON) of structures and files, or one file."),
                   "PATH");
  arguments.flag("left-liver",
                 Cli::tr("Takes labels or surfaces of a liver that lies left of the vena cava, as after a "
                         "right hepatectomy: they are refused as mirrored otherwise."));
  arguments.option("unit", Cli::tr("Unit of the surfaces: mm, cm or m."), "UNIT", "mm");
  arguments.option("vertices", Cli::tr("Vertices wanted."), "N", options.mesh.target_vertices);
  arguments.option("edge", Cli::tr("Mean edge length wanted, mm, instead of a number of vertices."), "MM");
  arguments.option("lesion-refinement", Cli::tr("Edge length in lesions over that elsewhere, 0.1 to 1."),
                   "RATIO", options.mesh.lesion_refinement);
  arguments.option("vessel-refinement",
                   Cli::tr("Edge length in and next to vessels over that elsewhere, 0.2 to 1."), "RATIO",
                   options.mesh.vessel_refinement);
  arguments.option("beams",
                   Cli::tr("Beams of all vessels together, about: where they have more, the thinnest and "
                           "shortest side branches are left out, vessels of 4 mm across and more stay."),
                   "N", options.target_beams);
  arguments.option("tree-edits", Cli::tr("What is changed in the vessel trees (JSON, LPS mm)."), "FILE");
  declare_stiffness(arguments);
  arguments.option("truth",
                   Cli::tr("A fine surface of the liver: adds the distances. Read after everything else."),
                   "FILE");
  arguments.flag("operations", Cli::tr("Also simulates operations on it, on which every registration of this "
                                       "case then rests: some seconds that no registration takes."));
  arguments.option("mesh-out", Cli::tr("Also write the mesh here (.vtu, .vtk)."), "FILE");
  arguments.option(
      "surfaces-out",
      Cli::tr("Also write the surfaces of the liver and each structure into this folder, LPS mm, "
              "without the patient's name."),
      "FOLDER");
  arguments.option("format", Cli::tr("Of these surfaces: stl, ply, obj or vtp."), "FORMAT", "stl");
}

/// What would be left unread without a word.
void refuse_idle_options(const Arguments& arguments) {
  const auto needs_labels = [](const char* option) {
    return UsageError(Cli::tr("--%1: needs labels. Give --%2 FILE.").arg(option, "labels").toStdString());
  };
  if (arguments.has("codes") && !arguments.has("labels")) throw needs_labels("codes");
  if (arguments.has("left-liver") && !arguments.has("labels") && !arguments.has("surfaces"))
    throw needs_labels("left-liver");
  if (arguments.has("labels") && arguments.has("surfaces"))
    throw UsageError(Cli::tr("--%1, --%2: give one of them.").arg("labels", "surfaces").toStdString());
  if (arguments.has("edge")) arguments.refuse_idle(QStringLiteral("--edge"), {"vertices"});
}

model::ModelOptions options_of(const Arguments& arguments) {
  model::ModelOptions options;
  options.mesh.target_vertices = arguments.integer("vertices", 50, 200000);
  if (arguments.has("edge")) options.mesh.edge_mm = arguments.number("edge", 1.0, 100.0);
  options.mesh.lesion_refinement = arguments.number("lesion-refinement", 0.1, 1.0);
  options.mesh.vessel_refinement = arguments.number("vessel-refinement", 0.2, 1.0);
  options.target_beams = arguments.integer("beams", 1, 100000);
  return options;
}

/// From surfaces, from a label map, or from the case's labels.
void build_model(const Arguments& arguments, Session& session, const model::ModelOptions& options,
                 const LabelCodes& codes) {
  const LeftLiver left = arguments.has("left-liver") ? LeftLiver::taken : LeftLiver::refused;
  if (arguments.has("surfaces")) {
    session.post(engine::ImportSurfaces{arguments.path("surfaces"), arguments.unit("unit"), options,
                                        ui::built_in_atlas(), left});
  } else {
    // The atlas is asked when the model is built.
    if (arguments.has("labels"))
      session.post(engine::ImportLabels{arguments.path("labels"), codes, nullptr, left});
    session.post(engine::BuildModel{options, ui::built_in_atlas()});
  }
}

/// What is written beside the case.
void write_files(const Arguments& arguments, Session& session, const std::string& surface_ending) {
  if (arguments.has("mesh-out"))
    write_tet_mesh(arguments.path("mesh-out"), session.state()[part::model]->model.mesh,
                   LengthUnit::millimetre);
  if (arguments.has("surfaces-out"))
    session.post(engine::ExportSurfaces{arguments.path("surfaces-out"), surface_ending});
}

}  // namespace

int run_model(const QStringList& given) {
  Arguments arguments("model",
                      Cli::tr("Builds the biomechanical model: tetrahedra, vessels, anterior margin."));
  declare_model_command(arguments);
  if (!arguments.parse(given)) return 0;
  refuse_idle_options(arguments);
  const model::ModelOptions options = options_of(arguments);
  if (arguments.has("mesh-out")) arguments.output_file("mesh-out", {".vtu", ".vtk"});
  const std::string ending = surface_ending(arguments);
  arguments.require_existing("truth");
  (void)given_stiffness(arguments);  // a slip is told before the work
  const std::vector<model::TreeEdit> edits = arguments.has("tree-edits")
                                                 ? model::read_tree_edits(arguments.path("tree-edits"))
                                                 : std::vector<model::TreeEdit>();
  const LabelCodes codes = codes_of(arguments, "codes");
  Session session(arguments);
  open_case_if_there(arguments, session);
  build_model(arguments, session, options, codes);
  if (!edits.empty()) session.post(engine::EditTrees{edits});
  say_stiffness(arguments, session);
  save_case(arguments, session);
  // The model is safe by now, whatever comes of the rest.
  session.attempt([&] {
    const bool whole = until_interrupted([&] {
      if (arguments.has("operations")) {
        session.post(engine::SimulateOperations{});
        save_case(arguments, session);
      }
      write_files(arguments, session, ending);
    });
    if (!whole)
      throw Interrupted(Cli::tr("cancelled; %1 holds what was done before.").arg(arguments.value("case")));
    if (arguments.has("truth"))
      session.figures.merge(
          experiments::surface_figures(session.state()[part::model]->model.surface.mesh,
                                       read_triangle_mesh(arguments.path("truth"), arguments.unit("unit"))));
  });
  session.finish();
  return 0;
}

}  // namespace glisson::app
