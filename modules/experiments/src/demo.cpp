// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/demo.h"
#include "glisson/experiments/synthetic_model.h"

#include <algorithm>

#include "demo_input.h"
#include "demo_progress.h"
#include "demo_report.h"
#include "glisson/core/error.h"
#include "glisson/core/stopwatch.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_registration.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/video.h"
#include "glisson/engine/register_options.h"
#include "glisson/experiments/again_every.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/experiments/track_evaluation.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/guidance/each_frame.h"
#include "glisson/insilico/film.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/refusal.h"
#include "glisson/stereo/picture_io.h"
#include "outline_distance.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

/// Frames between two whose outline is compared: to cast the truth takes as long as to film it.
constexpr int kOutlineEvery = 5;

bool is_volume(const fs::path& path) {
  const std::string name = path.filename().string();
  for (const char* ending : {".nii", ".nii.gz", ".nrrd", ".mha", ".mhd", ".vti"})
    if (name.ends_with(ending)) return true;
  return false;
}

/// @param points camera frame, metres; those that the lens does not map are left out.
std::vector<Eigen::Vector2d> on_picture(const Points& points, const Camera& camera) {
  std::vector<Eigen::Vector2d> line;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (camera.maps(points.row(i).transpose())) line.push_back(camera.project(points.row(i).transpose()));
  return line;
}

/// Thrown inside a run when it was cancelled, so that every stage need not hand it on; never leaves run_demo.
struct Cancelled {};

class DemoRun {
 public:
  DemoRun(const DemoOptions& options, const fs::path& folder, const DemoPictures& pictures,
          const RunContext& context)
      : options_(options),
        folder_(folder),
        pictures_(pictures),
        context_(context),
        progress_(options, context),
        script_(context) {}

  DemoResult run() {
    fs::create_directory(folder_ / "operator");
    fs::create_directory(folder_ / "pictures");
    make_patient();
    open_theatre();
    register_patch();
    register_pictures();
    track();
    finish();
    return std::move(result_);
  }

 private:
  void post(engine::Command command) {
    script_.report_to(progress_.begin(std::string(command.code())));
    const auto outcome = script_.run(std::move(command));
    if (!outcome) throw Cancelled();
    for (const auto& [key, value] : outcome->figures) result_.figures[key] = value;
    result_.figures["seconds_" + outcome->command] = outcome->seconds;
    result_.notes.insert(result_.notes.end(), outcome->notes.begin(), outcome->notes.end());
  }
  template <class T>
  T take(Cancellable<T> value) {
    if (!value) throw Cancelled();
    return std::move(*value);
  }
  const engine::CaseState& state() const { return script_.state(); }
  const PatientModel& model() const { return state()[part::model]->model; }

  // ---- the patient ----

  void make_patient() {
    model::ModelOptions model_options;
    model_options.mesh.target_vertices = options_.vertices;
    switch (input_of(options_)) {
      case DemoInput::synthetic:
        return make_synthetic_patient(model_options);
      case DemoInput::open_case:
        post(engine::OpenCase{options_.patient, engine::OpenCase::Access::read});
        if (!state()[part::model]) post(engine::BuildModel{model_options});
        break;
      case DemoInput::labels:
        post(engine::ImportLabels{options_.patient, options_.codes});
        post(engine::BuildModel{model_options});
        break;
      case DemoInput::surfaces:
        post(engine::ImportSurfaces{options_.patient, options_.unit, model_options});
        break;
    }
    theatre_patient_ = model();
  }

  void make_synthetic_patient(const model::ModelOptions& model_options) {
    const Stopwatch watch;
    insilico::SyntheticPatient patient =
        take(insilico::make_patient(options_.synthetic, progress_.begin("synthetic_patient")));
    write_image(folder_ / "ct.nrrd", patient.ct);
    segmentation::write_seeds(folder_ / "operator/seeds.json",
                              insilico::click_seeds(patient.truth, options_.clicks));
    result_.figures["seconds_synthetic_patient"] = watch.seconds();
    // From here on the stages see files only; the truth waits for the comparison.
    post(engine::ImportImage{folder_ / "ct.nrrd"});
    post(engine::SetSeeds{segmentation::read_seeds(folder_ / "operator/seeds.json")});
    post(engine::Segment{});
    result_.figures["segmentation_dice_liver"] =
        segmentation::dice(inside_liver(*state()[part::labels]), inside_liver(patient.truth));
    post(engine::BuildModel{model_options});
    theatre_patient_ = shown_in_theatre(std::move(patient));
  }

