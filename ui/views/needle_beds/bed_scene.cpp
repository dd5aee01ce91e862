#include "ui/views/needle_beds/bed_scene.h"

#include "ui/views/style/appearance.h"

#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

QColor BedScene::yarn(machine::CarrierIndex carrier) const {
    return carrier < yarns.size() ? yarns[carrier] : palette.color(QPalette::Text);
}

const machine::SeenNeedle* BedScene::find(machine::Needle needle) const {
    const auto found = std::ranges::lower_bound(picture.needles, needle, {}, &machine::SeenNeedle::needle);
    return found != picture.needles.end() && found->needle == needle ? &*found : nullptr;
}

bool BedScene::works(machine::Needle needle) const {
    return std::ranges::find(working, needle) != working.end();
}

QString countText(const machine::SeenNeedle& needle) {
    const auto held = std::ranges::count_if(needle.loops, [](const machine::SeenLoop& loop) {
        return loop.place != machine::LoopPlace::KnockedOver;
    });
    return held > 1 ? QStringLiteral("\u00d7%1").arg(held) : QString();
}

BedColours::BedColours(const QPalette& palette) {
    const bool dark = isDark(palette);
    const Accents accents = accentsOf(palette);
    bed = dark ? QColor(0x2c323a) : QColor(0xe6e9ee);
    needle = dark ? QColor(0x77818e) : QColor(0xa3acb8);
    busyNeedle = dark ? QColor(0xdfe5ec) : QColor(0x3d4752);
    latch = dark ? QColor(0xaab3bf) : QColor(0x6f7986);
    rail = dark ? QColor(0x454d58) : QColor(0xc3cad3);
    text = palette.color(QPalette::Text);
    faint = accents.faintText;
    accent = palette.color(QPalette::Highlight);
    onAccent = palette.color(QPalette::HighlightedText);
}

void paintYarn(QPainter& painter, const QPainterPath& path, const QColor& colour, double width,
               const QColor& halo) {
    painter.setBrush(Qt::NoBrush);
    const auto stroke = [&](const QColor& ink, double pen) {
        painter.setPen(QPen(ink, pen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    };
    if (halo.isValid()) {
        stroke(halo, width + 6);
    }
    if (width > 1.3) {
        const int darkest = painter.background().color().lightness() < 128 ? 110 : 60;
        stroke(colour.lightness() < darkest ? colour.lighter(220) : colour.darker(190), width + 1.6);
    }
    stroke(colour, width);
}

} // namespace knittsim::ui
