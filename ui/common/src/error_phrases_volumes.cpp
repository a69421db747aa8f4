// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of what stands in files of volumes.
#include <QtGlobal>

#include "error_phrases.h"

namespace glisson::ui {

const std::vector<const char*>& volume_problems() {
  static const std::vector<const char*> kPhrases = {
      QT_TRANSLATE_NOOP("ErrorPhrases", "are no regular stack: %1 lies %2 mm from its place"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds no slice"),
      QT_TRANSLATE_NOOP("ErrorPhrases",
                        "holds no file: %1 is a pipe, a socket, a device or a link to no file"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is an archive, not a file of labels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are shifted against each other across their normal"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "of one segment lie twice in one slice"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "claims more pixels than a segmentation can mean"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "differ in orientation or pixel spacing"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "do not lie at equal steps along their normal"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "does not hold one item a frame"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "ends early: the file was cut"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds %1 bytes where %2 are expected: the file is damaged"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds more segments than it can"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is \"%1\", of which the border is not known"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1 twice"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no segment of the file"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which no segmentation of bits has"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is missing in a file of one slice"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is missing in a frame"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is missing in a frame, so that its place in the patient is unknown"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is missing or no number"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says that it is a label map segmentation, which is not read"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says that it is no segmentation but another DICOM object"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says that the bits are compressed or swapped"),
      QT_TRANSLATE_NOOP("ErrorPhrases",
                        "claims more than 8192 pixels a side, which no scanner's slices have"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds no series %1, but %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds several series %1, but %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "names another patient (0010|0010, 0010|0020, 0010|0030) than %1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has rows that are not of length 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, beyond what the file holds"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is False: voxels as text are not read"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is not 0"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is not 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "names no single file of voxels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are no scale of intensities"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has an origin that is not finite"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1 where the datatype says %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no number of voxels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is neither 1 nor -1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is no place in the file behind its header"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is no rotation: b, c and d are longer than 1 together"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is no unit of length"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says %1 mm from voxel to voxel, and the sform %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says metres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "says micrometres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are \"%1\""),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are fewer than there are axes"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are of fewer than three axes in space"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are of more than three axes in space"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "hold a bracket that is not closed"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "holds \"%1\", which is no vector"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is \"%1\", which is no patient's"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is missing: the file does not say which way the patient lies"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is more than 16"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is not read here"),
      QT_TRANSLATE_NOOP(
          "ErrorPhrases",
          "are %1 mm apart between %2 and %3 and %4 mm elsewhere: a slice is missing or the spacing changes"),
      QT_TRANSLATE_NOOP(
          "ErrorPhrases",
          "are shifted against each other by %1 mm from the first to the last (gantry tilt of %2 degrees)"),
  };
  return kPhrases;
}

const std::vector<const char*>& volume_remedies() {
  static const std::vector<const char*> kPhrases = {
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose another series"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Unpack it yourself and name the file of labels in it"),
      QT_TRANSLATE_NOOP(
          "ErrorPhrases",
          "Give labels as .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti or a DICOM segmentation"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Export it as a binary DICOM segmentation"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Export it without compression (Explicit VR Little Endian)"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Export the segmentation again"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Name a DICOM segmentation"),
      QT_TRANSLATE_NOOP("ErrorPhrases",
                        "Name a DICOM segmentation (modality SEG); of a CT open the folder of its slices"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Resample the segmentation to the CT's grid"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Export the series again, of one patient"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Export the volume again, as one .mha file"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Apply it to the voxels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Correct it to 0"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write it with BinaryData = True"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Set them to 1 and 0"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write it as left-posterior-superior with space directions in mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write it with the encoding gzip or raw"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write the data without bytes before them"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write the data without lines before them"),
  };
  return kPhrases;
}

}  // namespace glisson::ui
