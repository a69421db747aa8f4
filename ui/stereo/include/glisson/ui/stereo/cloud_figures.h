// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "glisson/engine/case_state.h"

namespace glisson::ui {

/// What is known of the case's cloud, wherever it came from, for people: names and values.
std::vector<std::pair<QString, QString>> cloud_figures(const engine::CaseState& state);
/// What a person should know before registering to it; empty: nothing.
QString cloud_warning(const engine::CaseState& state);

}  // namespace glisson::ui
