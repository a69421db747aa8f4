// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// @file
/// What a process that parses foreign files gives up, so that a parser that a file has taken over can do no
/// harm: for helper programs of our own, right after their start. Nothing given up comes back.

namespace glisson {

/// What holds from now on. Where the kernel lacks a layer, it is false and the others still hold.
struct Confinement {
  /// Landlock (Linux 5.13): only what was named can be read, only what was named written.
  bool files = false;
  /// seccomp: no network, no other program, no look into other processes.
  bool calls = false;
};

/// What this kernel can hold of a confined process; nothing in a build with sanitizers.
Confinement possible_confinement();

/// Confines this process and all its threads to come.
/// @param readable files and folders beside the system's libraries (/usr, /lib, /lib64).
/// @param writable folders (they are readable, too).
Confinement confine(const std::vector<std::filesystem::path>& readable,
                    const std::vector<std::filesystem::path>& writable);

/// Limits of this process. They are soft, so that they can be raised when more is known.
/// Of the address space: a demand beyond it fails.
void limit_memory(double bytes);
/// Of processor time, all threads together: the process ends when it is used up.
void limit_seconds(double seconds);
/// Of each file that is written: a write beyond it ends the process (or fails, where SIGXFSZ is ignored).
void limit_written_file(double bytes);
/// No core dump (it would hold a patient's data), and no life beyond the parent's, which decides on it alone
/// (leave_requests_to_the_parent).
void die_with_parent();
/// A request to stop (SIGINT, SIGTERM, SIGHUP) that goes to every process of a session or a service is for
/// the parent, which ends this one. If this one ended by itself, the parent would take the file for damaged.
void leave_requests_to_the_parent();

/// Tries what a confined process must not do, and tells what it could: "read" and "write" (of files), and
/// what calls do: "network", "program", "mode", "truncate", "signal", "asynchronous_signal", "message".
std::vector<std::string> escapes();

}  // namespace glisson
