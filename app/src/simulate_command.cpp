// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"
#include "commands.h"
#include "model_argument.h"
#include "output_folder.h"

#include "glisson/engine/commands/simulate.h"

namespace glisson::app {
namespace {

fem::LinearSolver linear_solver(const std::string& name) {
  if (const auto solver = value_in(fem::kSolverCodes, name)) return *solver;
  throw UsageError("--solver " + name + ": must be direct, fast or reference.");
}

}  // namespace

int run_simulate(const QStringList& given) {
  engine::Simulate command;
  Arguments arguments("simulate", Cli::tr("Plain mechanics: a load on the model. Writes deformed meshes with "
                                          "displacement and von Mises stress, and steps.csv "
                                          "with energies, residuals and time per step."));
  declare_model(arguments);
  declare_materials(arguments);
  arguments.option(
      "load", Cli::tr("The load (JSON): gravity, pressure, forces, springs, fixed; see the manual."), "FILE");
  arguments.option("steps", Cli::tr("Steps of the dynamics."), "N", command.options.steps);
  arguments.option("dt", Cli::tr("Time step, s."), "S", command.options.time_step);
  arguments.flag("static", Cli::tr("The equilibrium instead of the dynamics."));
  arguments.option("solver",
                   Cli::tr("Linear solver: direct (a fresh factor every step), fast (two-level "
                           "conjugate gradients, for %1 tetrahedra and more) or reference "
                           "(CHOLMOD).")
                       .arg(fem::kFastFrom),
                   "NAME", "direct");
  arguments.option("tolerance", Cli::tr("Relative residual of the fast solver."), "R",
                   command.options.solver_tolerance);
  arguments.option("every", Cli::tr("Write a mesh every so many steps (the last is always written)."), "N",
                   command.every);
  arguments.flag("neo-hookean", Cli::tr("The non-linear law instead of the co-rotational one."));
  arguments.option("out", Cli::tr("The folder for the results."), "DIR");
  if (!arguments.parse(given)) return 0;
  if (arguments.has("static"))
    arguments.refuse_idle(QStringLiteral("--static"), {"steps", "dt", "solver", "tolerance", "every"});
  OutputFolder out(arguments.required_path("out"));
  command.load = fem::read_load_case(arguments.required_path("load"));
  command.options.steps = arguments.integer("steps", 1, 10000000);
  command.options.time_step = arguments.number("dt", 1e-6, 10.0);
  command.options.static_solve = arguments.has("static");
  command.options.solver = linear_solver(arguments.value("solver").toStdString());
  command.options.solver_tolerance = arguments.number("tolerance", 1e-12, 0.1);
  command.every = arguments.integer("every", 1, 10000000);
  command.materials = given_materials(arguments);
  if (arguments.has("neo-hookean")) command.law = fem::TetrahedronLaw::neo_hookean;
  command.folder = out.path();
  Session session(arguments);
  command.unit = load_model(arguments, session).unit;
  say_stiffness(arguments, session);
  const bool whole = until_interrupted([&] { session.post(command); });
  int meshes = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(out.path())) ++meshes;
  if (whole || meshes > 0) out.commit(whole);
  if (!whole) throw Interrupted(kept_text(meshes, arguments.path("out")));
  session.finish();
  return 0;
}

}  // namespace glisson::app
