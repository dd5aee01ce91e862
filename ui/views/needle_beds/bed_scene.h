#pragma once

#include "core/machine/bed_picture.h"
#include "core/machine/timeline.h"

#include <QColor>
#include <QPainter>
#include <QPalette>

#include <optional>
#include <vector>

namespace knittsim::ui {

/// What both painters draw.
struct BedScene {
    const machine::BedPicture& picture;
    const machine::Timeline& timeline;
    const std::vector<QColor>& yarns; ///< by carrier
    const QPalette& palette;
    std::vector<machine::Needle> working; ///< needles of the operation that is shown
    machine::LoopIndex selected = -1;

    QColor yarn(machine::CarrierIndex carrier) const;
    const machine::SeenNeedle* find(machine::Needle needle) const;
    bool works(machine::Needle needle) const;
};

/// Loops that a needle holds, in words: "×3"; empty for one or none.
QString countText(const machine::SeenNeedle& needle);

/// Colours of the machine's parts.
struct BedColours {
    explicit BedColours(const QPalette& palette);

    QColor bed;
    QColor needle;
    QColor busyNeedle;
    QColor latch; ///< of a needle at rest
    QColor rail;
    QColor text;
    QColor faint;
    QColor accent;
    QColor onAccent;
};

/// A yarn along a path: its colour within a darker (or lighter) edge, so that it stands out from the
/// painter's background.
void paintYarn(QPainter& painter, const QPainterPath& path, const QColor& colour, double width,
               const QColor& halo = {});

} // namespace knittsim::ui
