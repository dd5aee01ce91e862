#pragma once

#include "ui/document/document.h"

#include <QColor>
#include <QPalette>
#include <QString>

namespace knittsim::ui {

/// What the shape that is shown does, of the bonding points or, as soon as it settles as yarn, of the yarn:
/// "Settling", "At rest", "Settling as yarn", ...
QString activityWord(const document::Document& document);

/// The same with its reason: "At rest: forces are balanced". Never a colour alone: every state has words.
QString activityText(const document::Document& document);

QColor activityColour(const document::Document& document, const QPalette& palette);

} // namespace knittsim::ui
