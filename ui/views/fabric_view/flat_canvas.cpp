#include "ui/views/fabric_view/canvas.h"
#include "ui/views/fabric_view/flat_painter.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QWidget>

namespace knittsim::ui {

/// Paints the fabric without OpenGL.
class FlatCanvas final : public QWidget, public Canvas {
public:
    FlatCanvas(QWidget* parent, CanvasContent& content) : QWidget(parent), m_content(content) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    QWidget* widget() override { return this; }
    QString rendererName() const override { return {}; }

    QImage picture() override {
        const QSize pixels = size() * devicePixelRatioF();
        if (pixels.isEmpty()) {
            return {};
        }
        QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(devicePixelRatioF());
        QPainter painter(&image);
        paintFlat(painter, size(), m_content);
        return image;
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QElapsedTimer timer;
        timer.start();
        QPainter painter(this);
        paintFlat(painter, size(), m_content);
        m_content.paintMs = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    }

private:
    CanvasContent& m_content;
};

std::unique_ptr<Canvas> makeFlatCanvas(QWidget* parent, CanvasContent& content) {
    return std::make_unique<FlatCanvas>(parent, content);
}

} // namespace knittsim::ui
