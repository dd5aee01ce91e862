#include "ui/views/style/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

/// A static library's resources must be named once; the macro does not work inside a namespace.
static void loadIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace knittsim::ui {

namespace {

class PaletteIconEngine : public QIconEngine {
public:
    PaletteIconEngine(QByteArray drawing, QColor colour) : m_drawing(std::move(drawing)), m_colour(colour) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        QColor colour = m_colour.isValid() ? m_colour : QApplication::palette().color(QPalette::ButtonText);
        if (mode == QIcon::Selected && !m_colour.isValid()) {
            colour = QApplication::palette().color(QPalette::HighlightedText);
        }
        QByteArray drawing = m_drawing;
        drawing.replace("#000000", colour.name().toLatin1());
        QSvgRenderer renderer(drawing);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (mode == QIcon::Disabled) {
            painter->setOpacity(0.38);
        }
        renderer.render(painter, QRectF(rect));
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new PaletteIconEngine(*this); }

private:
    QByteArray m_drawing;
    QColor m_colour;
};

} // namespace

QIcon icon(const QString& name) {
    return icon(name, QColor());
}

QIcon icon(const QString& name, const QColor& colour) {
    loadIcons();
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    return QIcon(new PaletteIconEngine(file.readAll(), colour));
}

QIcon applicationIcon() {
    loadIcons();
    return QIcon(QStringLiteral(":/icons/app.svg"));
}

} // namespace knittsim::ui
