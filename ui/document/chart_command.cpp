#include "ui/document/chart_command.h"

#include "ui/document/document.h"

namespace knittsim::document {

ChartCommand::ChartCommand(Document& document, const QString& text, pattern::ChartPatch patch)
    : m_document(document), m_patch(std::move(patch)) {
    setText(text);
}

void ChartCommand::redo() {
    m_document.applyPatch(m_patch, true);
}

void ChartCommand::undo() {
    m_document.applyPatch(m_patch, false);
}

} // namespace knittsim::document
