// SPDX-License-Identifier: GPL-3.0-or-later
// The way from a CT to a model that can be computed with, stage by stage as engine commands, on the real CT
// (folder GLISSON_DATA, else ../shared/data, with the clicks of tests/data) and on the synthetic patient. One
// run of each stage: it takes seconds. The parts of the model's stage are columns of its line (s_...). What
// holds on another machine is each stage's share of the whole, printed at the end.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "data_folder.h"
#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/editing/tools/smooth.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/script.h"
#include "glisson/fem/composite_model.h"
#include "glisson/insilico/operator.h"
#include "glisson/insilico/patient.h"

namespace {

using namespace glisson;
namespace fs = std::filesystem;

/// What a patient's way begins with.
struct Input {
  fs::path image, seeds;
};

fs::path clicks_folder() {
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return fs::path(source != nullptr ? source : ".") / "tests/data";
}

/// Seconds from each progress code to the next, by code.
class Clock {
 public:
  RunContext context() {
    return {[this](double, std::string_view code) { tick(std::string(code)); }, nullptr, 1};
  }
  void tick(const std::string& code) {
    const auto now = std::chrono::steady_clock::now();
    if (!code_.empty()) seconds_[code_] += std::chrono::duration<double>(now - since_).count();
    code_ = code;
    since_ = now;
  }
  /// All since the last time.
  std::map<std::string, double> take() {
    tick({});
    return std::exchange(seconds_, {});
  }

 private:
  std::string code_;
  std::chrono::steady_clock::time_point since_;
  std::map<std::string, double> seconds_;
};

/// One patient on its way; the stages are measured one after another.
class Way {
 public:
  explicit Way(Input input) : input_(std::move(input)), script_(clock_.context()) {}

  void import(benchmark::State& state) { run(state, engine::ImportImage{input_.image}); }
  void liver(benchmark::State& state) {
    script_.run(engine::SetSeeds{segmentation::read_seeds(input_.seeds)});
    segment(state, {true, false, false, false, false, false});
  }
  void vessels(benchmark::State& state) { segment(state, {false, true, true, true, false, false}); }
  void lesions(benchmark::State& state) { segment(state, {false, false, false, false, true, true}); }
  /// A stroke of 10 mm radius over 30 mm in the middle of the liver.
  void stroke(benchmark::State& state) {
    editing::Paint paint;
    paint.label = structure::kFirstOther;
    paint.brush = editing::Paint::Brush::ball;
    paint.radius = 10e-3;
    paint.path.resize(2, 3);
    paint.path.row(0) = script_.state()[part::seeds]->liver.row(0);
    paint.path.row(1) = paint.path.row(0) + Eigen::RowVector3d(30e-3, 0, 0);
    run(state, engine::EditLabels{{paint, {}}});
  }
  void undo(benchmark::State& state) { run(state, engine::UndoLabels{}); }
  void smooth(benchmark::State& state) {
    run(state, engine::EditLabels{{editing::Smooth{structure::kParenchyma}, {}}});
    script_.run(engine::UndoLabels{});
  }
  void model(benchmark::State& state) {
    clock_.take();
    run(state, engine::BuildModel{});
    std::map<std::string, double> parts;
    for (const auto& [code, seconds] : clock_.take()) {
      if (!code.starts_with("model.")) continue;
      // "model.mesh.lloyd" counts for "mesh"
      parts["s_" + code.substr(6, code.find('.', 6) - 6)] += seconds;
    }
    for (const auto& [part, seconds] : parts) state.counters[part] = seconds;
  }
  /// Vessels and capsule to the tetrahedra, stiffness of each structure.
  void binding(benchmark::State& state) {
    const PatientModel& model = script_.state()[part::model]->model;
    for ([[maybe_unused]] auto _ : state)
      benchmark::DoNotOptimize(
          std::make_unique<fem::CompositeModel>(model.mesh, model.vessels, fem::CompositeOptions()));
  }
  void save(benchmark::State& state) { run(state, engine::SaveCase{folder_.path() / "patient.glisson"}); }
  void open(benchmark::State& state) { run(state, engine::OpenCase{folder_.path() / "patient.glisson"}); }

 private:
  void segment(benchmark::State& state, const segmentation::Structures& structures) {
    engine::Segment command;
    command.options.structures = structures;
    run(state, command);
  }
  void run(benchmark::State& state, const engine::Command& command) {
    for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(script_.run(command));
  }

  Input input_;
  TemporaryFolder folder_;
  Clock clock_;
  engine::Script script_;
};

void add_stages(const std::string& patient, const std::shared_ptr<Way>& way) {
  using Stage = void (Way::*)(benchmark::State&);
  const std::pair<const char*, Stage> stages[] = {
      {"import", &Way::import},       {"liver", &Way::liver},        {"vessels", &Way::vessels},
      {"lesions", &Way::lesions},     {"stroke_10mm", &Way::stroke}, {"undo", &Way::undo},
      {"smooth_liver", &Way::smooth}, {"model", &Way::model},        {"binding", &Way::binding},
      {"save", &Way::save},           {"open", &Way::open}};
  for (const auto& [name, stage] : stages)
    benchmark::RegisterBenchmark((patient + "/" + name).c_str(),
                                 [way, stage = stage](benchmark::State& state) { ((*way).*stage)(state); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

Input synthetic(const fs::path& folder) {
  const auto patient = insilico::make_patient({}, RunContext());
  write_image(folder / "ct.nrrd", patient->ct);
  segmentation::write_seeds(folder / "seeds.json", insilico::click_seeds(patient->truth, {}));
  return {folder / "ct.nrrd", folder / "seeds.json"};
}

/// The table, with each stage as a part of its patient's whole way.
class ShareReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) seconds_.emplace_back(run.benchmark_name(), run.real_accumulated_time);
    ConsoleReporter::ReportRuns(runs);
  }
  void print_shares() const {
    std::map<std::string, double> whole;
    for (const auto& [name, seconds] : seconds_) whole[name.substr(0, name.find('/'))] += seconds;
    for (const auto& [name, seconds] : seconds_)
      std::printf("%-48s %6.2f %%\n", name.c_str(), 100.0 * seconds / whole[name.substr(0, name.find('/'))]);
  }

 private:
  std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const TemporaryFolder folder;
  const fs::path data = test::data_folder().empty() ? fs::path("../shared/data") : test::data_folder();
  const fs::path dicom = data / "ct_ircad1/PATIENT_DICOM.tar.gz";
  if (fs::exists(dicom))
    add_stages("ct_ircad1", std::make_shared<Way>(Input{dicom, clicks_folder() / "3dircadb1_seeds.json"}));
  else
    std::fprintf(stderr, "%s is not there: the real CT is left out.\n", dicom.c_str());
  add_stages("synthetic", std::make_shared<Way>(synthetic(folder.path())));
  ShareReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.print_shares();
  return 0;
}
