#pragma once

#include "core/base/diagnostic.h"

#include <QString>

namespace knittsim::document {

/// Sentences of a diagnostic in the language of the window; the English table of core/base is the source
/// text.
QString causeText(const Diagnostic& diagnostic);
QString cureText(const Diagnostic& diagnostic);

/// "Error", "Warning", "Note".
QString severityText(Severity severity);

/// "line 12, f5", or empty.
QString placeText(const Place& place);

} // namespace knittsim::document
