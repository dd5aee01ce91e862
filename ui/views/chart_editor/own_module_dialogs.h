#pragma once

#include "core/pattern/chart.h"

#include <QString>

class QWidget;

/// Questions about modules of one's own; each asks again, with the reason, until it is answered well.
namespace knittsim::ui {

/// True when it was saved.
bool saveAsOwnModule(QWidget* parent, const pattern::Chart& part);
void renameOwnModule(QWidget* parent, const QString& name);
void removeOwnModule(QWidget* parent, const QString& name);

} // namespace knittsim::ui
