// SPDX-License-Identifier: GPL-3.0-or-later
// From the CT to the model: import, segment.
#include <cmath>
#include <memory>

#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "label_output.h"

#include "glisson/engine/commands/correct_around.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/list_series.h"
#include "glisson/engine/commands/propose_seeds.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/segment_by_network.h"
#include "glisson/engine/commands/set_modality.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/patient_held.h"
#include "glisson/patient/label_map.h"
#include "glisson/segmentation/added_clicks.h"
#include "glisson/ui/common/series_texts.h"
#include "glisson/volume/io.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// "portal_vein,hepatic_veins": what is found anew. Everything where nothing is said.
segmentation::Structures structures_from(const QString& list) {
  if (list.isEmpty()) return {};
  segmentation::Structures structures = segmentation::kNoStructures;
  for (const QString& part : list.split(',')) {
    const auto wanted = value_in(segmentation::kStructureCodes, part.toStdString());
    if (!wanted)
      throw UsageError(Cli::tr("--only %1: is no structure that is found. Use liver, portal_vein, "
                               "hepatic_veins, vena_cava, gallbladder or lesions, with commas.")
                           .arg(part)
                           .toStdString());
    structures.*(*wanted) = true;
  }
  return structures;
}

std::vector<Label> locked_from(const QString& list) {
  std::vector<Label> locked;
  for (const QString& part : list.split(',', Qt::SkipEmptyParts)) {
    const auto label = structure_named(part.toStdString());
    if (!label || *label == structure::kBackground)
      throw UsageError(Cli::tr("--lock %1: is no label. Use parenchyma, portal_vein, hepatic_veins, "
                               "vena_cava, gallbladder or lesion_1, lesion_2, ..., with commas.")
                           .arg(part)
                           .toStdString());
    locked.push_back(*label);
  }
  return locked;
}

/// "x0,y0,z0,x1,y1,z1" in LPS mm.
std::optional<Eigen::AlignedBox3d> region_from(const QString& text) {
  if (text.isEmpty()) return {};
  std::array<double, 6> mm{};
  const QStringList parts = text.split(',');
  bool good = parts.size() == 6;
  for (int n = 0; good && n < 6; ++n) {
    mm[static_cast<std::size_t>(n)] = parts[n].toDouble(&good);
    good = good && std::isfinite(mm[static_cast<std::size_t>(n)]);  // "nan" is a number to Qt
  }
  if (!good)
    throw UsageError(Cli::tr("--region %1: write two opposite corners, X0,Y0,Z0,X1,Y1,Z1 in LPS millimetres.")
                         .arg(text)
                         .toStdString());
  Eigen::AlignedBox3d box;
  box.extend(1e-3 * Eigen::Vector3d(mm[0], mm[1], mm[2]));
  box.extend(1e-3 * Eigen::Vector3d(mm[3], mm[4], mm[5]));
  return box;
}

std::optional<Modality> modality_from(const QString& text) {
  if (text.isEmpty()) return {};
  const auto modality = modality_named(text.toStdString());
  if (modality && *modality != Modality::other) return modality;
  throw UsageError(Cli::tr("--modality %1: write ct or mr.").arg(text).toStdString());
}

/// The series of a folder in the order of the window's list, and what speaks against each.
int tell_series(const Arguments& arguments, const fs::path& input) {
  Session session(arguments);
  const auto all = session.post(engine::ListSeries{input}).result.as<engine::ListSeries::Result>();
  session.figures["series"] = static_cast<double>(all->size());
  int number = 0;
  for (const DicomSeries& series : *all) {
    const std::string key = QStringLiteral("series_%1").arg(++number, 2, 10, QLatin1Char('0')).toStdString();
    QStringList parts = {
        Cli::tr("number %1")
            .arg(series.number.empty() ? QStringLiteral("?") : QString::fromStdString(series.number)),
        QString::fromStdString(series.modality),
        ui::description_text(series),
        ui::phase_text(phase_of(series)),
        Cli::tr("%1 slices").arg(series.slices),
        ui::spacing_text(series),
        QString::fromStdString(series.date),
        QString::fromStdString(series.patient)};
    parts.removeAll(QString());
    session.texts[key] = parts.join(QStringLiteral(" | ")).toStdString();
    session.texts[key + "_uid"] = series.uid;
    if (const QString doubts = ui::doubts_text(series); !doubts.isEmpty())
      session.texts[key + "_doubts"] = doubts.toStdString();
  }
  session.finish();
  return 0;
}

