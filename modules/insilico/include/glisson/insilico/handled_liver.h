// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/insilico/theatre.h"
#include "glisson/patient/patient_model.h"

namespace glisson::insilico {

/// What is done to the liver. None of it is what `registration` simulates beforehand.
enum class Handling {
  lifted,   ///< a tool takes a lobe by its margin and lifts it off the bed
  pressed,  ///< a broad retractor presses the front
  turned,   ///< the patient lies on the left side
  pulled,   ///< one to three places anywhere are pulled or pressed, askew
  /// Falciform and triangular ligaments and the bare area are cut: the liver hangs on its vena cava alone and
  /// sags to the left.
  loosened,
  inflated,   ///< gas presses all that does not lie on the bed, and carries the diaphragm up
  stiffened,  ///< its tissue differs from place to place, with a hard tumour in it; lifted by a tool
  swollen,    ///< larger by 6 to 14 % of its volume, and pulled at two places
  resected,   ///< a piece with a part of the margin is gone, and the rest is pulled at two places
  emptied     ///< gas has pressed 5 to 19 % of its volume out of it, and presses as on an inflated one
};
inline constexpr Handling kHandlings[] = {
    Handling::lifted,   Handling::pressed,   Handling::turned,  Handling::pulled,   Handling::loosened,
    Handling::inflated, Handling::stiffened, Handling::swollen, Handling::resected, Handling::emptied};
/// "lifted", "pressed", ...: as in the code.
const char* handling_code(Handling handling);

/// What is done to the liver, and how far it goes.
struct HandlingOptions {
  std::uint64_t seed = 1;
  Handling handling = Handling::lifted;
  int truth_vertices = 1200;       ///< of the truth's own mesh
  double elastic_motion_mm = 6.0;  ///< of its nodes on average, after the best rigid alignment, at most
  double surface_error_mm = 1.0;   ///< deviation of the true surface from the patient's, smooth over 15 mm
  double camera_distance_mm = 130.0;
  /// @throws InputError naming the option.
  void validate() const;
};

/// A patient's liver handled by somebody, before a camera: a truth for registration whose boundary laws,
/// faces and numbers are its own. Neo-Hookean on a mesh of its own, fixed around the vena cava, hung up at
/// the bare area, on a bed that only presses; tools hold tissue by stiff springs and are moved until the
/// organ is bent as far as is wanted. A resected piece is gone for the camera alone; the rest bends as if it
/// were there. The same patient and options give the same bits. Thread-safe.
class HandledLiver {
 public:
  /// @param patient surfaces (liver required) and landmarks as Theatre::build takes them, CT frame.
  /// @throws InputError options, no closed liver; NumericalError no equilibrium under the tools.
  static Cancellable<HandledLiver> build(const PatientModel& patient, const HandlingOptions& options,
                                         const RunContext& context);
  ~HandledLiver();
  HandledLiver(HandledLiver&&) noexcept;
  HandledLiver& operator=(HandledLiver&&) noexcept;

  /// Metres: mean over the truth's nodes, after the best rigid alignment; and the largest.
  double elastic_motion() const;
  double largest_motion() const;
  const CameraFromCt& camera_from_ct() const;  ///< where the camera stands
  const Landmarks& landmarks() const;          ///< the patient's, completed; CT frame
  /// Where points of the CT's liver are before the camera, metres.
  PointsIn<CameraFrame> carry(const PointsIn<CtFrame>& points) const;
  /// A patch of the true surface around what the camera looks at, as Theatre::patch. Without normals: who has
  /// a noisy cloud has no clean ones. @throws InputError options.
  /// @param scope how the laparoscope has moved before: from the camera's former frame into its present one,
  /// in which the patch is given.
  Patch patch(const PatchOptions& options, const Rigid<CameraFrame, CameraFrame>& scope = {}) const;
  /// The same of a laparoscope that goes round: a patch of what it sees from anywhere on its way, from the
  /// first place first, and what it sees of that from each. What it never sees is left out: it may be less
  /// than is wanted.
  /// @param scopes where it is, as for patch(); the first of them where it stands. @return a cloud for each
  /// place, in that place's camera frame; empty where it adds less than a hundredth of the surface.
  std::vector<Patch> looks(const PatchOptions& options,
                           const std::vector<Rigid<CameraFrame, CameraFrame>>& scopes) const;

 private:
  struct Impl;
  explicit HandledLiver(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::insilico
