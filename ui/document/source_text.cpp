#include "ui/document/source_text.h"

#include <algorithm>
#include <utility>

namespace knittsim::document {

SourceText::SourceText(QString text) : m_text(std::move(text)) {
    qsizetype start = 0;
    while (start < m_text.size()) {
        m_starts.push_back(start);
        const qsizetype end = m_text.indexOf(u'\n', start);
        start = end < 0 ? m_text.size() : end + 1;
    }
    for (int number = 1; number <= lineCount(); ++number) {
        m_longest = std::max(m_longest, static_cast<int>(line(number).size()));
    }
}

QStringView SourceText::line(int number) const {
    if (number < 1 || number > lineCount()) {
        return {};
    }
    const auto index = static_cast<std::size_t>(number) - 1;
    const qsizetype start = m_starts[index];
    qsizetype end = index + 1 < m_starts.size() ? m_starts[index + 1] : m_text.size();
    while (end > start && (m_text[end - 1] == u'\n' || m_text[end - 1] == u'\r')) {
        --end;
    }
    return QStringView(m_text).mid(start, end - start);
}

} // namespace knittsim::document
