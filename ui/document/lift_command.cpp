#include "ui/document/lift_command.h"

#include "ui/document/document.h"

#include <algorithm>

namespace knittsim::document {

LiftCommand::LiftCommand(Document& document, std::shared_ptr<const OpenedFile> lifted)
    : m_document(document), m_before(document.file()), m_carriersBefore(document.carriers()),
      m_fabricBefore(document.m_whole), m_lifted(std::move(lifted)) {
    setText(Document::tr("edit as chart"));
}

void LiftCommand::redo() {
    std::vector<CarrierYarn> carriers = m_lifted->carriers;
    for (CarrierYarn& carrier : carriers) {
        const auto before = std::ranges::find(m_carriersBefore, carrier.carrier, &CarrierYarn::carrier);
        if (before != m_carriersBefore.end() && before->used) {
            carrier.yarn = before->yarn;
        }
    }
    m_document.exchangeProgram(m_lifted, carriers, m_lifted->fabric);
    for (const CarrierYarn& carrier : carriers) {
        m_document.putYarn(carrier.carrier, carrier.yarn);
    }
}

void LiftCommand::undo() {
    m_document.exchangeProgram(m_before, m_carriersBefore, m_fabricBefore);
}

} // namespace knittsim::document
