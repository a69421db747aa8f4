// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>

#include "error_phrases.h"

namespace glisson::ui {
namespace {

using Phrases = std::vector<const char*>;

Phrases joined(std::initializer_list<const Phrases*> tables) {
  Phrases all;
  for (const Phrases* table : tables) all.insert(all.end(), table->begin(), table->end());
  return all;
}

}  // namespace

const Phrases& known_problems() {
  static const Phrases kAll =
      joined({&general_problems(), &model_problems(), &view_problems(), &work_problems(), &file_problems(),
              &volume_problems(), &setting_problems()});
  return kAll;
}

const Phrases& known_remedies() {
  static const Phrases kAll =
      joined({&general_remedies(), &model_remedies(), &view_remedies(), &work_remedies(), &file_remedies(),
              &volume_remedies(), &setting_remedies()});
  return kAll;
}

}  // namespace glisson::ui
