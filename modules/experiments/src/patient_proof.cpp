// SPDX-License-Identifier: GPL-3.0-or-later
#include "patient_proof.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "evaluate_trees.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/script.h"
#include "glisson/insilico/operator.h"
#include "glisson/segmentation/evaluate.h"
#include "patient_proof_trials.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

/// Nodes that give a liver about ten thousand tetrahedra.
constexpr int kFineVertices = 2300;

/// Beams enough for every branch: nothing is pruned.
constexpr int kAllBeams = 4000;

/// What ends the name of a count's part that was found.
constexpr std::string_view kFound = "_found";

/// Thrown inside a run when it was cancelled; never leaves prove_patient.
struct Cancelled {};

/// The way of one patient, with the figures of each stage under its name.
class PatientWay {
 public:
  PatientWay(std::string name, const fs::path& folder, PatientProof& proof, const RunContext& context)
      : name_(std::move(name)), folder_(folder / name_), proof_(proof), script_(context) {
    fs::create_directory(folder_);
  }

  void post(engine::Command command, const std::string& stage = {}) {
    const auto outcome = script_.run(std::move(command));
    if (!outcome) throw Cancelled();
    const std::string of = stage.empty() ? "" : stage + "_";
    for (const auto& [key, value] : outcome->figures) set(of + key, value);
    set("seconds_" + (stage.empty() ? outcome->command : stage), outcome->seconds);
    for (const std::string& note : outcome->notes) proof_.notes.push_back(name_ + ": " + note);
  }
  void set(const std::string& key, double value) { proof_.figures[name_ + "_" + key] = value; }
  void compare(const LabelMap& truth, const std::string& stage = {}) {
    for (const auto& [key, value] : segmentation::compare_labels(*state()[part::labels], truth))
      if (stage.empty() || key.starts_with("dice_")) set((stage.empty() ? "" : stage + "_") + key, value);
  }
  const engine::CaseState& state() const { return script_.state(); }
  const fs::path& folder() const { return folder_; }

  /// Twenty strokes over the vessels, from a file, as one script; the labels are the edited ones then.
  void edit_vessels(const LabelMap& truth, int strokes, std::uint64_t seed) {
    insilico::OperatorOptions hand;
    hand.seed = seed;
    editing::write_edits(folder_ / "strokes.json",
                         insilico::draw_vessel_strokes(*state()[part::labels], truth, strokes, hand));
    const auto edits = editing::read_edits(folder_ / "strokes.json");
    double seconds = 0.0;
    for (const editing::Edit& edit : edits) {
      post(engine::EditLabels{edit}, "stroke");
      seconds += proof_.figures[name_ + "_seconds_stroke"];
    }
    set("strokes", static_cast<double>(edits.size()));
    set("seconds_strokes", seconds);
    proof_.figures.erase(name_ + "_seconds_stroke");
    proof_.figures.erase(name_ + "_stroke_voxels_changed");
  }

  /// Of the trees of the model against the true ones, under `stage`.
  void compare_trees(const insilico::SyntheticPatient& patient, const std::string& stage) {
    const VolumeGrid& grid = patient.ct.grid;
    const std::vector<std::uint8_t> liver = inside_liver(patient.truth);
    const auto in_liver = [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3i at = grid.index_of(Point<CtFrame>(p)).array().round().cast<int>();
      return grid.contains(at) && liver[static_cast<std::size_t>(grid.offset(at))] != 0;
    };
    const double voxel = 1e-3 * std::cbrt(grid.voxel_volume_mm3());
    double mean = 0.0;
    int thick = 0, found = 0, loops = 0;
    for (const VesselTree& tree : patient.trees) {
      const TreeScore score = score_tree(tree, state()[part::model]->model.vessels, voxel, in_liver);
      mean += score.mean / static_cast<double>(patient.trees.size());
      thick += score.thick;
      found += score.thick_found;
      loops += score.bridges + score.doubled;
    }
    set(stage + "_centreline_mean_voxels", mean / voxel);
    set(stage + "_branches_found_share", thick > 0 ? static_cast<double>(found) / thick : 0.0);
    set(stage + "_false_loops", loops);
  }

  void build_models() {
    engine::BuildModel coarse, fine;
    fine.options.mesh.target_vertices = kFineVertices;
    post(fine, "fine");
    post(coarse);
    post(engine::SaveCase{folder_ / "patient.glisson", true});
  }

 private:
  std::string name_;
  fs::path folder_;
  PatientProof& proof_;
  engine::Script script_;
};