engine::OverHandWork over_hand_work(const Arguments& arguments) {
  if (arguments.has("keep-edited") && arguments.has("replace-edited"))
    throw UsageError(Cli::tr("--keep-edited, --replace-edited: give one of them.").toStdString());
  return arguments.has("keep-edited")      ? engine::OverHandWork::keep_hand
         : arguments.has("replace-edited") ? engine::OverHandWork::replace
                                           : engine::OverHandWork::offer;
}

/// @throws UsageError where an option is given that means nothing beside another.
void refuse_beside(const char* option, const Arguments& arguments,
                   std::initializer_list<const char*> others) {
  for (const char* other : others)
    if (arguments.has(QLatin1String(other)))
      throw UsageError(Cli::tr("--%1, --%2: give one of them.")
                           .arg(QLatin1String(option), QLatin1String(other))
                           .toStdString());
}

/// The figures say what would change; the case on the disk stays as it is.
[[noreturn]] void refuse_after_telling(Session& session) {
  session.finish();
  throw engine::hand_work_error(session.state()[part::offer]->edited);
}

void segment_by_seeds(Session& session, const engine::Segment& command, const fs::path& seeds,
                      bool proposes) {
  session.post(engine::SetSeeds{seeds.empty() ? segmentation::Seeds{} : segmentation::read_seeds(seeds)});
  if (proposes) session.post(engine::ProposeSeeds{});
  session.post(command);
}

/// Around each click that the case does not have yet; the labels elsewhere stay. @param as what is locked,
/// and what becomes of lesions that a hand has drawn.
void correct_by_seeds(Session& session, const fs::path& path, const engine::Segment& as) {
  const auto known = session.state()[part::seeds];
  const segmentation::Seeds seeds = segmentation::read_seeds(path);
  const auto added = segmentation::added_clicks(known ? *known : segmentation::Seeds{}, seeds, path.string());
  session.post(engine::SetSeeds{seeds});
  session.post(
      engine::CorrectAround{added.liver, seeds, as.options.locked, added.structures, as.over_hand_work});
}

void declare_segment(Arguments& arguments) {
  declare_case(arguments);
  arguments.option("seeds", Cli::tr("What was clicked (JSON, LPS mm)."), "FILE");
  arguments.flag(
      "correct",
      Cli::tr("Correct the case's labels around the clicks on the liver, beside it, on its veins and "
              "on lesions that the case does not have yet; the labels elsewhere stay."));
  arguments.flag("propose", Cli::tr("Look for the liver without a click in it. Look at what comes of it."));
  arguments.option("resolution", Cli::tr("Of the liver's contour, mm."), "MM",
                   engine::Segment().options.working_spacing_mm);
  arguments.option("only",
                   Cli::tr("Find these anew and keep the other labels: liver, portal_vein, hepatic_veins, "
                           "vena_cava, gallbladder, lesions, with commas."),
                   "LIST");
  arguments.option("region",
                   Cli::tr("Only inside this box, and keep the labels outside: X0,Y0,Z0,X1,Y1,Z1, LPS mm."),
                   "BOX");
  arguments.option("lock",
                   Cli::tr("These labels neither lose nor gain a voxel: parenchyma, portal_vein, "
                           "hepatic_veins, vena_cava, gallbladder, lesion_1, ..., with commas."),
                   "LIST");
  arguments.flag(
      "keep-edited",
      Cli::tr("Of labels that were corrected by hand keep each voxel that was, and replace the rest."));
  arguments.flag(
      "replace-edited",
      Cli::tr("Replace labels that were corrected by hand, corrections and all. Without these two it "
              "is only told what would change."));
  arguments.option("modality", Cli::tr("ct or mr: what the volume is, where its file does not say."),
                   "MODALITY");
  arguments.option("network",
                   Cli::tr("Your own segmentation network (ONNX) instead of seeds; MODEL.json beside it says "
                           "what it wants and what its channels mean (see the manual)."),
                   "MODEL.onnx");
  declare_label_output(arguments);
}

