#pragma once

#include "ui/document/opener.h"

#include <QUndoCommand>

#include <vector>

namespace knittsim::document {

class Document;

/// Machine data becomes a chart. The yarns that were given to carriers stay with them.
class LiftCommand : public QUndoCommand {
public:
    LiftCommand(Document& document, std::shared_ptr<const OpenedFile> lifted);

    void redo() override;
    void undo() override;

private:
    Document& m_document;
    std::shared_ptr<const OpenedFile> m_before;
    std::vector<CarrierYarn> m_carriersBefore;
    std::shared_ptr<const fabric::Fabric> m_fabricBefore; ///< without the ladders that have run
    std::shared_ptr<const OpenedFile> m_lifted;
};

} // namespace knittsim::document
