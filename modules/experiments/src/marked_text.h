// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// lupdate looks for this word and collects the texts of aims and plots; here it leaves them as they are.
#define QT_TRANSLATE_NOOP(context, text) text
