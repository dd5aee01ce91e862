#pragma once

#include <QString>
#include <QStringList>

class QCoreApplication;

namespace knittsim::ui {

/// Languages that the window can speak: "en", "de".
QStringList languages();

/// Words and numbers in this language from now on; empty: the system's. What is written already stays.
void applyLanguage(QCoreApplication& application, const QString& id);

} // namespace knittsim::ui
