// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

class QWidget;

/// @file
/// Asking for a place to write. A system's dialog asks about the name that was typed, not about the one that
/// an ending is added to: what lay there was replaced unasked.

namespace glisson::ui {

/// The name with the first of `endings` (".json") where it has none of them.
QString with_ending(const QString& path, const QStringList& endings);

/// Whether `path` may be written: nothing lies there, or a person has said that it may go.
bool may_be_replaced(QWidget* parent, const QString& path);

/// The same for several files that are there already, asked at once; true where there are none.
bool may_be_replaced(QWidget* parent, const QStringList& there);

/// Asks for a file or folder to write, with its ending. Empty: none is wanted.
/// @param own may be written over without a question, as the case that is open; may be empty.
QString ask_where_to_save(QWidget* parent, const QString& title, const QString& proposed,
                          const QString& filter, const QStringList& endings, const QString& own = {});

}  // namespace glisson::ui
