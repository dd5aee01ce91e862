#pragma once

#include "core/pattern/chart_edit.h"

#include <QUndoCommand>

namespace knittsim::document {

class Document;

/// One change of the chart.
class ChartCommand : public QUndoCommand {
public:
    ChartCommand(Document& document, const QString& text, pattern::ChartPatch patch);

    void redo() override;
    void undo() override;

private:
    Document& m_document;
    pattern::ChartPatch m_patch;
};

} // namespace knittsim::document
