// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of edits, options and settings.
#include <QtGlobal>

#include "error_phrases.h"

namespace glisson::ui {

// NOLINTBEGIN(bugprone-suspicious-missing-comma): few phrases are longer than a line

const std::vector<const char*>& setting_problems() {
  static const std::vector<const char*> kPhrases = {
      QT_TRANSLATE_NOOP("ErrorPhrases", "is not %1 x %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no number"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no small whole number"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no structure"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is no text"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is no field that is known here"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is not made of %1 numbers each"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has a point that is nowhere near a patient"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1, which is locked"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is the background"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "runs from %1 to %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are fewer than two with the rivals"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "are none that may keep what they win"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "name %1, which is no structure"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is the label that the branch has"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has fewer than three points"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has fewer than two points"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has a normal that is not of length 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has a place that is not finite"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has an offset that is not finite"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1 thick"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "shows no view of space"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1 with a high of %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "has the same place twice (%1 and %2)"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is below 0.5 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "leaves %1 between %2 and %3, more than 100 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "both places lie on one tree: a join would close a loop"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "lies %1 mm from the nearest vessel"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "one place lies on the %1, the other on the %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "the places lie %1 mm apart"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "there is no vessel tree"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "\"%1\" is not known"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "%1 has %2 markers, too few for this board"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "is %1 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases",
                        "matches itself but not the calibration (its points lie %1 pixels from their "
                        "epipolar lines, %2 % of them before the cameras): the calibration is of another "
                        "laparoscope, or of another zoom or focus"),
  };
  return kPhrases;
}

const std::vector<const char*>& setting_remedies() {
  static const std::vector<const char*> kPhrases = {
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give at least one"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write three lists of four numbers"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Remove it, or correct its name"),
      QT_TRANSLATE_NOOP("ErrorPhrases",
                        "Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, "
                        "gallbladder, lesion_1, other_1 and so on"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write a name in quotes"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write a whole number"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write it in square brackets"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write lists of numbers"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Write true or false"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose 0, 1 or 2: the voxel axis across the slice"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose 1 to %1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose 1 and more: over what is usual"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose a low that is not above the high"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose a structure"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose more than 0 and at most %1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give points of the CT's frame"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Unlock it, or choose another one"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose labels that compete"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose one or more to grow"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose structures that have voxels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose at least a slice's thickness"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Draw around an area"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Draw it in the view"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give metres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give the 3 x 4 matrix of the view"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Normalise it"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Choose 0.5 to 8 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Click points between them"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give the two ends of the gap"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Join trees of one kind"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Point at a vessel of the model"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Point at places within 60 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Point at two different trees"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "A marker is smaller than its square"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Check the board's size and dictionary"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Count the inner corners: from 3 to 50 a side"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give OpenCV's name, such as DICT_4X4_50"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Measure the side of a square: up to 200 mm"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a number between -1 and 0.5"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give numbers between -1 and 0.5"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a relative residual between 0 and 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give positive lengths in metres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give positive numbers"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a positive length in metres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a positive number"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a positive number of pixels"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a positive number of seconds"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a positive number up to %1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a number from zero"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a number from %1 to %2"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a length from zero, in metres"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a share above 0, at most 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a share from 0 to 1"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give a share up to that of `fresh`"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give an odd number from 5"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give less than lies between two checks"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give more than one"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give the margin at least"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give %1 or more"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give the server's port, as 18944"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give up to 100"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give up to 60 seconds"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give up to a second"),
      QT_TRANSLATE_NOOP("ErrorPhrases", "Give up to a second; 0 is half a frame"),
  };
  return kPhrases;
}

// NOLINTEND(bugprone-suspicious-missing-comma)

}  // namespace glisson::ui