/// What of the options excludes another.
void refuse_mixtures(const Arguments& arguments) {
  if (arguments.has("network"))
    refuse_beside("network", arguments, {"seeds", "propose", "only", "region", "resolution"});
  if (arguments.has("correct"))
    refuse_beside("correct", arguments, {"network", "propose", "only", "region", "resolution"});
}

engine::Segment command_of(const Arguments& arguments) {
  engine::Segment command;
  command.options.working_spacing_mm = arguments.number("resolution", 0.3, 5.0);
  command.options.structures = structures_from(arguments.value("only"));
  command.options.region = region_from(arguments.value("region"));
  command.options.locked = locked_from(arguments.value("lock"));
  command.over_hand_work = over_hand_work(arguments);
  return command;
}

void say_modality(Modality modality, Session& session) {
  session.call("modality", "--modality");
  session.post(engine::SetModality{modality});
}

}  // namespace

int run_import(const QStringList& given) {
  Arguments arguments("import",
                      Cli::tr("Reads a CT or MRI (a folder of DICOM slices or its DICOMDIR, a .zip or "
                              ".tar.gz of one, NIfTI, NRRD, MetaImage) into a case, "
                              "which is made if there is none."));
  arguments.positional("INPUT", Cli::tr("The volume."));
  arguments.flag("list", Cli::tr("Only tell which DICOM series there are, the likeliest first."));
  arguments.option("series", Cli::tr("Which DICOM series, where there are several: its UID or number."),
                   "SERIES");
  arguments.option("modality", Cli::tr("ct or mr: what the volume is, where its file does not say."),
                   "MODALITY");
  declare_case(arguments);
  arguments.flag("replace", Cli::tr("The case is there already, and this is another image of its patient: it "
                                    "takes the former one's place; all else stays, marked out of date."));
  if (!arguments.parse(given)) return 0;
  const QString input = arguments.positionals(1, 1).front();
  if (arguments.has("list")) {
    arguments.refuse_idle(QStringLiteral("--list"), {"case", "series", "modality", "replace"});
    return tell_series(arguments, input.toStdString());
  }
  const fs::path folder = arguments.required_path("case");
  const auto modality = modality_from(arguments.value("modality"));
  Session session(arguments);
  open_case_if_there(arguments, session);
  if (!arguments.has("replace")) engine::require_no_patient(session.state(), folder);
  session.call("image", input.toStdString());
  session.post(
      engine::ImportImage{input.toStdString(), arguments.value("series").toStdString(), false, modality});
  save_case(arguments, session);
  session.finish();
  return 0;
}

int run_segment(const QStringList& given) {
  Arguments arguments(
      "segment", Cli::tr("Segments the liver, its vessels and lesions from seeds, or by your own network."));
  declare_segment(arguments);
  if (!arguments.parse(given)) return 0;
  const bool proposes = arguments.has("propose"), by_network = arguments.has("network");
  refuse_mixtures(arguments);
  const fs::path seeds = proposes || by_network ? arguments.path("seeds") : arguments.required_path("seeds");
  engine::Segment command = command_of(arguments);
  const auto modality = modality_from(arguments.value("modality"));
  const LabelOutput output(arguments);
  Session session(arguments);
  open_case(arguments, session);
  command.options.locked = engine::with_locks(std::move(command.options.locked), session.state());
  if (!seeds.empty()) session.call("seeds", seeds.string());
  if (modality) say_modality(*modality, session);
  if (by_network)
    session.post(
        engine::SegmentByNetwork{arguments.path("network"), command.options.locked, command.over_hand_work});
  else if (arguments.has("correct"))
    correct_by_seeds(session, seeds, command);
  else
    segment_by_seeds(session, command, seeds, proposes);
  if (session.state()[part::offer]) refuse_after_telling(session);
  output.finish(session);
  return 0;
}

}  // namespace glisson::app
