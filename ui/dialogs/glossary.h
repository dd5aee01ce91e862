#pragma once

#include <QString>

#include <vector>

namespace knittsim::ui {

/// A word of machine knitting with a tiny program that shows it.
struct GlossaryEntry {
    QString id;      ///< "knit", "bind-off", ...
    QString word;    ///< in the person's language
    QString text;    ///< what it is, in two sentences
    QString knitout; ///< the program
    int from = 0;    ///< operations done where the animation begins; it ends with the program
};

/// In the order in which one learns them.
std::vector<GlossaryEntry> glossary();

} // namespace knittsim::ui
