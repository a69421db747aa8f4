// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <memory>
#include <vector>

#include "glisson/patient/registration.h"
#include "glisson/ui/scene/drawable_model.h"

class vtkRenderer;

namespace glisson::scene {

/// From here on an expected error has the scale's last colour, metres.
inline constexpr double kMostErrorShown = 15e-3;
/// Colour of an expected error, metres: the scale goes evenly from dark blue to yellow and is the same for
/// all patients (cividis, Nunez 2018: made for all kinds of colour vision).
QColor error_colour(double error);

/// Errors that the scale's first and last colour stand for, metres.
struct ErrorRange {
  double low = 0.0, high = kMostErrorShown;
  bool operator==(const ErrorRange&) const = default;
};
/// From what the best look leaves to what is expected without one: else all places look alike.
ErrorRange look_range(const LesionLooks& looks);

/// A registered organ as VTK actors in a renderer whose frame is the camera's: the liver's surface in the
/// colours of the error that is expected there, the 95 % region of each lesion, forces as arrows on the
/// surface, and another place where the organ may be as a wire frame. Not thread-safe.
class RegistrationActors {
 public:
  /// @param renderer is kept.
  explicit RegistrationActors(vtkRenderer& renderer);
  ~RegistrationActors();
  RegistrationActors(const RegistrationActors&) = delete;
  RegistrationActors& operator=(const RegistrationActors&) = delete;

  /// Which of the registration's are shown besides; -1: none.
  struct Chosen {
    int rival = -1;
    int look = -1;  ///< colours (look_range) tell what it would leave, a ball marks the best place
    /// False: it is out of date or refused, so that nothing it says of errors holds. The liver is grey, and
    /// neither regions nor looks are shown.
    bool holds = true;
  };
  /// Replaces what is shown. @param lesions centres and covariances in the camera's frame.
  /// Where no error is known the liver is grey. @pre the nodes are those of the model.
  void show(const DrawableModel& model, const Registration& registration,
            const std::vector<LesionVerdict>& lesions, const Chosen& chosen);
  void clear();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::scene