  // ---- the operating theatre ----

  void open_theatre() {
    const Stopwatch watch;
    theatre_ = take(insilico::Theatre::build(theatre_patient_, options_.theatre, progress_.begin("theatre")));
    theatre_->move_scope(options_.scope);
    const insilico::Film film =
        take(insilico::film(*theatre_, folder_ / "theatre", {}, progress_.begin("film")));
    result_.figures["seconds_theatre"] = watch.seconds();
    film_ = film;
    const insilico::TheatreFigures& figures = theatre_->figures();
    result_.figures["theatre_pressure_pa"] = figures.pressure_pa;
    result_.figures["theatre_breathing_mm"] = figures.breathing_mm;
    result_.figures["theatre_heartbeat_mm"] = figures.heartbeat_mm;
    result_.figures["theatre_tetrahedra"] = figures.tetrahedra;
    result_.figures["theatre_visible_share"] = film.visible_share;
    engine::write_landmarks(folder_ / "operator/landmarks.json",
                            insilico::click_landmarks(theatre_->landmarks(), options_.clicks));
    stereo::write_regions(folder_ / "operator/regions.json",
                          insilico::click_regions(*theatre_, 0, options_.clicks));
    post(engine::SetLandmarks{engine::read_landmarks(folder_ / "operator/landmarks.json")});
    truth_ = theatre_->carry(model().mesh.vertices, 0);
    // How far the organ itself moved (the camera's place is not a motion of the organ), and what no rigid
    // motion explains.
    const Points as_if_rigid = theatre_->camera_from_ct().apply(model().mesh.vertices);
    for (const auto& [key, value] : motion_figures(model(), as_if_rigid, truth_))
      result_.figures[key] = value;
  }

  // ---- initial registration ----

  /// Goes on with a refused one: its doubts stand in the report, its errors in the figures.
  void register_cloud() {
    post(engine::Register{});
    if (registration::is_refused(*state()[part::registration])) post(engine::AcceptRegistration{});
  }

  void compare_registration(const std::string& prefix) {
    for (const auto& [key, value] :
         target_errors(model(), state()[part::registration]->nodes_in_camera, truth_, "theatre"))
      result_.figures[prefix + key] = value;
    const char* const kept[] = {"displacement_mean_mm", "registration_residual_mm", "seconds_register",
                                "registration_steps", "cloud_points"};
    for (const char* key : kept)
      if (result_.figures.contains(key)) result_.figures[prefix + key] = result_.figures[key];
  }

  /// The same cloud by contact forces, on the same operations: its figures beside ours, nothing else of it.
  void compare_forces(const std::string& prefix) {
    registration::RegisterOptions options = engine::options_with_looks(state(), engine::Register{});
    options.method = registration::Method::forces;
    const registration::KnownOperations known = engine::known_operations(state(), context_.seed());
    const Stopwatch watch;
    const auto examined = registration::register_model(
        engine::effective_model(state()), *state()[part::cloud], options, context_.quiet(), known);
    if (!examined) throw Cancelled{};
    const registration::Registered& made = examined->registered;
    result_.figures[prefix + "forces_seconds"] = watch.seconds();
    for (const auto& [key, value] :
         target_errors(model(), made.registration.nodes_in_camera, truth_, "theatre"))
      result_.figures[prefix + "forces_" + key] = value;
    result_.figures[prefix + "forces_expected_error_mean_mm"] = 1e3 * made.forces->expected_error.mean();
    result_.figures[prefix + "forces_residual_mm"] = 1e3 * made.registration.residual;
    result_.figures[prefix + "forces_active"] = static_cast<double>(made.forces->forces.size());
    const registration::LawFit& law = made.forces->laws[static_cast<std::size_t>(made.forces->chosen)];
    result_.figures[prefix + "forces_sigma_mm"] = 1e3 * law.sigma;
    result_.figures[prefix + "forces_ground"] = law.ground;
    result_.figures[prefix + "forces_poisson_ratio"] = law.material.poisson_ratio;
  }

  void register_patch() {
    insilico::PatchOptions patch;
    patch.share = options_.patch_share;
    patch.seed = context_.seed();
    const insilico::Patch sampled = theatre_->patch(0, patch);
    write_cloud(folder_ / "operator/patch.ply", sampled.cloud);
    result_.figures["patch_visible_share"] = sampled.share;
    post(engine::ImportCloud{folder_ / "operator/patch.ply"});
    register_cloud();
    compare_registration("patch_");
    compare_forces("patch_");
  }

