// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

/// @file
/// The other end of a Conversation (child_process.h): what a helper program does at its start, and how it
/// hears and answers.

namespace glisson::child_side {

/// Nothing that is open in Glisson is for this program, and no core dump, which would hold a patient's data.
/// The input's end ends it: a signal at the parent's end would come when the thread ends that made it.
void begin();
/// Processor time from now on; a limit that is reached ends this process.
void allow_seconds(double seconds);
/// Confines itself and leaves in FOLDER/escapes what it could do that it must not, a word a line.
/// @return the program's exit code
int tell_escapes(const std::string& folder);

/// All the bytes, or false: Glisson is gone.
bool hear(void* bytes, std::size_t count);
bool tell(const void* bytes, std::size_t count);
/// A value of bytes alone.
template <class T>
bool hear(T& value) {
  return hear(&value, sizeof value);
}
template <class T>
bool tell(const T& value) {
  return tell(&value, sizeof value);
}

}  // namespace glisson::child_side
