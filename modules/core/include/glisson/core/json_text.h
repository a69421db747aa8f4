// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace glisson {

/// What a text of JSON says; files are read so, too (json_file.h). Of a name that stands twice in one object
/// the library keeps the last, without a word: here it is refused.
/// @param name of the text, for messages.
/// @throws InputError a name stands twice, or lists nest more than 64 deep; nlohmann::json::exception
/// malformed.
nlohmann::json parse_json(std::string_view text, const std::string& name);

}  // namespace glisson
