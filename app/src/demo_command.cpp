// SPDX-License-Identifier: GPL-3.0-or-later
#include <QProcess>
#include <QUrl>

#include "cli.h"
#include "commands.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/experiments/demo.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/ui/scene/patient_scene.h"
#include "glisson/ui/scene/slice_picture.h"
#include "live_overlay.h"
#include "output_folder.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

Picture draw_model(const engine::CaseState& state) {
  scene::PatientScene patient;
  patient.set_model(engine::effective_model(state));
  patient.set_landmarks(engine::effective_landmarks(state));
  patient.set_opacity(structure::kParenchyma, 0.35);
  patient.look_from(scene::ViewFrom::anterior);
  scene::OffscreenRenderer renderer(960, 720);
  return renderer.render(patient.renderer());
}

Picture draw_slice(const engine::CaseState& state) {
  // Through the liver's middle, so that the liver is what one sees.
  const Point<CtFrame> middle(centroid(state[part::model]->model.surface.mesh));
  const scene::SliceGeometry geometry =
      scene::slice_geometry(state[part::image]->grid, scene::Plane::axial, middle);
  return scene::slice_picture(*state[part::image],
                              state[part::labels] ? &state[part::labels]->voxels : nullptr, geometry, {});
}

/// Draws the organ's outline, without any words; makes its painter again for another model.
std::function<Picture(const engine::CaseState&, const OverlayFrame&)> outline_hook() {
  struct Kept {
    std::shared_ptr<const model::BuiltModel> model;
    std::unique_ptr<scene::OverlayPainter> painter;
    Picture black;
  };
  return [kept = std::make_shared<Kept>()](const engine::CaseState& state, const OverlayFrame& overlay) {
    if (kept->model != state[part::model]) {
      scene::OverlayStyle outline;
      outline.portal_vein = outline.hepatic_veins = outline.arteries = outline.lesions = false;
      outline.anterior_margin = outline.legend = outline.status = outline.ruler = false;
      const Camera& camera = state[part::rig]->left;
      kept->painter =
          std::make_unique<scene::OverlayPainter>(engine::effective_model(state), camera, outline);
      const auto bytes = 3 * static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
      kept->black = {camera.width, camera.height, 3, std::make_shared<std::vector<std::uint8_t>>(bytes)};
      kept->model = state[part::model];
    }
    OverlayFrame drawn = overlay;
    drawn.validity = Validity::valid;  // a border around the picture is no outline
    drawn.doubtful = false;
    return kept->painter->paint(kept->black, drawn);
  };
}

void declare_demo(Arguments& arguments) {
  const experiments::DemoOptions options;
  arguments.option("out", Cli::tr("The folder for the results."), "DIR", "glisson-demo");
  arguments.option(
      "patient",
      Cli::tr("Another patient than the synthetic one: a case, a label map, or surfaces (a folder "
              "by structure, or one file)."),
      "CASE|LABELMAP|SURFACES");
  arguments.option("codes", Cli::tr("What a label map's codes mean (JSON)."), "FILE");
  arguments.option("unit", Cli::tr("Unit of surfaces: mm, cm or m."), "UNIT", "mm");
  arguments.option("vertices", Cli::tr("Vertices of the model."), "N", options.vertices);
  arguments.option("frames", Cli::tr("Length of the film, at 30 frames a second."), "N",
                   options.theatre.frames);
  arguments.option("distance", Cli::tr("Distance of the laparoscope, mm (80 to 160)."), "MM",
                   options.theatre.camera_distance_mm);
  arguments.flag(
      "standing-scope",
      Cli::tr("The laparoscope stands. Otherwise a hand holds it: it turns about the trocar, comes "
              "nearer, goes away and rolls."));
  arguments.option("share", Cli::tr("Share of the surface in the patch of the paper's protocol."), "SHARE",
                   options.patch_share);
  arguments.option("shape", Cli::tr("Which member of the synthetic population."), "SEED",
                   static_cast<double>(options.synthetic.shape_seed));
  arguments.option("start-off",
                   Cli::tr("Puts the registration off by so many millimetres before it is followed: across, "
                           "down and away from the camera."),
                   "X,Y,Z");
  arguments.option("register-again", Cli::tr("Registers again every so many seconds of the film."),
                   "SECONDS");
  arguments.flag("headless", Cli::tr("Do not open the window at the end."));
}

/// @throws UsageError, FileError what is wrong with the arguments.
experiments::DemoOptions options_of(const Arguments& arguments) {
  experiments::DemoOptions options;
  options.patient = arguments.path("patient");
  if (!options.patient.empty() && !fs::exists(options.patient))
    throw FileError(options.patient.string() + ": does not exist. Check --patient.");
  if (arguments.has("patient")) arguments.refuse_idle(QStringLiteral("--patient"), {"shape"});
  options.unit = arguments.unit("unit");
  if (arguments.has("codes")) options.codes = read_label_codes(arguments.path("codes"));
  options.vertices = arguments.integer("vertices", 50, 20000);
  options.patch_share = arguments.number("share", 0.05, 1.0);
  options.synthetic.shape_seed = static_cast<std::uint64_t>(arguments.integer("shape", 0, 1000000));
  options.theatre.frames = arguments.integer("frames", 1, 100000);
  options.theatre.camera_distance_mm = arguments.number("distance", 80.0, 160.0);
  options.theatre.seed = options.clicks.seed = arguments.seed();
  if (arguments.has("standing-scope")) options.scope = {};
  if (arguments.has("start-off")) {
    const std::vector<double> off = arguments.numbers("start-off", 3, -100.0, 100.0);
    options.start_off = 1e-3 * Eigen::Vector3d(off[0], off[1], off[2]);
  }
  if (arguments.has("register-again"))
    options.register_again = arguments.number("register-again", 1.0, 3600.0);
  return options;
}

/// Where the main files are, once they are in their place.
void tell_files(const experiments::DemoResult& result, const fs::path& folder, Session& session) {
  for (const auto& [name, path] :
       {std::pair("case", result.case_folder), std::pair("overlay video", result.overlay_video),
        std::pair("report", result.report)})
    if (!path.empty()) session.texts[name] = (folder / path.filename()).string();
}

}  // namespace

int run_demo(const QStringList& given) {
  Arguments arguments("demo", Cli::tr("The main job from end to end: a patient becomes a model, an in-silico "
                                      "theatre deforms and films the liver, the model "
                                      "is registered to the pictures and follows the video; ends with an "
                                      "overlay video and a report with the true errors."));
  declare_demo(arguments);
  if (!arguments.parse(given)) return 0;
  const experiments::DemoOptions options = options_of(arguments);
  OutputFolder out(arguments.path("out"));
  Session session(arguments);
  const auto result = experiments::run_demo(
      options, out.path(), {overlay_hook(), draw_slice, draw_model, outline_hook()}, session.context());
  if (!result) throw Interrupted();
  out.commit();
  session.figures = result->figures;
  session.notes = result->notes;
  const fs::path folder = arguments.path("out");
  tell_files(*result, folder, session);
  session.finish();
  if (!arguments.has("headless") && has_display())
    QProcess::startDetached(QCoreApplication::applicationFilePath(),
                            {QString::fromStdString((folder / result->case_folder.filename()).string())});
  return 0;
}

}  // namespace glisson::app
