// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QHash>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

QString to_q(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Context of these sentences for translators.
class Obstacles {
  Q_DECLARE_TR_FUNCTIONS(Obstacles)
 public:
  /// What to do first, by the part that is not there.
  static QHash<QString, QString> missing() {
    return {{"image", tr("Open a CT first.")},
            {"seeds", tr("Place at least one seed in the liver.")},
            {"labels", tr("Segment the CT or import labels first.")},
            {"offer", tr("No new segmentation waits for a decision.")},
            {"model", tr("Build a model first.")},
            {"landmarks", tr("Place or accept the landmarks first.")},
            {"proposals", tr("Let the atlas propose the landmarks first.")},
            {"rig", tr("Load the laparoscope's calibration first.")},
            {"video", tr("The case has no stereo video (Stereo, Video…).")},
            {"named_video", tr("The case names no pictures that nobody here has chosen.")},
            {"frame", tr("Load a stereo pair or a video frame first.")},
            {"regions", tr("Draw regions on the frame first (Stereo).")},
            {"check", tr("Look at the model and say whether it is right first (Model).")},
            {"source", tr("The CT was not opened from its DICOM folder, so whose it is is not known.")},
            {"review", tr("Review the labels first (Segmentation).")},
            {"locks", tr("Nothing is locked (Segmentation).")},
            {"cloud", tr("Reconstruct the surface first (Stereo).")},
            {"earlier_looks", tr("No earlier look is kept (Stereo).")},
            {"moments", tr("No moment of the live view is kept (Guidance).")},
            {"former_registration", tr("There is no former registration to go back to.")},
            {"tissue", tr("Nobody has said how stiff the liver is (Model).")},
            {"operations", tr("No operations have been simulated on this model: register it.")},
            {"registration", tr("Register first.")}};
  }
  /// The same for one that is out of date.
  static QHash<QString, QString> stale() {
    return {
        {"seeds", tr("The seeds are those of another CT: place them again (Segmentation).")},
        {"labels", tr("The labels are out of date: segment or import them again (Segmentation).")},
        {"model", tr("The model is out of date: build it again (Model).")},
        {"check", tr("The model is another one than was checked: look at it again (Model).")},
        {"landmarks",
         tr("The landmarks are those of another model: look at them and accept them (Landmarks).")},
        {"proposals",
         tr("The proposed landmarks are those of another model: let the atlas propose them again.")},
        {"frame", tr("The frame is of a former video: take one of the present video (Stereo).")},
        {"regions", tr("The regions are those of another frame: draw them again or clear them (Stereo).")},
        {"cloud", tr("The points are out of date: reconstruct the surface again (Stereo).")},
        {"registration", tr("The registration is out of date: register again.")}};
  }
  /// The same for one that stands refused.
  static QHash<QString, QString> refused() {
    return {{"registration",
             tr("The registration was refused: register again, or use it nevertheless (see its doubts).")}};
  }
  static QString followed() {
    return tr("The organ is followed from the place it has now: stop tracking first.");
  }
  /// A part that came after these sentences.
  static QString other_missing() { return tr("There is no %1 yet."); }
  static QString other_stale() { return tr("%1 is out of date: make it anew."); }
  static QString other_refused() { return tr("%1 was refused: make it anew, or accept it."); }
};

}  // namespace

QString obstacle_text(const std::optional<engine::Obstacle>& obstacle) {
  if (!obstacle) return {};
  const QString part = to_q(obstacle->part.code());
  if (obstacle->kind == engine::Obstacle::Kind::missing)
    return Obstacles::missing().value(part, Obstacles::other_missing().arg(part));
  if (obstacle->kind == engine::Obstacle::Kind::refused)
    return Obstacles::refused().value(part, Obstacles::other_refused().arg(part));
  if (obstacle->kind == engine::Obstacle::Kind::followed) return Obstacles::followed();
  return Obstacles::stale().value(part, Obstacles::other_stale().arg(part));
}

}  // namespace glisson::ui
