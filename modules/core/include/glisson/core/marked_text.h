// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// lupdate looks for this word and collects the texts that modules mark for translators; here it leaves them
/// as they are. Spelt as Qt spells it, so that a source may read both.
#define QT_TRANSLATE_NOOP(scope, x) x
