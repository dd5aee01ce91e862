#include "ui/views/pattern_editor/chart_look.h"

#include <algorithm>

namespace knittsim::ui {

void ChartLook::setSymbols(SymbolSet symbols) {
    if (symbols != m_symbols) {
        m_symbols = symbols;
        emit changed();
    }
}

void ChartLook::nextSymbols() {
    setSymbols(static_cast<SymbolSet>((static_cast<int>(m_symbols) + 1) % kSymbolSets));
}

void ChartLook::setShown(SideColumn column, Shown shown) {
    Shown& present = m_shown[static_cast<std::size_t>(column)];
    if (shown != present) {
        present = shown;
        emit changed();
    }
}

void ChartLook::showByContent() {
    m_shown = {};
    emit changed();
}

QByteArray ChartLook::save() const {
    QByteArray bytes(1, static_cast<char>('0' + static_cast<int>(m_symbols)));
    for (const Shown shown : m_shown) {
        bytes += static_cast<char>('0' + static_cast<int>(shown));
    }
    return bytes;
}

void ChartLook::restore(const QByteArray& bytes) {
    const bool known = bytes.size() == 1 + kSideColumns &&
                       std::all_of(bytes.begin(), bytes.end(), [](char c) { return c >= '0' && c <= '2'; });
    if (known) {
        m_symbols = static_cast<SymbolSet>(bytes[0] - '0');
        for (int i = 0; i < kSideColumns; ++i) {
            m_shown[static_cast<std::size_t>(i)] = static_cast<Shown>(bytes[1 + i] - '0');
        }
        emit changed();
    }
}

QString ChartLook::nameOf(SymbolSet symbols) {
    switch (symbols) {
    case SymbolSet::Faces:
        return tr("Stitch faces");
    case SymbolSet::Craft:
        return tr("Craft symbols");
    case SymbolSet::Technical:
        break;
    }
    return tr("Loop notation");
}

QString ChartLook::nameOf(SideColumn column) {
    switch (column) {
    case SideColumn::Course:
        return tr("Course numbers");
    case SideColumn::Direction:
        return tr("Carriage direction");
    case SideColumn::Carrier:
        return tr("Carriers");
    case SideColumn::StitchSize:
        return tr("Stitch size");
    case SideColumn::Racking:
        return tr("Racking");
    case SideColumn::Needle:
        break;
    }
    return tr("Needle numbers");
}

} // namespace knittsim::ui
