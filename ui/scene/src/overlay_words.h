// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "glisson/patient/label_map.h"
#include "glisson/patient/registration.h"

namespace glisson::scene {

/// Context of the words on the picture for translators.
class Overlay {
  Q_DECLARE_TR_FUNCTIONS(Overlay)
 public:
  static QString reason(Validity validity) {
    switch (validity) {
      case Validity::valid:
        return tr("registered");
      case Validity::not_started:
        return tr("not registered yet");
      case Validity::too_few_points:
        return tr("too few points are tracked");
      case Validity::inconsistent_motion:
        return tr("the tracked points contradict one another");
      case Validity::residual_too_large:
        return tr("the model does not fit what the camera sees");
      case Validity::mechanics_failed:
        return tr("the mechanical computation failed");
      case Validity::stale:
        return tr("an earlier step has changed since the registration");
      case Validity::surface_apart:
        return tr("the camera sees the organ elsewhere");
      case Validity::picture_stands:
        return tr("the picture stands still");
      case Validity::views_apart:
        return tr("the two views do not fit together");
      case Validity::partly_covered:
        return tr("part of the organ is covered");
      case Validity::poor_picture:
        return tr("the picture has lost light or contrast");
      case Validity::picture_still:
        return tr("nothing in the picture moves");
      case Validity::proposed:
        return tr("only proposed, not registered");
      case Validity::mostly_masked:
        return tr("the mask network takes most of the organ for something else");
      case Validity::masked_out:
        return tr("the mask network leaves too little of the organ");
      case Validity::view_lost:
        return tr("one of the two views shows nothing, or too little");
      case Validity::views_swapped:
        return tr("left and right view seem to be swapped");
      case Validity::picture_lost:
        return tr("too little can be made out in the picture");
    }
    return {};
  }
  /// What a person does about it; empty: nothing.
  static QString remedy(Validity validity) {
    switch (validity) {
      case Validity::valid:
        return {};
      case Validity::not_started:
        return tr("Register the model to what the camera sees.");
      case Validity::too_few_points:
        return tr(
            "Show the part of the organ that was seen when it was registered, free of smoke and tools.");
      case Validity::inconsistent_motion:
        return tr(
            "Show the part of the organ that was seen when it was registered, and hold still for a moment.");
      case Validity::residual_too_large:
        return tr("Register again (R), or choose a new frame and register that.");
      case Validity::mechanics_failed:
        return tr("Start tracking again.");
      case Validity::stale:
        return tr("Run the steps again that are out of date, then register.");
      case Validity::surface_apart:
        return tr("Register again (R), or correct by hand (C).");
      case Validity::picture_stands:
        return tr("Check the camera and its cable.");
      case Validity::picture_still:
        return tr("Move the laparoscope a little, or wait for a breath.");
      case Validity::views_apart:
        return tr(
            "Check that both cameras run, in the right order, at the same time, and as they were "
            "calibrated.");
      case Validity::partly_covered:
        return tr("Take away what covers it, or show another part of the organ.");
      case Validity::poor_picture:
        return tr("Clear the smoke, wipe the lens, check the lamp.");
      case Validity::proposed:
        return tr("Use this place, refine it, or put it back.");
      case Validity::view_lost:
        return tr("Wipe the lens of that view; check its camera and cable.");
      case Validity::views_swapped:
        return tr("Check that the two cameras, or their videos, are in the right order.");
      case Validity::picture_lost:
        return tr("Clear the smoke, wipe the lens, check lamp and focus.");
      case Validity::mostly_masked:
      case Validity::masked_out:
        return tr("Show more of the organ; if the network is wrong, remove it.");
    }
    return {};
  }
  static QString limit(Validity validity) {
    if (validity == Validity::proposed) return tr("Outline and margin: %1").arg(reason(validity));
    const bool withdrawn = level_of(validity) == Level::withdrawn;
    return (withdrawn ? tr("No overlay: %1") : tr("Outline and lesions' regions only: %1"))
        .arg(reason(validity));
  }
  static QString refused() { return tr("No overlay: %1").arg(reason(LesionReason::refused_start)); }
  static QString remedy_of_refused() {
    return tr("Read its doubts, on the right; then register again, or use it nevertheless.");
  }
  static QString reason(LesionReason reason) {
    switch (reason) {
      case LesionReason::known:
        return tr("known well enough");
      case LesionReason::with_the_whole:
        return tr("as the whole overlay");
      case LesionReason::error_unknown:
        return tr("how far off it may be is not known; register again");
      case LesionReason::refused_start:
        return tr("the registration was refused");
      case LesionReason::start_uncertain:
        return tr("the registration does not know it better");
      case LesionReason::far_from_points:
        return tr("the organ has changed its shape, and what is tracked lies far away");
      case LesionReason::long_unseen:
        return tr("nothing near it has been tracked for a while");
    }
    return {};
  }
  static QString lesion(Label label) { return tr("Lesion %1").arg(label - structure::kFirstLesion + 1); }
  static QString reach(double metres) { return tr("±%1 mm").arg(1e3 * metres, 0, 'f', 0); }
  static QString contours() { return tr("Lines: every 10 mm below the surface"); }
  static QString length(double metres) { return tr("%1 mm").arg(1e3 * metres, 0, 'f', 0); }
  static QString along_sight() { return tr("Depth along the sight"); }
  static QString shortest() { return tr("Depth, shortest way"); }
  static QString expected() { return tr("Expected error"); }
  static QString within() { return tr("95 % within"); }
  static QString from_place() { return tr("From the mark"); }
  static QString state(Level level) {
    switch (level) {
      case Level::valid:
        return tr("valid");
      case Level::degraded:
        return tr("known roughly");
      case Level::withdrawn:
        return tr("not known");
    }
    return {};
  }
  /// Why a lesion is not drawn as a body.
  static QString limit(const LesionVerdict& verdict) {
    return (verdict.level == Level::withdrawn ? tr("%1 not shown: %2") : tr("%1 as its region only: %2"))
        .arg(lesion(verdict.lesion), reason(verdict.reason));
  }
  static QString more(int lesions) { return tr("Other lesions not known well enough: %1").arg(lesions); }
  static QString not_live() { return tr("NOT LIVE"); }
  static QString proposed() { return tr("PROPOSED"); }
  static QString level(Level level) {
    switch (level) {
      case Level::valid:
        return tr("VALID");
      case Level::degraded:
        return tr("DEGRADED");
      case Level::withdrawn:
        return tr("WITHDRAWN");
    }
    return {};
  }
  static QString frame(int index) { return tr("frame %1").arg(index); }
  static QString age(double seconds) { return tr("age %1 ms").arg(qRound(1e3 * seconds)); }
  static QString rate(double per_second) { return tr("%1 fps").arg(per_second, 0, 'f', 1); }
  static QString residual(double metres) { return tr("residual %1 mm").arg(1e3 * metres, 0, 'f', 1); }
  static QString doubtful() { return tr("Registration in doubt"); }
  static QString unchecked() { return tr("Model not checked"); }
  static QString landmarks_open() { return tr("Landmarks not reviewed"); }
  static QString landmarks_from_statistics() { return tr("Landmarks from statistics"); }
  static QString research() { return tr("Research software: not for clinical use"); }
  static QString structure(Label label) {
    if (label == structure::kPortalVein) return tr("Portal vein");
    if (label == structure::kHepaticVeins) return tr("Hepatic veins");
    if (label == structure::kArtery) return tr("Hepatic artery");
    return tr("Lesion");
  }
};

}  // namespace glisson::scene
