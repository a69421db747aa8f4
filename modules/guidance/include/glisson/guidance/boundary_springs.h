// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/patient_model.h"

namespace glisson::guidance {

/// The boundary conditions of the temporal registration (paper, 2.2.3): the vena cava and the entrances of
/// the vessel trees, springs of k = E A / L between a place of the model and where the registration put it.
class BoundarySprings {
 public:
  /// @param start_in_camera nodes where the registration put them.
  /// @param young_modulus of the structures, Pa; 0: no springs. @param length of what holds, metres.
  /// @param tether N/m a structure, of what it hangs on.
  BoundarySprings(const PatientModel& model, const Points& start_in_camera, double young_modulus,
                  double length, double tether);

  /// The camera has moved: what holds the organ is elsewhere in its frame.
  void move(const RigidMotion& motion);
  /// The model was put elsewhere in what holds it: each spring's place goes along with the nodes' motions
  /// (metres).
  void shift(const Points& motions_in_camera);
  void add(const Points& nodes_in_camera, std::vector<fem::AttachedLoad>& loads) const;
  int count() const { return static_cast<int>(springs_.size()); }

 private:
  struct Spring {
    std::array<int, 4> nodes;
    std::array<double, 4> weights;
    double stiffness;
    Eigen::Vector3d anchor;
  };
  void attach(const PatientModel& model, const Points& places_in_ct, const std::vector<double>& stiffness,
              const Points& start_in_camera);

  std::vector<Spring> springs_;
};

}  // namespace glisson::guidance
