// SPDX-License-Identifier: GPL-3.0-or-later
// From the cloud to the registered model.
#include <optional>
#include <string>
#include <vector>

#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/forget_looks.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/keep_look.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/experiments/registration_report.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/registration_files.h"
#include "glisson/ui/common/texts.h"
#include "model_argument.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

void declare_register(Arguments& arguments) {
  declare_model(arguments);
  declare_materials(arguments);
  arguments.option("cloud",
                   Cli::tr("The cloud (PLY); an integer property label is optional: 1 surface, 2 anterior "
                           "margin, 3 umbilical notch."),
                   "cloud.ply");
  arguments.option(
      "looks",
      Cli::tr("Earlier looks at the same organ, which has not moved since: clouds (PLY), commas "
              "between them, each in its own camera's frame. Where they were seen from is found; "
              "the result is in the frame of --cloud."),
      "FILE,FILE...");
  arguments.option("cloud-unit", Cli::tr("Unit of the cloud: mm, cm or m. Without it, the model's."), "UNIT");
  arguments.option("rigid",
                   Cli::tr("Rigid start: auto, none (the cloud is in the model's frame; what is judged by "
                           "where the camera stood is not), or a file with a 4 x 4 matrix cloud_from_model."),
                   "auto|none|FILE", "auto");
  arguments.flag("near",
                 Cli::tr("The file of --rigid is near the right place only: refined rigidly first, as "
                         "a model that was placed by hand."));
  arguments.option("fixed", Cli::tr("Nodes that stay where the rigid start puts them (0-based numbers)."),
                   "FILE");
  arguments.option(
      "method",
      Cli::tr(
          "How the shape is found: forces (few contact forces on the surface, elastic law by "
          "evidence), springs, paper (springs with --prior none, as published) or automatic (forces "
          "where operations are known and for a bare mesh with --fixed; springs where no force is worth its "
          "price, and otherwise)."),
      "automatic|forces|springs|paper", "automatic");
  arguments.option(
      "prior",
      Cli::tr("What is known of the deformation before the cloud is seen: operations (simulated on this "
              "model; needs the vena cava's landmark) or none (elasticity alone, the paper's method)."),
      "operations|none", "operations");
  arguments.option(
      "truth", Cli::tr("True node positions (.xyz or a mesh): adds the errors. Read after everything else."),
      "FILE");
  arguments.flag("accept-doubts",
                 Cli::tr("Write the result even if it is refused; its doubts stay with it. Without this a "
                         "refused registration writes no file, and the exit code is 3."));
  arguments.option("rival",
                   Cli::tr("Takes the N-th of the other places where the organ may be (rival_N_probability, "
                           "rival_N_away_mm) instead of the most probable one."),
                   "N");
  arguments.option(
      "report",
      Cli::tr("Also write a page on the registration: how it ended, how far off organ and lesions "
              "may be, where else the organ may be, its doubts."),
      "FILE.html");
  arguments.option("out", Cli::tr("The registered mesh (.vtu), or surface (.vtp) when a surface was given."),
                   "registered.vtu");
}

/// The cloud that is registered to, and the looks that are joined with it.
void bring_clouds(const Arguments& arguments, Session& session, const fs::path& cloud, LengthUnit unit) {
  session.call("cloud", cloud.string());
  session.call("fixed nodes", arguments.path("fixed").string());
  session.post(engine::ImportCloud{cloud, unit});
  // Those of a case that the model was taken from belong to its own cloud.
  if (session.state()[part::earlier_looks]) session.post(engine::ForgetLooks{});
  int number = 1;
  session.call("look 1", cloud.string());
  for (const QString& look : arguments.value("looks").split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    session.call("look " + std::to_string(++number), look.toStdString());
    session.post(engine::KeepLook{look.toStdString(), unit});
  }
}

/// From where the organ's place is looked for.
void set_start(const Arguments& arguments, LengthUnit unit, engine::Register& command) {
  if (arguments.value("rigid") == "none") {
    command.start = engine::Register::Start::none;
  } else if (arguments.value("rigid") == "auto") {
    if (arguments.has("near")) throw UsageError("--near: needs a matrix. Give its file by --rigid FILE.");
  } else {
    command.start = arguments.has("near") ? engine::Register::Start::near : engine::Register::Start::given;
    command.given = registration::read_start(arguments.path("rigid"), unit);
  }
}

engine::Register command_of(const Arguments& arguments, const Session& session, LengthUnit unit) {
  engine::Register command;
  command.materials = given_materials(arguments);
  command.fixed_nodes = fixed_nodes(arguments, session);
  command.method = given_method(arguments);
  const QString prior = arguments.value("prior");
  if (prior != "operations" && prior != "none")
    throw UsageError("--prior " + prior.toStdString() + ": must be operations or none.");
  command.operations = prior == "operations";
  set_start(arguments, unit, command);
  return command;
}

