// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "glisson/insilico/handled_liver.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/examined_registration.h"
#include "registration_patients.h"

namespace glisson::experiments {

/// So many of insilico::kHandlings, the first ones, are tried with every share of the surface and with every
/// fault; the others with the share of the faults alone.
inline constexpr std::size_t kMuchTriedHandlings = 4;
/// That share.
inline constexpr double kFaultShare = 0.3;
/// Whether a handling (its code) is one of the first.
bool is_much_tried(const std::string& handling);

/// A patient, handled in many ways, before a camera.
struct RegistrationStage {
  ProofPatient patient;
  PatientModel model;  ///< that is registered; notch and vena cava as a person clicked them
  Landmarks found;     ///< what the model shows by itself, before anybody clicked; CT frame
  std::vector<insilico::HandledLiver> handled;  ///< in the order of insilico::kHandlings, the first ones
  Points lesions;  ///< three places deep in the liver and far from each other, CT frame

  const insilico::HandledLiver& by(std::size_t handling) const { return handled[handling]; }
  /// What the model calls the k-th of `lesions`; the patient's own come before.
  static Label lesion_label(Eigen::Index k) { return static_cast<Label>(structure::kFirstLesion + 100 + k); }
};

/// Registers a stage's model to one cloud after another; its operations are simulated once.
class StageRegistrar {
 public:
  StageRegistrar(const RegistrationStage& stage, const RunContext& context)
      : stage_(stage), context_(context) {}
  /// @throws as register_model.
  Cancellable<registration::ExaminedRegistration> run(const LabelledCloud& cloud,
                                                      const registration::RegisterOptions& options = {});

 private:
  const RegistrationStage& stage_;
  RunContext context_;
  registration::KnownOperations known_;
};
/// @param handlings how many of insilico::kHandlings. @throws Error. Empty: cancelled.
Cancellable<RegistrationStage> build_stage(const ProofPatient& patient, const std::filesystem::path& data,
                                           std::uint64_t seed, std::size_t handlings,
                                           const RunContext& context);

/// What is wrong with a cloud, or with where the registration starts.
enum class RegistrationFault {
  none,
  noise,
  another_patient,
  mirrored,
  foreign_organ,
  wrong_labels,
  wrong_start,
  larger,  ///< by a fifth: by a calibration whose cameras stand too far apart
  smaller  ///< by a sixth
};
inline constexpr RegistrationFault kRegistrationFaults[] = {
    RegistrationFault::none,        RegistrationFault::noise,         RegistrationFault::another_patient,
    RegistrationFault::mirrored,    RegistrationFault::foreign_organ, RegistrationFault::wrong_labels,
    RegistrationFault::wrong_start, RegistrationFault::larger,        RegistrationFault::smaller};
const char* registration_fault_code(RegistrationFault fault);
/// Whether the cloud shows this patient's liver at all: otherwise any registration is wrong.
bool shows_the_organ(RegistrationFault fault);

/// A cloud with the fault in it. @param other another patient's stage.
LabelledCloud faulty_cloud(const RegistrationStage& stage, const RegistrationStage& other,
                           std::size_t handling, double share, RegistrationFault fault, std::uint64_t seed);
/// The same handled liver after the laparoscope has gone round its middle by 35 degrees, rolled and shifted:
/// in its new camera's frame, with noise, outliers and holes of its own.
LabelledCloud look_from_elsewhere(const RegistrationStage& stage, std::size_t handling, double share,
                                  std::uint64_t seed);
/// A liver of which nothing is wrong, as one look shows it, or several, of which nobody knows from where.
struct ShownLiver {
  LabelledCloud cloud;
  std::vector<LabelledCloud> others;  ///< each in its own camera's frame
};
/// Up to two fifths of the surface are one look's; more than that no camera sees at once, and the laparoscope
/// goes round the organ's middle by 35 degrees, to all four sides.
ShownLiver shown_liver(const RegistrationStage& stage, std::size_t handling, double share,
                       std::uint64_t seed);
/// Where the liver would be looked for by somebody who mistook it: 35 mm and 40 degrees off.
CameraFromCt mistaken(const RegistrationStage& stage, std::size_t handling);

}  // namespace glisson::experiments
