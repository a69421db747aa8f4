// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/codes.h"
#include "glisson/volume/io.h"

namespace glisson {
namespace {

constexpr Codes<Modality, 3> kCodes = {
    {{"ct", Modality::ct}, {"mr", Modality::mr}, {"other", Modality::other}}};

}  // namespace

const char* modality_code(Modality modality) { return code_in(kCodes, modality); }

std::optional<Modality> modality_named(std::string_view code) { return value_in(kCodes, code); }

}  // namespace glisson
