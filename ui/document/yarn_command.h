#pragma once

#include "core/yarn/yarn.h"

#include <QUndoCommand>

namespace knittsim::document {

class Document;

/// Gives a carrier another yarn.
class YarnCommand : public QUndoCommand {
public:
    YarnCommand(Document& document, int carrier, yarn::Yarn after);

    void redo() override;
    void undo() override;

private:
    Document& m_document;
    int m_carrier;
    yarn::Yarn m_before;
    yarn::Yarn m_after;
};

} // namespace knittsim::document
