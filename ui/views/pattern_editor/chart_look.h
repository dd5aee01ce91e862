#pragma once

#include <QByteArray>
#include <QObject>

#include <array>
#include <cstdint>

namespace knittsim::ui {

/// The drawings that stand for stitches.
enum class SymbolSet : std::uint8_t {
    Faces,     ///< what a stitch looks like: a V, a bump, an arch
    Craft,     ///< as charts for hand knitting have them: knit is blank, purl a dash, slipped a V
    Technical, ///< the way of the yarn around the needles of both beds
};
constexpr int kSymbolSets = 3;

/// What can stand beside a chart, from the left; the needle numbers stand below it.
enum class SideColumn : std::uint8_t { Course, Direction, Carrier, StitchSize, Racking, Needle };
constexpr int kSideColumns = 6;

/// How charts are shown, in all views alike.
class ChartLook : public QObject {
    Q_OBJECT

public:
    enum class Shown : std::uint8_t { ByContent, Always, Never };

    using QObject::QObject;

    SymbolSet symbols() const { return m_symbols; }
    void setSymbols(SymbolSet symbols);
    void nextSymbols();

    Shown shown(SideColumn column) const { return m_shown[static_cast<std::size_t>(column)]; }
    void setShown(SideColumn column, Shown shown);
    void showByContent();

    QByteArray save() const;
    /// What was not saved by save() is left alone.
    void restore(const QByteArray& bytes);

    static QString nameOf(SymbolSet symbols);
    static QString nameOf(SideColumn column);

signals:
    void changed();

private:
    SymbolSet m_symbols = SymbolSet::Faces;
    std::array<Shown, kSideColumns> m_shown{};
};

} // namespace knittsim::ui
