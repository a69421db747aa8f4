// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_output.h"

#include "case_argument.h"
#include "glisson/engine/label_export.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/segmentation/evaluate.h"

namespace glisson::app {

void declare_label_output(Arguments& arguments) {
  arguments.option(
      "truth", Cli::tr("Labels of an expert: adds Dice coefficients. Read after everything else."), "FILE");
  arguments.option("truth-codes", Cli::tr("What the expert's codes mean (JSON)."), "FILE");
  arguments.option("labels-out",
                   Cli::tr("Also write the labels here (.seg.nrrd, .nii.gz; .dcm: DICOM segmentation)."),
                   "FILE");
}

LabelOutput::LabelOutput(const Arguments& arguments) : arguments_(arguments) {
  if (arguments.has("labels-out"))
    arguments.output_file("labels-out", {".nrrd", ".nii.gz", ".nii", ".mha", ".dcm"});
  arguments.require_existing("truth");
  truth_codes_ = codes_of(arguments, "truth-codes");
}

void LabelOutput::compare(Session& session) const {
  const LabelMap& labels = *session.state()[part::labels];
  const std::filesystem::path path = arguments_.path("truth");
  const LabelFile file = read_labels(path);
  require_same_grid(file.voxels.grid(), labels.voxels.grid(), path.string());
  session.figures.merge(
      segmentation::compare_labels(labels, truth_codes_.empty() ? LabelMap{file.voxels, file.infos}
                                                                : recode(file, truth_codes_, path.string())));
}

void LabelOutput::finish(Session& session) const {
  save_case(arguments_, session);
  if (arguments_.has("labels-out"))
    session.attempt([&] { engine::write_case_labels(arguments_.path("labels-out"), session.state()); });
  if (arguments_.has("truth")) session.attempt([&] { compare(session); });
  session.finish();
}

}  // namespace glisson::app
