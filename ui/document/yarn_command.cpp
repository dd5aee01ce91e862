#include "ui/document/yarn_command.h"

#include "ui/document/document.h"

namespace knittsim::document {

YarnCommand::YarnCommand(Document& document, int carrier, yarn::Yarn after)
    : m_document(document), m_carrier(carrier),
      m_before(document.carriers()[static_cast<std::size_t>(carrier)].yarn), m_after(std::move(after)) {
    setText(Document::tr("yarn %1 on carrier %2")
                .arg(QString::fromStdString(m_after.name),
                     QString::fromStdString(document.carriers()[static_cast<std::size_t>(carrier)].carrier)));
}

void YarnCommand::redo() {
    m_document.applyYarn(m_carrier, m_after);
}

void YarnCommand::undo() {
    m_document.applyYarn(m_carrier, m_before);
}

} // namespace knittsim::document
