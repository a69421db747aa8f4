// SPDX-License-Identifier: GPL-3.0-or-later
#include "welcome_page.h"

#include <QHBoxLayout>
#include <QIcon>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace glisson::ui {

WelcomePage::WelcomePage(QWidget* parent) : QWidget(parent) {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(14);
  layout->addStretch(2);
  auto* mark = new QLabel(this);
  mark->setPixmap(QIcon(QStringLiteral(":/glisson/icons/glisson.svg")).pixmap(96, 96));
  auto* title = new QLabel(tr("Glisson"), this);
  title->setProperty("role", "welcome-title");
  auto* text = new QLabel(tr("Open a patient's CT or a case, or drop it here."), this);
  text->setProperty("role", "welcome-text");
  for (QLabel* label : {mark, title, text}) {
    label->setAlignment(Qt::AlignCenter);
    layout->addWidget(label);
  }
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  auto* dicom = new QPushButton(tr("DICOM folder…"), this);
  auto* volume = new QPushButton(tr("Volume file…"), this);
  auto* open = new QPushButton(tr("Case…"), this);
  dicom->setProperty("role", "run");
  for (QPushButton* button : {dicom, volume, open}) {
    button->setMinimumWidth(140);
    row->addWidget(button);
  }
  row->addStretch(1);
  layout->addLayout(row);
  layout->addStretch(3);
  connect(dicom, &QPushButton::clicked, this, &WelcomePage::open_dicom);
  connect(volume, &QPushButton::clicked, this, &WelcomePage::open_volume);
  connect(open, &QPushButton::clicked, this, &WelcomePage::open_case);
}

}  // namespace glisson::ui
