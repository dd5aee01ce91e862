#pragma once

#include "core/pattern/project.h"

#include <QUndoCommand>

namespace knittsim::document {

class Document;

/// One change of the colourways, and of the yarns that the chart has.
class ColourwayCommand : public QUndoCommand {
public:
    ColourwayCommand(Document& document, const QString& text, pattern::Colourways after,
                     std::vector<pattern::ChartYarn> yarns);

    void redo() override;
    void undo() override;

private:
    struct State {
        pattern::Colourways colourways;
        std::vector<pattern::ChartYarn> yarns;
    };

    Document& m_document;
    State m_before;
    State m_after;
};

} // namespace knittsim::document
