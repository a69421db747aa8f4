// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/headless_gui.h"

#include <QGuiApplication>
#include <array>

namespace glisson::scene {

struct HeadlessGui::Impl {
  // Qt keeps references to its arguments for as long as the application lives.
  std::array<char, 8> name{'g', 'l', 'i', 's', 's', 'o', 'n', '\0'};
  std::array<char, 10> option{'-', 'p', 'l', 'a', 't', 'f', 'o', 'r', 'm', '\0'};
  std::array<char, 10> platform{'o', 'f', 'f', 's', 'c', 'r', 'e', 'e', 'n', '\0'};
  std::array<char*, 4> arguments{name.data(), option.data(), platform.data(), nullptr};
  int count = 3;
  QGuiApplication application{count, arguments.data()};
};

HeadlessGui::HeadlessGui() {
  if (QCoreApplication::instance() == nullptr) impl_ = std::make_unique<Impl>();
}
HeadlessGui::~HeadlessGui() = default;

}  // namespace glisson::scene
