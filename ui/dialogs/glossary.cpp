#include "ui/dialogs/glossary.h"

#include <QCoreApplication>
#include <QStringList>

namespace knittsim::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

constexpr const char* kHeader = ";!knitout-2\n;;Carriers: 1 2\n";
/// Loops on f1 to f3, the carrier on the right.
constexpr const char* kThreeInFront = "in 1\nknit + f1 1\nknit + f2 1\nknit + f3 1\n";
constexpr const char* kThreeBehind = "in 1\nknit + b1 1\nknit + b2 1\nknit + b3 1\n";

GlossaryEntry entry(const char* id, const QString& word, const QString& text, const char* before,
                    const char* shown) {
    return {QString::fromLatin1(id), word, text, QString::fromLatin1(kHeader) + before + shown,
            static_cast<int>(QByteArray(before).count('\n'))};
}

} // namespace

std::vector<GlossaryEntry> glossary() {
    return {
        entry(
            "cast-on", tr("Cast-on"),
            tr("The first loops are hung on empty needles. Every second needle takes yarn on the way there, "
               "the others on the way back."),
            "in 1\n", "tuck - f4 1\ntuck - f2 1\ntuck + f1 1\ntuck + f3 1\n"),
        entry(
            "knit", tr("Knit"),
            tr("The needle rises, its old loop slides behind the latch, new yarn comes. The needle sinks and "
               "draws the new loop through the old one."),
            kThreeInFront, "knit - f3 1\nknit - f2 1\nknit - f1 1\n"),
        entry("purl", tr("Purl"),
              tr("The same stitch made on the rear bed. Seen from the front, the new loop goes to the back."),
              kThreeBehind, "knit - b3 1\nknit - b2 1\nknit - b1 1\n"),
        entry("tuck", tr("Tuck"),
              tr("The needle rises only so far that the old loop stays on the latch. It takes yarn and holds "
                 "both."),
              kThreeInFront, "tuck - f2 1\n"),
        entry("miss", tr("Miss"),
              tr("The needle stays down while the carrier passes. The yarn floats past its loop."),
              kThreeInFront, "knit - f3 1\nmiss - f2 1\nknit - f1 1\n"),
        entry("split", tr("Split"),
              tr("The loop goes to the other bed, and the needle takes new yarn in the same stroke. Both "
                 "needles hold a loop then."),
              kThreeInFront, "split - f2 b2 1\n"),
        entry("transfer", tr("Transfer"),
              tr("The needle lifts its loop high, the needle opposite enters it and takes it over. The first "
                 "needle is empty then."),
              kThreeInFront, "xfer f2 b2\n"),
        entry("rack", tr("Rack"),
              tr("The whole rear bed moves aside by needles. Its loops stand opposite other front needles "
                 "then."),
              "in 1\nknit + f1 1\nknit + b2 1\nknit + f3 1\n", "rack 1\nrack -1\nrack 0\n"),
        entry("drop", tr("Drop"),
              tr("The needle works without getting yarn. Its loop falls off, and what hung from it may run."),
              kThreeInFront, "drop f2\n"),
        entry("bind-off", tr("Bind-off"),
              tr("One loop after the other is moved on to its neighbour and knitted together with it, until "
                 "none is left that could run."),
              kThreeInFront,
              "knit - f3 1\nxfer f3 b3\nrack -1\nxfer b3 f2\nrack 0\nknit - f2 1\nxfer f2 b2\nrack -1\n"
              "xfer b2 f1\nrack 0\nknit - f1 1\n"),
    };
}

} // namespace knittsim::ui
