// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/fem/tissue.h"
#include "glisson/model/build.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// The registration that the present one has replaced, and what it was made from: where all of that is as it
/// was, it can be had back.
struct FormerRegistration {
  std::shared_ptr<const Registration> registration;
  std::shared_ptr<const model::BuiltModel> model;
  std::shared_ptr<const Landmarks> landmarks;
  std::shared_ptr<const fem::Tissue> tissue;
  std::shared_ptr<const LabelledCloud> cloud;
  std::shared_ptr<const EarlierLooks> looks;
};

namespace part {
extern const PartOf<FormerRegistration> former_registration;
}  // namespace part

/// Whether there is one of the case as it is now.
bool has_former_registration(const CaseState& state);
/// For whoever writes another registration: `made` gets the one of `before` as its former one, or none where
/// that was out of date or not there.
void keep_former_registration(CaseState& made, const CaseState& before);
/// Parts that keep_former_registration() reads besides the registration itself.
Parts inputs_of_former_registration();

}  // namespace glisson::engine