void require_files(const fs::path& real, const PatientProofOptions& options) {
  for (const fs::path& file :
       {real / "PATIENT_DICOM.tar.gz", real / "3Dircadb0101Labeled.vti",
        options.clicks / "3dircadb1_seeds.json", options.clicks / "3dircadb1_codes.json"})
    if (!fs::exists(file))
      throw FileError(file.string() +
                      ": does not exist. Name the folders of the real patient and its clicks.");
}

void real_way(const fs::path& real, const PatientProofOptions& options, const fs::path& folder,
              PatientProof& proof, const RunContext& context) {
  PatientWay way("real", folder, proof, context);
  way.post(engine::ImportImage{real / "PATIENT_DICOM.tar.gz"});
  way.post(engine::SetSeeds{segmentation::read_seeds(options.clicks / "3dircadb1_seeds.json")});
  way.post(engine::Segment{});
  const fs::path file = real / "3Dircadb0101Labeled.vti";
  const LabelMap truth =
      recode(read_labels(file), read_label_codes(options.clicks / "3dircadb1_codes.json"), file.string());
  way.compare(truth);
  way.edit_vessels(truth, options.strokes, options.seed);
  way.compare(truth, "edited");
  way.build_models();
}

void synthetic_way(const PatientProofOptions& options, const fs::path& folder, PatientProof& proof,
                   const RunContext& context) {
  insilico::PatientOptions shape = options.patient;
  shape.shape_seed = options.seed;
  auto patient = insilico::make_patient(shape, context.part(0.0, 0.1));
  if (!patient) throw Cancelled();
  PatientWay way("synthetic", folder, proof, context.part(0.1, 1.0));
  insilico::OperatorOptions hand;
  hand.seed = options.seed;
  write_image(way.folder() / "ct.nrrd", patient->ct);
  segmentation::write_seeds(way.folder() / "seeds.json", insilico::click_seeds(patient->truth, hand));
  way.post(engine::ImportImage{way.folder() / "ct.nrrd"});
  way.post(engine::SetSeeds{segmentation::read_seeds(way.folder() / "seeds.json")});
  way.post(engine::Segment{});
  way.compare(patient->truth);
  engine::BuildModel all_branches;
  all_branches.options.target_beams = kAllBeams;
  way.post(all_branches, "segmented");
  way.compare_trees(*patient, "segmented");
  way.edit_vessels(patient->truth, options.strokes, options.seed);
  way.compare(patient->truth, "edited");
  way.build_models();
  // The skeleton by itself: from the true labels.
  write_labels(way.folder() / "truth.seg.nrrd", patient->truth.voxels, patient->truth.infos);
  way.post(engine::ImportLabels{way.folder() / "truth.seg.nrrd", {}}, "truth");
  way.post(all_branches, "true_labels");
  way.compare_trees(*patient, "true_labels");
}

/// A volume's error counts in both directions; of the ways from a tree's root to its tips the share that was
/// found.
void add_sizes_and_shares(Figures& figures) {
  Figures added;
  for (const auto& [key, value] : figures) {
    if (key.ends_with("_volume_error")) added[key + "_size"] = std::abs(value);
    const auto all = figures.find(key.substr(0, key.size() - std::min(key.size(), kFound.size())));
    if (key.ends_with(kFound) && all != figures.end() && all->second > 0.0)
      added[key + "_share"] = value / all->second;
  }
  figures.merge(added);
}

}  // namespace

void PatientProofOptions::validate() const {
  const OptionCheck demand("patient proof");
  demand(strokes >= 0, "strokes", strokes, "Give 0 or more");
}

Cancellable<PatientProof> prove_patient(const PatientProofOptions& options, const fs::path& folder,
                                        const RunContext& context) {
  options.validate();
  PatientProof proof;
  try {
    const fs::path real = options.data / "ct_ircad1";
    if (fs::exists(real)) {
      require_files(real, options);
      real_way(real, options, folder, proof, context.part(0.0, 0.3));
    } else {
      proof.absent.push_back(real.filename().string());
    }
    if (options.synthetic)
      synthetic_way(options, folder, proof, context.part(proof.absent.empty() ? 0.3 : 0.0, 0.5));
    if (!run_trials(options, proof, context.part(0.5, 1.0))) return {};
  } catch (const Cancelled&) {
    return {};
  }
  add_sizes_and_shares(proof.figures);
  return proof;
}

}  // namespace glisson::experiments
