#include "ui/views/chart_editor/colour_method_menu.h"

#include "ui/views/style/appearance.h"
#include "ui/views/style/menu_pictures.h"

#include <QPainter>

#include <array>
#include <utility>

namespace knittsim::ui {

using pattern::ColourMethod;

namespace {

constexpr QSize kIcon{44, 20};
constexpr int kNeedles = 8;

struct Words {
    QString name;
    QString help;
};

std::array<Words, pattern::kColourMethods> words() {
    return {
        {{ColourMethodMenu::tr("&Float jacquard"),
          ColourMethodMenu::tr("Yarns that do not show float behind the stitches")},
         {ColourMethodMenu::tr("&Intarsia"),
          ColourMethodMenu::tr("Every yarn stays in its own zone and is linked to the next one by a tuck")},
         {ColourMethodMenu::tr("&Birdseye back"),
          ColourMethodMenu::tr("On both beds: every yarn knits every second needle of the rear bed; no "
                               "floats, a dotted back")},
         {ColourMethodMenu::tr("&Ladder back"),
          ColourMethodMenu::tr("On both beds: every fourth needle of the rear bed knits a yarn that does not "
                               "show there; a light back with short floats")}}};
}

} // namespace

/// Two yarns, two needles each in turn; the loops of the front bed below, of the rear bed above.
QIcon colourMethodIcon(ColourMethod method, const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    QPixmap pixmap(kIcon * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::array<QColor, 2> yarns{widget.palette().color(QPalette::Text),
                                      widget.palette().color(QPalette::Highlight)};
    const double step = static_cast<double>(kIcon.width()) / kNeedles;
    const auto shown = [](int needle) { return static_cast<std::size_t>(needle / 4 % 2); };
    const auto loop = [&](int needle, double y, std::size_t yarn, double size) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(yarns[yarn]);
        painter.drawEllipse(QPointF((needle + 0.5) * step, y), size, size);
    };
    for (std::size_t yarn = 0; yarn < yarns.size(); ++yarn) {
        const double y = 10.0 - 2.0 * static_cast<double>(yarn);
        const int first = method == ColourMethod::Intarsia && yarn == 1 ? 4 : 0;
        const int last = method == ColourMethod::Intarsia && yarn == 0 ? 3 : kNeedles - 1;
        painter.setPen(QPen(yarns[yarn], 1));
        painter.drawLine(QPointF((first + 0.5) * step, y), QPointF((last + 0.5) * step, y));
    }
    for (int needle = 0; needle < kNeedles; ++needle) {
        loop(needle, 15.5, shown(needle), 2.3);
        if (method == ColourMethod::Birdseye) {
            loop(needle, 3.5, static_cast<std::size_t>(needle % 2), 1.8);
        } else if (method == ColourMethod::LadderBack && needle % 4 == 1) {
            loop(needle, 3.5, 1 - shown(needle), 1.8);
        }
    }
    painter.end();
    return pixmap;
}

ColourMethodMenu::ColourMethodMenu(const QString& heading, std::optional<ColourMethod> present,
                                   std::function<void(ColourMethod)> chosen, QWidget* parent)
    : QMenu(parent) {
    setObjectName(QStringLiteral("colourMethods"));
    setAttribute(Qt::WA_DeleteOnClose);
    setToolTipsVisible(true);
    showPictures(this, kIcon.width());
    addAction(heading)->setEnabled(false);
    addSeparator();
    const auto all = words();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto method = static_cast<ColourMethod>(i);
        QAction* action = addAction(colourMethodIcon(method, *this), all[i].name, this,
                                    [chosen, method] { chosen(method); });
        action->setObjectName(QStringLiteral("colourMethod%1").arg(i));
        action->setToolTip(all[i].help);
        action->setCheckable(true);
        action->setChecked(present == method);
    }
}

} // namespace knittsim::ui
