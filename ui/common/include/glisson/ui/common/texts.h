// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/engine/obstacle.h"
#include "glisson/volume/label_volume.h"

namespace glisson::ui {

/// Words for the codes that the engine and the modules speak. A code that is not known is made readable.
QString command_text(std::string_view code);
QString stage_text(std::string_view code);
/// A note or a doubt: a code and its values, "vessels.pieces portal_vein 2", as a sentence.
QString note_text(std::string_view note);
/// The same of several, a line each.
QString notes_text(const std::vector<std::string>& notes);
/// A code without a word of its own: "mesh.refine_edges" -> "Mesh: refine edges".
QString readable_code(std::string_view code);
QString structure_text(Label label);
QString stage_state_text(engine::StageState state);
/// What stands in the way of a command, and what to do first; empty where nothing does.
QString obstacle_text(const std::optional<engine::Obstacle>& obstacle);

}  // namespace glisson::ui
