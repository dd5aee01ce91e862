#include "ui/views/fabric_view/reason_text.h"

#include "core/base/message_table.h"

#include <QStringList>

namespace knittsim::ui {

QString reasonText(const Diagnostics& diagnostics) {
    QStringList sentences;
    for (const Diagnostic& diagnostic : diagnostics) {
        sentences << QString::fromStdString(causeText(diagnostic));
    }
    return sentences.join(' ');
}

} // namespace knittsim::ui
