// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/other_registration.h"

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/tissue.h"

namespace glisson::engine {

const PartOf<OtherRegistration> part::other_registration{
    {.code = "other_registration",
     .made_of = {part::model, part::landmarks, part::tissue, part::cloud, part::registration},
     .remedy = "Register again while the organ is followed",
     .is_input = false}};

}  // namespace glisson::engine
