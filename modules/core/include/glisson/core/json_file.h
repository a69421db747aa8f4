// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace glisson {

/// Many times what any list needs. What is made of a file takes up to twenty times its size.
constexpr std::size_t kMostJsonBytes = 100'000'000;

/// Reads a JSON file. @throws FileError when missing, InputError with line and column when malformed.
nlohmann::json read_json(const std::filesystem::path& path);

/// Reads a file of a JSON object a line, empty lines left out, and hands each over.
/// @param take may throw whatever the object is refused by: it is told of the line. @param remedy for a line
/// that is no JSON, or that something else than an InputError is thrown for.
/// @throws FileError when missing, InputError "PATH: line 3, FIELD: ...".
void for_each_json_line(const std::filesystem::path& path, const char* remedy,
                        const std::function<void(const nlohmann::json&)>& take);

/// Writes JSON, indented by two, atomically (see write_file_atomically). @throws FileError.
void write_json(const std::filesystem::path& path, const nlohmann::json& document);

/// The figures of a run: flat keys with their units in the name ("tre_volume_mean_mm"). Numbers that are not
/// finite are written as null.
using Figures = std::map<std::string, double>;

/// Writes figures as one flat JSON object. @throws FileError.
void write_figures(const std::filesystem::path& path, const Figures& figures,
                   const std::map<std::string, std::string>& texts = {});

}  // namespace glisson
