// SPDX-License-Identifier: GPL-3.0-or-later
// What late_library_test loads.
extern "C" const int glisson_answer;
extern "C" const int glisson_answer = 42;
