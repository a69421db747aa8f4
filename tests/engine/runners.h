// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include "glisson/engine/engine.h"

Q_DECLARE_METATYPE(glisson::engine::Runner)

namespace glisson::test {

inline engine::Engine::Options options_of(engine::Runner runner) {
  engine::Engine::Options options;
  options.runner = runner;
  return options;
}

/// Rows for what both runners promise.
inline void both_runners() {
  using engine::Runner;
  QTest::addColumn<Runner>("runner");
  QTest::newRow("inline") << Runner::inline_;
  QTest::newRow("threaded") << Runner::threaded;
}

}  // namespace glisson::test
