// SPDX-License-Identifier: GPL-3.0-or-later
// From the CT to the model: import, segment.
#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "glisson/engine/case_io.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

std::vector<std::uint8_t> truth_mask(const fs::path& path, const LabelCodes& codes, const VolumeGrid& grid) {
  const LabelFile file = read_labels(path);
  require_same_grid(file.voxels.grid(), grid, path.string());
  return inside_liver(codes.empty() ? LabelMap{file.voxels, file.infos} : recode(file, codes, path.string()));
}

}  // namespace

int run_import(const QStringList& given) {
  Arguments arguments(
      "import",
      Cli::tr("Reads a CT (a folder of DICOM slices, a .tar.gz of one, NIfTI, NRRD, MetaImage) into a case, "
              "which is made if there is none."));
  arguments.positional("INPUT", Cli::tr("The volume."));
  declare_case(arguments);
  if (!arguments.parse(given)) return 0;
  const QString input = arguments.positionals(1, 1).front();
  const fs::path folder = arguments.required_path("case");
  Session session(arguments);
  if (fs::exists(folder)) open_case(arguments, session);
  session.post(engine::ImportImage{input.toStdString()});
  save_case(arguments, session);
  session.finish();
  return 0;
}

int run_segment(const QStringList& given) {
  Arguments arguments("segment", Cli::tr("Segments the liver, its vessels and lesions from seeds."));
  declare_case(arguments);
  arguments.option("seeds", Cli::tr("What was clicked (JSON, LPS mm)."), "FILE");
  arguments.option("truth",
                   Cli::tr("Labels of an expert: adds the Dice coefficient. Read after everything else."),
                   "FILE");
  arguments.option("truth-codes", Cli::tr("What the expert's codes mean (JSON)."), "FILE");
  arguments.option("labels-out", Cli::tr("Also write the labels here (.seg.nrrd, .nii.gz)."), "FILE");
  if (!arguments.parse(given)) return 0;
  const fs::path seeds = arguments.required_path("seeds");
  if (arguments.has("labels-out")) arguments.output_file("labels-out", {".nrrd", ".nii.gz", ".nii", ".mha"});
  arguments.require_existing("truth");
  const LabelCodes truth_codes = codes_of(arguments, "truth-codes");
  Session session(arguments);
  open_case(arguments, session);
  session.post(engine::SetSeeds{segmentation::read_seeds(seeds)});
  session.post(engine::Segment{});
  const LabelMap& labels = *session.state().labels;
  if (arguments.has("truth"))
    session.figures["dice_liver"] = segmentation::dice(
        inside_liver(labels), truth_mask(arguments.path("truth"), truth_codes, labels.voxels.grid()));
  save_case(arguments, session);
  if (arguments.has("labels-out")) write_labels(arguments.path("labels-out"), labels.voxels, labels.infos);
  session.finish();
  return 0;
}

}  // namespace glisson::app
