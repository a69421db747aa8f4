// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/openigtlink/sender.h"
#include "glisson/ui/scene/drawable_model.h"

namespace glisson::scene {

/// The surfaces that are drawn over the laparoscope's picture, to be sent: light, and only where it is known
/// how they move. Those without a binding are left out.
std::shared_ptr<const openigtlink::SentModel> sent_model(const DrawableModel& drawable);

}  // namespace glisson::scene