/// What --out may end in: of a model made of one surface, and of all others.
QStringList surface_endings() { return {".vtp", ".vtk", ".stl", ".obj", ".ply"}; }
QStringList mesh_endings() { return {".vtu", ".vtk"}; }

/// Whether a file of this name can say more than where its points are.
bool holds_fields(const fs::path& file) { return lower_extension(file).starts_with(".vt"); }

std::optional<int> rival_of(const Arguments& arguments) {
  if (!arguments.has("rival")) return {};
  return arguments.integer("rival", 1, 99);
}

/// Registers, and takes another place or what is in doubt where that is asked for. What is told is of the
/// registration that is taken: it repeats what holds of the former one.
void register_as_told(const Arguments& arguments, Session& session, const engine::Register& command,
                      std::optional<int> rival) {
  const Figures figures = session.figures;
  const std::vector<std::string> notes = session.notes;
  session.post(command);
  if (rival) {
    session.figures = figures;
    session.notes = notes;
    session.post(engine::ChooseRival{static_cast<std::size_t>(*rival - 1)});
  }
  if (!arguments.has("accept-doubts")) return;
  session.notes = notes;
  session.post(engine::AcceptRegistration{});
}

void compare_with_truth(const Arguments& arguments, Session& session, LengthUnit unit) {
  const Registration& registration = *session.state()[part::registration];
  const PatientModel& model = session.state()[part::model]->model;
  const Points truth = experiments::read_true_nodes(arguments.path("truth"), unit);
  session.tell(experiments::target_errors(model, registration.nodes_in_camera, truth,
                                          arguments.path("truth").string()));
  session.tell(
      experiments::motion_figures(model, registration.camera_from_ct.apply(model.mesh.vertices), truth));
}

void write_report(const fs::path& report, const std::string& title, const Session& session) {
  const Registration& registration = *session.state()[part::registration];
  std::vector<std::string> doubts;
  for (const std::vector<std::string>* all : {&registration.doubts, &registration.notes})
    for (const std::string& note : *all) doubts.push_back(ui::note_text(note).toStdString());
  experiments::write_registration_report(report, title, session.figures,
                                         registration::ending_code(registration), doubts);
}

}  // namespace

int run_register(const QStringList& given) {
  Arguments arguments(
      "register",
      Cli::tr(
          "Registers a model to a cloud: rigid start, then elastically. What is written keeps the model's "
          "node "
          "order and unit and is in the cloud's frame; its field data cloud_from_model is the rigid part."));
  declare_register(arguments);
  if (!arguments.parse(given)) return 0;
  const fs::path out = arguments.output_file("out", mesh_endings() + surface_endings());
  const fs::path report =
      arguments.has("report") ? arguments.output_file("report", {".html", ".htm"}) : fs::path();
  const fs::path cloud = arguments.required_path("cloud");
  (void)given_materials(arguments);  // a slip is told before the work
  const std::optional<int> rival = rival_of(arguments);
  arguments.require_existing("truth");
  Session session(arguments);
  const ModelArgument argument = load_model(arguments, session);
  arguments.output_file("out", argument.surface ? surface_endings() : mesh_endings());
  const LengthUnit unit = arguments.has("cloud-unit") ? arguments.unit("cloud-unit") : argument.unit;
  bring_clouds(arguments, session, cloud, unit);
  say_stiffness(arguments, session);
  register_as_told(arguments, session, command_of(arguments, session, argument.unit), rival);
  const Registration& registration = *session.state()[part::registration];
  const bool refused = registration::is_refused(registration);
  session.texts["registration_ended"] = registration::ending_code(registration);
  if (!refused) write_deformed(out, argument, session, registration);
  if (!refused && !registration.doubts.empty() && !holds_fields(out))
    session.notes.emplace_back("registration.doubts_not_in_file");
  if (arguments.has("truth")) session.attempt([&] { compare_with_truth(arguments, session, argument.unit); });
  if (!report.empty())
    session.attempt([&] {
      write_report(report, argument.path.filename().string() + ", " + cloud.filename().string(), session);
    });
  session.finish();
  if (!refused) return kDone;
  say(Cli::tr(
      "The registration was refused: what is known contradicts it (see the notes above). No mesh was "
      "written. Give a cloud that shows more of this patient's liver with less noise, mark margin and "
      "notch, or start from --rigid FILE; --accept-doubts writes it nevertheless."));
  return kRefused;
}

}  // namespace glisson::app
