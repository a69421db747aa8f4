// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the READMEs, measured again: one proof for each part of the way.
#include "cli.h"
#include "commands.h"
#include "glisson/core/files.h"
#include "glisson/experiments/patient_proof.h"
#include "glisson/experiments/stereo_proof.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

enum class Sense { at_least, at_most };

/// A figure of a proof, what it is for people, and what it should be.
struct Aim {
  const char* key;
  const char* what;  ///< to be translated
  Sense sense;
  double bound;
  int decimals;
};

constexpr Aim kPatientAims[] = {
    {"real_dice_liver", QT_TRANSLATE_NOOP("cli", "real CT: Dice of the liver"), Sense::at_least, 0.93, 3},
    {"real_dice_portal_vein_inside",
     QT_TRANSLATE_NOOP("cli", "real CT: Dice of the portal vein in the liver"), Sense::at_least, 0.5, 3},
    {"real_dice_hepatic_veins_inside",
     QT_TRANSLATE_NOOP("cli", "real CT: Dice of the hepatic veins in the liver"), Sense::at_least, 0.5, 3},
    {"real_edited_dice_portal_vein_inside",
     QT_TRANSLATE_NOOP("cli", "real CT: portal vein after the strokes"), Sense::at_least, 0.5, 3},
    {"real_edited_dice_hepatic_veins_inside",
     QT_TRANSLATE_NOOP("cli", "real CT: hepatic veins after the strokes"), Sense::at_least, 0.5, 3},
    {"real_model_vertices_to_fine_mean_mm",
     QT_TRANSLATE_NOOP("cli", "real CT: vertices to the fine surface, mean, mm"), Sense::at_most, 0.25, 2},
    {"real_model_min_dihedral_deg", QT_TRANSLATE_NOOP("cli", "real CT: least dihedral angle, degrees"),
     Sense::at_least, 10.0, 1},
    {"real_fine_model_tetrahedra", QT_TRANSLATE_NOOP("cli", "real CT: tetrahedra of the fine model"),
     Sense::at_least, 9000.0, 0},
    {"real_fine_model_min_dihedral_deg",
     QT_TRANSLATE_NOOP("cli", "real CT: least dihedral angle of the fine model, degrees"), Sense::at_least,
     10.0, 1},
    {"real_model_lesion_volume_error_max",
     QT_TRANSLATE_NOOP("cli", "real CT: volume error of lesions above 1 ml, largest"), Sense::at_most, 0.05,
     3},
    {"real_fine_model_volume_error_size", QT_TRANSLATE_NOOP("cli", "real CT: volume error of the fine model"),
     Sense::at_most, 0.01, 4},
    {"synthetic_dice_liver", QT_TRANSLATE_NOOP("cli", "in silico: Dice of the liver"), Sense::at_least, 0.96,
     3},
    {"synthetic_true_labels_centreline_mean_voxels",
     QT_TRANSLATE_NOOP("cli", "in silico: centrelines to the true trees, mean, voxels"), Sense::at_most, 1.0,
     2},
    {"synthetic_true_labels_branches_found_share",
     QT_TRANSLATE_NOOP("cli", "in silico: branches above 2 mm radius found"), Sense::at_least, 0.95, 3},
    {"synthetic_true_labels_false_loops", QT_TRANSLATE_NOOP("cli", "in silico: false loops"), Sense::at_most,
     0.0, 0},
    {"synthetic_segmented_centreline_mean_voxels",
     QT_TRANSLATE_NOOP("cli", "in silico, segmented by clicks: centrelines to the true trees, mean, voxels"),
     Sense::at_most, 1.0, 2},
    {"synthetic_model_vertices_to_fine_mean_mm",
     QT_TRANSLATE_NOOP("cli", "in silico: vertices to the fine surface, mean, mm"), Sense::at_most, 0.25, 2},
    {"synthetic_model_min_dihedral_deg", QT_TRANSLATE_NOOP("cli", "in silico: least dihedral angle, degrees"),
     Sense::at_least, 10.0, 1},
    {"synthetic_fine_model_volume_error_size",
     QT_TRANSLATE_NOOP("cli", "in silico: volume error of the fine model"), Sense::at_most, 0.01, 4},
};

