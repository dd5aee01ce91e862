#include "ui/document/ladder_command.h"

#include "ui/document/document.h"

#include <QLocale>

namespace knittsim::document {

LadderCommand::LadderCommand(Document& document, std::shared_ptr<Ladder> ladder)
    : m_document(document), m_ladder(std::move(ladder)), m_timeline(document.file()->timeline) {
    const std::size_t loops = m_ladder->runs.loopCount();
    setText(loops == 1 ? Document::tr("ladder of one loop")
                       : Document::tr("ladders of %1 loops").arg(QLocale().toString(loops)));
}

void LadderCommand::redo() {
    if (m_timeline.lock() == m_document.file()->timeline) {
        m_document.takeOut(m_ladder);
    }
}

void LadderCommand::undo() {
    if (m_timeline.lock() == m_document.file()->timeline) {
        m_document.putBack(*m_ladder);
    }
}

} // namespace knittsim::document
