// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/core/units.h"
#include "glisson/engine/script.h"
#include "glisson/insilico/operator.h"
#include "glisson/insilico/patient.h"
#include "glisson/insilico/theatre.h"

/// @file
/// The main job from end to end: a patient's CT, or surfaces, or a case, becomes a model; the theatre deforms
/// and films that patient; the stages see its pictures only; the truth is compared at the end.

namespace glisson::experiments {

/// Whose liver, filmed how.
struct DemoOptions {
  /// Empty: the synthetic patient. Else a case, a label map, or surfaces (a folder by structure, or one
  /// file).
  std::filesystem::path patient;
  LengthUnit unit = LengthUnit::millimetre;  ///< of surfaces
  LabelCodes codes;                          ///< of a foreign label map
  int vertices = 550;                        ///< of the registration's mesh, 50 to 200,000
  double patch_share = 0.3;                  ///< of the surface, in (0, 1]: the paper's protocol
  insilico::PatientOptions synthetic;
  insilico::TheatreOptions theatre;
  insilico::ScopePath scope = insilico::ScopePath::in_a_hand();  ///< how the laparoscope moves
  insilico::OperatorOptions clicks;
  /// The registration is put off by so much before it is followed, metres, left camera's frame.
  Eigen::Vector3d start_off = Eigen::Vector3d::Zero();
  double register_again = 0.0;  ///< seconds; zero: never

  /// @throws InputError naming the option.
  void validate() const;
};

/// How results are drawn; the experiment knows no renderer. Any may be absent.
struct DemoPictures {
  /// A frame of the left camera with its overlay.
  std::function<Picture(const engine::CaseState&, const StereoFrame&, const OverlayFrame&)> overlay;
  /// The axial slice of the CT through the liver's middle, with labels.
  std::function<Picture(const engine::CaseState&)> slice;
  /// The model in three dimensions.
  std::function<Picture(const engine::CaseState&)> model;
  /// The organ's outline alone, as the overlay draws it into a left picture, on black ground.
  std::function<Picture(const engine::CaseState&, const OverlayFrame&)> outline;
};

/// What a demo measured, and where its main files are.
struct DemoResult {
  Figures figures;                 ///< flat, units in the names; see the module's README
  std::vector<std::string> notes;  ///< doubts of the stages
  std::filesystem::path case_folder, overlay_video, report;
};

/// Fills `folder` (which exists and is empty) with the case, what the operator clicked, the theatre's film
/// and truth, the overlay video and report.html. Empty when cancelled. @throws Error of any stage.
Cancellable<DemoResult> run_demo(const DemoOptions& options, const std::filesystem::path& folder,
                                 const DemoPictures& pictures, const RunContext& context);

}  // namespace glisson::experiments
