#include "ui/views/simulation_panel/ladder_text.h"

#include "ui/views/style/numbers.h"

#include <QCoreApplication>

namespace knittsim::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

QString count(std::size_t loops) {
    return countText(static_cast<qint64>(loops));
}

} // namespace

QString ladderText(const document::Document& document) {
    const std::size_t unstable = document.unstableLoops();
    const std::size_t removed = document.removedLoops();
    if (unstable > 0 && removed > 0) {
        return document.laddersRun()
                   ? tr("%1 of %2 loops have run").arg(count(removed), count(removed + unstable))
                   : tr("%1 loops have run, %2 would run").arg(count(removed), count(unstable));
    }
    if (unstable > 0) {
        return unstable == 1 ? tr("1 loop would run") : tr("%1 loops would run").arg(count(unstable));
    }
    if (removed > 0) {
        return removed == 1 ? tr("1 loop has run") : tr("%1 loops have run").arg(count(removed));
    }
    return {};
}

QString nothingRunsText(const document::Document& document) {
    const QString text =
        document.removedLoops() > 0
            ? tr("Nothing more runs: every loop that is left is held by a needle or by the loop drawn "
                 "through it.")
            : tr("Nothing runs: every loop is held by a needle or by the loop drawn through it.");
    return document.stitchHolder()
               ? tr("%1 Without the stitch holder the loops left on the needles run as well.").arg(text)
               : text;
}

QString removeLaddersHelp() {
    return tr(
        "Takes out the loops that nothing holds, course by course, and gives their yarn to the neighbours");
}

QString stitchHolderHelp() {
    return tr("Loops left on the needles are held; without it the fabric ravels from the top");
}

} // namespace knittsim::ui
