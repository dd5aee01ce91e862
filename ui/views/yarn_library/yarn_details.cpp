#include "ui/views/yarn_library/yarn_details.h"

#include "core/yarn/count.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/numbers.h"

#include <QColor>
#include <QCoreApplication>

#include <cmath>

namespace knittsim::ui {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("knittsim::ui", text);
}

QString row(const yarn::Yarn& yarn, const char* key, const QString& name, const QString& value,
            const QString& faint) {
    const auto found = yarn.sources.find(key);
    const QString source = found == yarn.sources.end()
                               ? tr("source not given")
                               : QString::fromStdString(found->second).toHtmlEscaped();
    QString html =
        QStringLiteral("<table width='100%' cellspacing='0' cellpadding='0' style='margin-top:5px'><tr>"
                       "<td>%1</td><td align='right'><b>%2</b></td></tr></table>")
            .arg(name, value);
    return html + QStringLiteral("<div style='color:%1'><small>%2</small></div>").arg(faint, source);
}

/// The linear density in the other systems.
QString countsText(const yarn::Yarn& yarn) {
    QStringList counts;
    for (const yarn::CountSystem system : yarn::kCountSystems) {
        if (system != yarn::CountSystem::Tex) {
            counts << countAsShown(system, yarn.tex);
        }
    }
    return counts.join(QStringLiteral(" \u00b7 "));
}

QString twistText(const yarn::Surface& surface) {
    const QString turns =
        surface.twistPerMetre == 0
            ? tr("no twist")
            : tr("%1/m %2").arg(shortNumber(std::abs(surface.twistPerMetre)),
                                surface.twistPerMetre > 0 ? QStringLiteral("S") : QStringLiteral("Z"));
    return tr("%1, %2").arg(surface.plies).arg(turns);
}

QString colourName(const yarn::Colour& colour) {
    return QColor(colour.r, colour.g, colour.b).name();
}

} // namespace

QString countAsShown(yarn::CountSystem system, double tex) {
    return withLocalPoint(QString::fromStdString(yarn::countText(system, tex)));
}

QString yarnDetails(const yarn::Yarn& yarn, const QPalette& palette) {
    const QString faint = accentsOf(palette).faintText.name();
    const QString mm = QStringLiteral("%1 mm");
    QString html = QStringLiteral("<p style='margin:0'><b>%1</b><br><span style='color:%2'>%3</span></p>")
                       .arg(QString::fromStdString(yarn.name).toHtmlEscaped(), faint,
                            QString::fromStdString(yarn.count + " \u00b7 " + yarn.fibre).toHtmlEscaped());
    html += row(yarn, "count", tr("Linear density"), tr("%1 tex").arg(shortNumber(yarn.tex)), faint);
    html += QStringLiteral("<div style='color:%1'><small>= %2</small></div>").arg(faint, countsText(yarn));
    html += row(yarn, "outer_diameter_mm", tr("Outer diameter"), mm.arg(shortNumber(yarn.outerDiameterMm)),
                faint);
    html +=
        row(yarn, "core_diameter_mm", tr("Core diameter"), mm.arg(shortNumber(yarn.coreDiameterMm)), faint);
    html += row(yarn, "axial_stiffness_n", tr("EA, stretching"),
                QStringLiteral("%1 N").arg(shortNumber(yarn.axialStiffnessMilliNewton / 1000)), faint);
    html += row(yarn, "bending_stiffness_n_m2", tr("EI, bending"),
                QStringLiteral("%1 mN\u00b7mm\u00b2").arg(shortNumber(yarn.bendingStiffness)), faint);
    html += row(yarn, "friction", tr("Friction"), shortNumber(yarn.friction), faint);
    html += row(yarn, "colour", tr("Colour"), colourName(yarn.colour), faint);
    html += row(yarn, "surface", tr("Surface"), QString::fromStdString(yarn.surface.kind), faint);
    html +=
        row(yarn, "surface", tr("Hairiness, melange"),
            tr("%1, %2").arg(shortNumber(yarn.surface.hairiness), shortNumber(yarn.surface.melange)), faint);
    html += row(yarn, "surface", tr("Plies and twist"), twistText(yarn.surface), faint);
    if (!yarn.note.empty()) {
        html += QStringLiteral("<p style='color:%1'>%2</p>")
                    .arg(faint, QString::fromStdString(yarn.note).toHtmlEscaped());
    }
    return html;
}

} // namespace knittsim::ui