  void register_pictures() {
    post(engine::SetCalibration{folder_ / "theatre" / film_.calibration});
    post(engine::SetVideo{folder_ / "theatre" / film_.video, {}});
    post(engine::LoadVideoFrame{0});
    post(engine::SetRegions{stereo::read_regions(folder_ / "operator/regions.json")});
    post(engine::Reconstruct{});
    const DistanceSummary errors =
        summarise(distances_to_surface(state()[part::cloud]->points, theatre_->surface(0)));
    result_.figures["cloud_error_median_mm"] = 1e3 * errors.median;
    result_.figures["cloud_error_p95_mm"] = 1e3 * errors.percentile_95;
    register_cloud();
    compare_registration("");
    compare_forces("");
  }

  // ---- live ----

  void put_start_off() {
    if (options_.start_off.isZero()) return;
    Registration start = *state()[part::registration];
    start.nodes_in_camera.rowwise() += options_.start_off.transpose();
    start.camera_from_ct.translation += options_.start_off;
    const fs::path path = folder_ / "operator/start_off.vtu";
    engine::write_registration(path, model(), start, LengthUnit::millimetre);
    post(engine::ImportRegistration{path, LengthUnit::millimetre});
  }

  void track() {
    put_start_off();
    post(engine::StartTracking{});
    AgainEvery again(
        options_.register_again, {}, [this](engine::Command command) { post(std::move(command)); },
        [this]() -> const engine::CaseState& { return state(); });
    stereo::StereoVideo video(state()[part::video]->left, state()[part::video]->right);
    TrackEvaluation evaluation(model(), *state()[part::registration], video.frames_per_second());
    evaluation.set_true_start(theatre_->carry(model().mesh.vertices, 0));
    std::unique_ptr<stereo::VideoWriter> overlay_video;
    if (pictures_.overlay)
      overlay_video = std::make_unique<stereo::VideoWriter>(folder_ / "overlay.mkv", video.width(),
                                                            video.height(), video.frames_per_second());
    double drawing = 0.0;
    OutlineTally outline, margin;
    const int frames = theatre_->frame_count();
    const RunContext progress = progress_.begin("track");
    const auto followed = [this](const StereoFrame& frame) { return take(script_.follow(frame)); };
    const auto judge = [&](const StereoFrame& frame, const OverlayFrame& overlay) {
      evaluation.add(overlay);
      const Points truth = theatre_->carry(model().mesh.vertices, frame.index);
      if (const auto tried = again.after(frame.index, frame.seconds, context_)) tell_again(*tried);
      if (overlay.nodes_in_camera.rows() == truth.rows()) evaluation.compare(overlay, truth, "theatre");
      if (overlay_video) drawing += draw(*overlay_video, frame, overlay);
      if (frame.index % kOutlineEvery == 0) {
        compare_outline(overlay, outline);
        compare_margin(overlay, margin);
      }
      progress.progress(static_cast<double>(frame.index + 1) / frames, "demo.track");
    };
    guidance::each_frame(video, {}, followed, judge);
    if (overlay_video) {
      overlay_video->close();
      result_.overlay_video = folder_ / "overlay.mkv";
      result_.figures["draw_mean_ms"] = drawing / std::max(1, evaluation.times().frames());
    }
    post(engine::StopTracking{});
    add_track(evaluation);
    result_.figures.merge(outline.figures());
    result_.figures.merge(margin.figures("margin"));
  }

  /// The last registration's error where tracking began.
  void tell_again(const AgainEvery::Tried& tried) {
    ++result_.figures["again_tried"];
    result_.figures["again_failed"] += tried.problem.empty() ? 0.0 : 1.0;
    result_.figures["again_taken"] += tried.line.is_taken ? 1.0 : 0.0;
    result_.figures["again_tre_volume_mean_mm"] =
        target_errors(model(), state()[part::registration]->nodes_in_camera,
                      theatre_->carry(model().mesh.vertices, 0), "theatre")
            .at("tre_volume_mean_mm");
  }

  void compare_outline(const OverlayFrame& overlay, OutlineTally& tally) const {
    if (!pictures_.outline || overlay.level() == Level::withdrawn) return;
    const auto distance =
        outline_distance(pictures_.outline(state(), overlay), theatre_->depth(overlay.index));
    if (distance) tally.add(*distance);
  }

