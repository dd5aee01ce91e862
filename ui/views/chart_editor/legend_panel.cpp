#include "ui/views/chart_editor/legend_panel.h"

#include "ui/views/chart_editor/chart_legend.h"
#include "ui/views/style/appearance.h"

#include <QEvent>
#include <QPainter>

namespace knittsim::ui {

namespace {

constexpr QSize kPicture(40, 24);

QIcon pictureOf(const LegendEntry& entry, const QPalette& palette, double ratio) {
    QPixmap pixmap(kPicture * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(palette.color(QPalette::Base));
    QPainter painter(&pixmap);
    const QRectF frame(0.5, 0.5, kPicture.width() - 1, kPicture.height() - 1);
    painter.save();
    entry.paint(painter, frame.adjusted(5, 1, -5, -1), palette.color(QPalette::Text));
    painter.restore();
    painter.setPen(accentsOf(palette).line);
    painter.drawRect(frame);
    painter.end();
    return pixmap;
}

} // namespace

LegendPanel::LegendPanel(document::Document& document, ChartLook& look, QWidget* parent)
    : QListWidget(parent), m_document(document), m_look(look) {
    setObjectName(QStringLiteral("legend"));
    setAccessibleName(tr("Legend"));
    setWhatsThis(tr("What the symbols and colours of the chart stand for."));
    setFrameShape(NoFrame);
    setIconSize(kPicture);
    setWordWrap(true);
    setSpacing(2);
    setSelectionMode(NoSelection);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&m_document, &document::Document::chartChanged, this, &LegendPanel::take);
    connect(&m_document, &document::Document::fileChanged, this, &LegendPanel::take);
    connect(&m_document, &document::Document::yarnsChanged, this, &LegendPanel::take);
    connect(&m_look, &ChartLook::changed, this, &LegendPanel::take);
}

void LegendPanel::take() {
    if (!isVisible()) {
        return;
    }
    std::vector<LegendEntry> legend;
    const auto project = m_document.project();
    if (project) {
        legend = legendOf(project->chart, m_look.symbols());
    } else if (const auto file = m_document.file()) {
        legend = legendOf(*file->grid, m_look.symbols());
    }
    for (const document::CarrierYarn& carrier : m_document.carriers()) {
        if (carrier.used) {
            const yarn::Colour c = carrier.yarn.colour;
            legend.push_back(yarnEntry(
                tr("Carrier %1: %2")
                    .arg(QString::fromStdString(carrier.carrier), QString::fromStdString(carrier.yarn.name)),
                {c.r, c.g, c.b}));
        }
    }
    clear();
    for (const LegendEntry& entry : legend) {
        addItem(new QListWidgetItem(pictureOf(entry, palette(), devicePixelRatioF()), entry.name));
    }
}

void LegendPanel::showEvent(QShowEvent* event) {
    QListWidget::showEvent(event);
    take();
}

void LegendPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        take();
    }
    QListWidget::changeEvent(event);
}

} // namespace knittsim::ui