constexpr Aim kStereoAims[] = {
    {"opencas_sparse_points", QT_TRANSLATE_NOOP("cli", "real liver, features: points"), Sense::at_least,
     100.0, 0},
    {"opencas_sparse_median_mm",
     QT_TRANSLATE_NOOP("cli", "real liver, features: median to the CT surface, mm"), Sense::at_most, 0.65, 2},
    {"opencas_sparse_within_3mm_share", QT_TRANSLATE_NOOP("cli", "real liver, features: share within 3 mm"),
     Sense::at_least, 0.95, 3},
    {"opencas_sparse_without_offset_median_mm",
     QT_TRANSLATE_NOOP("cli", "real liver, features: median without the common offset, mm"), Sense::at_most,
     0.5, 2},
    {"opencas_dense_median_mm", QT_TRANSLATE_NOOP("cli", "real liver, dense: median to the CT surface, mm"),
     Sense::at_most, 0.62, 2},
    {"opencas_dense_covered_share",
     QT_TRANSLATE_NOOP("cli", "real liver, dense: share of the region covered"), Sense::at_least, 0.95, 3},
    {"opencas_dense_without_offset_median_mm",
     QT_TRANSLATE_NOOP("cli", "real liver, dense: median without the common offset, mm"), Sense::at_most, 0.5,
     2},
    {"chessboard_rms_px", QT_TRANSLATE_NOOP("cli", "real chessboards: joint stereo rms, pixels"),
     Sense::at_most, 0.65, 3},
    {"chessboard_views_better_share",
     QT_TRANSLATE_NOOP("cli", "real chessboards: views that fit better left out than by the reference"),
     Sense::at_least, 1.0, 2},
    {"heart_sparse_epipolar_rms_px", QT_TRANSLATE_NOOP("cli", "real heart: rows, rms, pixels"),
     Sense::at_most, 0.8, 2},
    {"theatre_largest_bias_mm", QT_TRANSLATE_NOOP("cli", "in silico: largest bias of any trial, mm"),
     Sense::at_most, 0.1, 3},
    {"theatre_normalised_median",
     QT_TRANSLATE_NOOP("cli", "in silico: normalised error, median of the trials (1: sigma is right)"),
     Sense::at_most, 1.5, 2},
    {"theatre_normalised_median",
     QT_TRANSLATE_NOOP("cli", "in silico: normalised error, median of the trials (1: sigma is right)"),
     Sense::at_least, 0.5, 2},
};

/// One line for each aim whose figure there is: what, measured, aim, whether it is met.
void say_aims(const std::vector<Aim>& aims, const Figures& figures) {
  for (const Aim& aim : aims) {
    const auto figure = figures.find(aim.key);
    if (figure == figures.end()) continue;
    const bool met = aim.sense == Sense::at_least ? figure->second >= aim.bound : figure->second <= aim.bound;
    say(QStringLiteral("%1  %2  (%3 %4)  %5")
            .arg(Cli::tr(aim.what), -72)
            .arg(figure->second, 9, 'f', aim.decimals)
            .arg(aim.sense == Sense::at_least ? QStringLiteral("≥") : QStringLiteral("≤"))
            .arg(aim.bound, 0, 'f', aim.decimals)
            .arg(met ? Cli::tr("met") : Cli::tr("NOT MET")));
  }
}

/// A volume's error counts in both directions.
void add_sizes(Figures& figures) {
  Figures sizes;
  for (const auto& [key, value] : figures)
    if (key.ends_with("_volume_error")) sizes[key + "_size"] = std::abs(value);
  figures.merge(sizes);
}

void prove_patient(const Arguments& arguments, Session& session, const fs::path& folder) {
  experiments::PatientProofOptions options;
  options.seed = arguments.seed();
  const fs::path real = arguments.path("data") / "ct_ircad1";
  if (fs::exists(real)) {
    options.real = real;
    options.clicks = arguments.path("clicks");
  } else {
    say(Cli::tr("%1 is not there: the real CT is left out.").arg(QString::fromStdString(real.string())));
  }
  auto proof = experiments::prove_patient(options, folder, session.context());
  if (!proof) throw Interrupted();
  add_sizes(proof->figures);
  session.figures.merge(proof->figures);
  session.notes = proof->notes;
}

void prove_stereo(const Arguments& arguments, Session& session, const fs::path& folder) {
  experiments::StereoProofOptions options;
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  auto proof = experiments::prove_stereo(options, folder, session.context());
  if (!proof) throw Interrupted();
  for (const std::string& path : proof->absent)
    say(Cli::tr("%1 is not there and is left out.").arg(QString::fromStdString(path)));
  for (const std::string& line : proof->table) say(QString::fromStdString(line));
  session.figures.merge(proof->figures);
}

struct Proof {
  const char* name;
  void (*run)(const Arguments&, Session&, const fs::path& folder);
  std::vector<Aim> aims;
};

const std::vector<Proof>& proofs() {
  static const std::vector<Proof> kProofs = {
      {"patient", prove_patient, {std::begin(kPatientAims), std::end(kPatientAims)}},
      {"stereo", prove_stereo, {std::begin(kStereoAims), std::end(kStereoAims)}},
  };
  return kProofs;
}

}  // namespace

int run_prove(const QStringList& given) {
  Arguments arguments(
      "prove",
      Cli::tr("Measures the figures of the READMEs again, against experts' labels and "
              "known truths: patient (from the CT to the model), stereo (from pictures to clouds)."));
  arguments.positional("PROOF", Cli::tr("Which: patient or stereo."));
  arguments.option("data", Cli::tr("Folder of the real data; what is not there is left out."), "DIR",
                   "../shared/data");
  arguments.option("clicks", Cli::tr("Folder of the clicks on it."), "DIR", "tests/data");
  arguments.option("out", Cli::tr("Folder for cases, scripts and pictures."), "DIR");
  if (!arguments.parse(given)) return 0;
  const QString name = arguments.positionals(1, 1).front();
  const auto proof = std::find_if(proofs().begin(), proofs().end(),
                                  [&](const Proof& one) { return name == QLatin1String(one.name); });
  if (proof == proofs().end())
    throw UsageError(Cli::tr("%1: is no proof. See 'glisson prove --help'.").arg(name).toStdString());
  OutputFolder folder(arguments.required_path("out"));
  Session session(arguments);
  proof->run(arguments, session, folder.path());
  folder.commit();
  session.finish();
  say_aims(proof->aims, session.figures);
  return 0;
}

}  // namespace glisson::app