  /// The margin as the overlay puts it against the patient's own, carried by the truth.
  void compare_margin(const OverlayFrame& overlay, OutlineTally& tally) const {
    const Points drawn = engine::effective_landmarks(state()).anterior_margin;
    const Points& truth = theatre_->landmarks().anterior_margin;
    const bool is_there =
        overlay.level() == Level::valid && overlay.nodes_in_camera.rows() == model().mesh.vertex_count();
    if (!is_there || drawn.rows() == 0 || truth.rows() == 0) return;
    const Camera& camera = state()[part::rig]->left;
    const Points placed = bind_points(model().mesh, drawn).apply(model().mesh, overlay.nodes_in_camera);
    const auto distance = line_distance(
        on_picture(placed, camera), on_picture(theatre_->carry(truth, overlay.index), theatre_->rig().left),
        camera.width, camera.height);
    if (distance) tally.add(*distance);
  }

  /// @return milliseconds that drawing took.
  double draw(stereo::VideoWriter& video, const StereoFrame& frame, const OverlayFrame& overlay) {
    const Stopwatch watch;
    const Picture drawn = pictures_.overlay(state(), frame, overlay);
    const double milliseconds = watch.milliseconds();
    video.write(drawn);
    const int frames = theatre_->frame_count();
    if (frame.index == 0 || frame.index == frames / 3 || frame.index == 2 * frames / 3)
      keep_picture("overlay_" + std::to_string(frame.index), drawn);
    return milliseconds;
  }

  void add_track(const TrackEvaluation& evaluation) {
    for (const Figures& figures : {evaluation.times().counts(), evaluation.times().percentiles()})
      for (const auto& [key, value] : figures) result_.figures[key] = value;
    const Figures errors = evaluation.errors();
    for (const char* key : {"tre_volume_mean_mm", "tre_target_mean_mm", "tre_frozen_mean_mm",
                            "motion_mean_mm", "motion_error_mean_mm"})
      if (errors.contains(key)) result_.figures[std::string("track_") + key] = errors.at(key);
  }

  // ---- what remains ----

  void keep_picture(const std::string& name, const Picture& picture) {
    stereo::write_picture(folder_ / "pictures" / (name + ".png"), picture);
    kept_.push_back(name);
  }

  void finish() {
    if (pictures_.slice && state()[part::image]) keep_picture("slice", pictures_.slice(state()));
    if (pictures_.model) keep_picture("model", pictures_.model(state()));
    keep_picture("left", state()[part::frame]->frame.left);
    result_.case_folder = folder_ / "patient.glisson";
    post(engine::SaveCase{result_.case_folder, true});
    result_.report = folder_ / "report.html";
    write_demo_report(
        result_.report,
        options_.patient.empty() ? "the synthetic patient" : options_.patient.filename().string(), kept_,
        engine::landmark_origins(state()), result_);
    write_figures(folder_ / "figures.json", result_.figures);
  }

  const DemoOptions& options_;
  fs::path folder_;
  const DemoPictures& pictures_;
  RunContext context_;
  DemoProgress progress_;
  engine::Script script_;
  PatientModel theatre_patient_;
  std::unique_ptr<insilico::Theatre> theatre_;
  insilico::Film film_;
  Points truth_;
  std::vector<std::string> kept_;
  DemoResult result_;
};

}  // namespace

void DemoOptions::validate() const {
  const OptionCheck demand("demo");
  demand(vertices >= 50 && vertices <= 200000, "vertices", vertices, "Give 50 to 200000");
  demand(start_off.norm() <= 0.2, "start_off", start_off.norm(), "Give 0.2 m at most");
  demand(register_again >= 0.0, "register_again", register_again, "Give seconds from zero");
  demand(patch_share > 0.0 && patch_share <= 1.0, "patch_share", patch_share, "Give a share up to 1");
  synthetic.validate();
  theatre.validate();
  scope.validate();
  clicks.validate();
}

DemoInput input_of(const DemoOptions& options) {
  if (options.patient.empty()) return DemoInput::synthetic;
  if (engine::is_case(options.patient)) return DemoInput::open_case;
  return is_volume(options.patient) ? DemoInput::labels : DemoInput::surfaces;
}

Cancellable<DemoResult> run_demo(const DemoOptions& options, const fs::path& folder,
                                 const DemoPictures& pictures, const RunContext& context) {
  options.validate();
  try {
    return DemoRun(options, folder, pictures, context).run();
  } catch (const Cancelled&) {
    return {};
  }
}

}  // namespace glisson::experiments
