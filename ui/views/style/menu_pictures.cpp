#include "ui/views/style/menu_pictures.h"

#include <QMenu>
#include <QProxyStyle>

namespace knittsim::ui {

namespace {

class PictureStyle : public QProxyStyle {
public:
    PictureStyle(const QString& base, int pixels) : QProxyStyle(base), m_pixels(pixels) {}

    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        return metric == PM_SmallIconSize ? m_pixels : QProxyStyle::pixelMetric(metric, option, widget);
    }

private:
    int m_pixels;
};

} // namespace

void showPictures(QMenu* menu, int pixels) {
    auto* style = new PictureStyle(menu->style()->name(), pixels);
    style->setParent(menu);
    menu->setStyle(style);
}

} // namespace knittsim::ui
