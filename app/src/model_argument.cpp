// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_argument.h"

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_tissue.h"
#include "glisson/engine/model_source.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/fem/materials.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/registration/registration_files.h"

namespace glisson::app {
namespace fs = std::filesystem;

void declare_model(Arguments& arguments) {
  arguments.option(
      "model",
      Cli::tr(
          "The model: a case (NAME.glisson), a tetrahedral mesh (.vtu, legacy .vtk, .msh), a closed surface "
          "(.vtk .vtp .stl .obj .ply) or a folder of surfaces."),
      "M");
  arguments.option("unit", Cli::tr("Unit of the model's files and of what is written: mm, cm or m."), "UNIT",
                   "mm");
  arguments.option("vertices", Cli::tr("Vertices wanted when a surface is meshed."), "N",
                   model::ModelOptions().mesh.target_vertices);
  arguments.option("landmarks", Cli::tr("Landmarks of the model (JSON, LPS mm)."), "FILE");
}

ModelArgument load_model(const Arguments& arguments, Session& session) {
  ModelArgument argument;
  argument.path = arguments.required_path("model");
  argument.unit = arguments.unit("unit");
  if (!fs::exists(argument.path))
    throw FileError(argument.path.string() + ": does not exist. Check --model.");
  const bool is_folder = fs::is_directory(argument.path);
  if (is_folder && argument.path.lexically_normal().filename().empty())
    argument.path = argument.path.parent_path();
  for (const char* name : {"case", "model", "mesh", "surfaces", "labels", "roots"})
    session.call(name, argument.path.string());
  const engine::ModelSource kind = engine::model_source(argument.path);
  if (kind == engine::ModelSource::a_case || kind == engine::ModelSource::tetrahedra)
    arguments.refuse_idle(QStringLiteral("--model ") + arguments.value("model"), {"vertices"});
  if (kind == engine::ModelSource::a_case) {
    session.post(engine::OpenCase{argument.path, engine::OpenCase::Access::read});
    session.need({part::model});
  } else if (kind == engine::ModelSource::tetrahedra) {
    session.post(engine::ImportMesh{argument.path, argument.unit});
  } else {
    model::ModelOptions options;
    options.mesh.target_vertices = arguments.integer("vertices", 50, 200000);
    session.post(engine::ImportSurfaces{argument.path, argument.unit, options});
    if (!is_folder) argument.surface = read_triangle_mesh(argument.path, argument.unit);
  }
  if (arguments.has("landmarks"))
    session.post(engine::SetLandmarks{engine::read_landmarks(arguments.path("landmarks"))});
  return argument;
}

void write_deformed(const fs::path& path, const ModelArgument& argument, const Session& session,
                    const Registration& registration, const NamedArrays& said) {
  const PatientModel& model = session.state()[part::model]->model;
  if (!argument.surface) {
    engine::write_registration(path, model, registration, argument.unit, said);
    return;
  }
  registration::write_carried_surface(path, *argument.surface, model, registration, argument.unit,
                                      engine::registration_fields(registration, said));
}

void declare_materials(Arguments& arguments) {
  QStringList names;
  for (const std::string& name : fem::composite_preset_names()) names << QString::fromStdString(name);
  arguments.option("materials", Cli::tr("What the liver is made of: %1.").arg(names.join(", ")), "NAME",
                   "healthy");
  arguments.flag("homogeneous", Cli::tr("Parenchyma only: no vessels, no capsule."));
  arguments.option("young", Cli::tr("Young's modulus of the parenchyma, Pa."), "E");
  arguments.option("poisson", Cli::tr("Poisson's ratio of the parenchyma."), "NU");
  declare_stiffness(arguments);
}

void declare_stiffness(Arguments& arguments) {
  arguments.option("stiffness",
                   Cli::tr("Young's moduli, kPa, as lesion_1=20,lesions=12: of parenchyma (or healthy, "
                           "cirrhotic), lesion_1, lesion_2, ... and lesions (all others) (or soft, as_liver, "
                           "stiff). What is not named is as the case says, or as the liver."),
                   "LIST");
}

std::optional<fem::Tissue> given_stiffness(const Arguments& arguments) {
  if (!arguments.has("stiffness")) return {};
  return fem::tissue_from(arguments.value("stiffness").toStdString());
}

void say_stiffness(const Arguments& arguments, Session& session) {
  const auto given = given_stiffness(arguments);
  if (!given) return;
  const engine::CaseState& now = session.state();
  const fem::Tissue former = fem::still_there(engine::tissue_of(now), now[part::model]->model);
  session.post(engine::SetTissue{fem::said_over(former, *given)});
}

fem::CompositeOptions materials(const Arguments& arguments) {
  fem::CompositeOptions options = fem::composite_preset(arguments.value("materials").toStdString());
  if (arguments.has("young")) options.parenchyma.young_modulus = arguments.number("young", 1.0, 1e9);
  options.ratio_is_given = arguments.has("poisson");
  if (options.ratio_is_given) options.parenchyma.poisson_ratio = arguments.number("poisson", 0.0, 0.499);
  if (const auto said = given_stiffness(arguments); said && said->parenchyma)
    options.parenchyma.young_modulus = *said->parenchyma;
  if (arguments.has("homogeneous")) options.with_capsule = options.with_vessels = false;
  return options;
}

std::optional<fem::CompositeOptions> given_materials(const Arguments& arguments) {
  const auto stiffness = given_stiffness(arguments);
  if (stiffness && stiffness->parenchyma && (arguments.has("materials") || arguments.has("young")))
    throw UsageError(
        "--stiffness: the parenchyma's is said twice. Leave it out, or --materials and --young.");
  for (const char* name : {"materials", "homogeneous", "young", "poisson"})
    if (arguments.has(name)) return materials(arguments);
  return {};
}

registration::Method given_method(const Arguments& arguments) {
  const std::string name = arguments.value("method").toStdString();
  if (const auto method = value_in(registration::kMethodCodes, name)) return *method;
  throw UsageError("--method " + name + ": must be automatic, forces, springs or paper.");
}

std::vector<int> fixed_nodes(const Arguments& arguments, const Session& session) {
  if (!arguments.has("fixed")) return {};
  return read_node_numbers(arguments.path("fixed"), session.state()[part::model]->model.mesh.vertex_count());
}

}  // namespace glisson::app
