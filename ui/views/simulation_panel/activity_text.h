#pragma once

#include "ui/document/document.h"

#include <QColor>
#include <QPalette>
#include <QString>

namespace knittsim::ui {

/// "At rest: the residual is below the limit". Never a colour alone: every state has words.
QString activityText(const document::Document& document);

/// One word: "Settling", "At rest", ...
QString activityWord(document::Activity activity);

QColor activityColour(document::Activity activity, const QPalette& palette);

} // namespace knittsim::ui
