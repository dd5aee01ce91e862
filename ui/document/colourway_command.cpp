#include "ui/document/colourway_command.h"

#include "ui/document/document.h"

namespace knittsim::document {

ColourwayCommand::ColourwayCommand(Document& document, const QString& text, pattern::Colourways after,
                                   std::vector<pattern::ChartYarn> yarns)
    : m_document(document), m_before{document.project()->colourways, document.project()->chart.yarns},
      m_after{std::move(after), std::move(yarns)} {
    setText(text);
}

void ColourwayCommand::redo() {
    m_document.applyColourways(m_after.colourways, m_after.yarns);
}

void ColourwayCommand::undo() {
    m_document.applyColourways(m_before.colourways, m_before.yarns);
}

} // namespace knittsim::document
