#pragma once

#include <QString>
#include <QStringView>

#include <vector>

namespace knittsim::document {

/// A text file cut into lines, made off the window's thread. Immutable once made. Bytes that are not UTF-8
/// show as replacement characters; LF, CR LF and a missing last line end are understood.
class SourceText {
public:
    SourceText() = default;
    explicit SourceText(QString text);

    int lineCount() const { return static_cast<int>(m_starts.size()); }

    /// Line by its 1-based number without its end; empty outside the file.
    QStringView line(int number) const;

    /// Characters of the longest line, for the scroll bar.
    int longestLine() const { return m_longest; }

private:
    QString m_text;
    std::vector<qsizetype> m_starts;
    int m_longest = 0;
};

} // namespace knittsim::document
