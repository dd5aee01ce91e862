#pragma once

#include "core/machine/timeline.h"
#include "ui/document/ladder.h"

#include <QUndoCommand>

namespace knittsim::document {

class Document;

/// Takes out the loops that nothing holds. At first they run before one's eyes; undone while they do, the run
/// ends. Done again, they are gone at once.
class LadderCommand : public QUndoCommand {
public:
    LadderCommand(Document& document, std::shared_ptr<Ladder> ladder);

    void redo() override;
    void undo() override;

private:
    Document& m_document;
    std::shared_ptr<Ladder> m_ladder;
    std::weak_ptr<const machine::Timeline> m_timeline; ///< of another one nothing is taken out
};

} // namespace knittsim::document
