#include "ui/views/yarn_library/yarn_delegate.h"

#include "ui/views/style/appearance.h"
#include "ui/views/yarn_library/yarn_model.h"

#include <QApplication>
#include <QLinearGradient>
#include <QPainterPath>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kSwatchWidth = 34;

/// The list that has the keys shows its row in full colour, the others quietly.
bool isStrong(const QStyleOptionViewItem& option) {
    return (option.state & QStyle::State_Selected) && option.widget->hasFocus();
}

QColor ofState(const QStyleOptionViewItem& option, const QColor& plain) {
    return isStrong(option) ? option.palette.color(QPalette::HighlightedText) : plain;
}

void paintGround(QPainter& painter, const QStyleOptionViewItem& option) {
    QColor ground = option.palette.color(QPalette::Highlight);
    if (option.state & QStyle::State_Selected) {
        ground.setAlphaF(isStrong(option) ? 1.0F : 0.16F);
    } else if (option.state & QStyle::State_MouseOver) {
        ground.setAlphaF(0.07F);
    } else {
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(option.rect).adjusted(2, 1, -2, -1), 4, 4);
}

int paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QString& text, int left) {
    const int width = std::max(22, option.fontMetrics.horizontalAdvance(text) + 10);
    const QRect rect(left, option.rect.center().y() - 9, width, 19);
    painter.setPen(Qt::NoPen);
    painter.setBrush(option.palette.color(QPalette::Mid));
    painter.drawRoundedRect(rect, 4, 4);
    QFont bold = option.font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(option.palette.color(QPalette::WindowText));
    painter.drawText(rect, Qt::AlignCenter, text);
    return rect.right() + kMargin;
}

} // namespace

void paintYarn(QPainter& painter, const QRectF& rect, const QColor& colour, int plies) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath hull;
    hull.addRoundedRect(rect, rect.height() / 2, rect.height() / 2);
    QLinearGradient round(rect.topLeft(), rect.bottomLeft());
    round.setColorAt(0.0, colour.lighter(112));
    round.setColorAt(0.4, colour);
    round.setColorAt(1.0, colour.darker(150));
    painter.setPen(QPen(colour.lightness() < 60 ? colour.lighter(260) : colour.darker(170), 1));
    painter.setBrush(round);
    painter.drawPath(hull);
    painter.setClipPath(hull);
    QColor seam = colour.lightness() < 60 ? colour.lighter(220) : colour.darker(160);
    seam.setAlphaF(0.55F);
    painter.setPen(QPen(seam, 1.1));
    const double lead = rect.height() * 1.3 / std::clamp(plies, 1, 4) * 2;
    for (double x = rect.left() - rect.height(); plies > 1 && x < rect.right(); x += lead) {
        QPainterPath turn(QPointF(x, rect.bottom()));
        turn.cubicTo(x + lead * 0.7, rect.bottom(), x + lead * 0.5, rect.top(), x + lead * 1.2, rect.top());
        painter.drawPath(turn);
    }
    painter.restore();
}

void YarnDelegate::paint(QPainter* painter, const QStyleOptionViewItem& item,
                         const QModelIndex& index) const {
    QStyleOptionViewItem option = item;
    initStyleOption(&option, index);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintGround(*painter, option);
    int left = option.rect.left() + kMargin;
    if (const QString badge = index.data(BadgeRole).toString(); !badge.isEmpty()) {
        left = paintBadge(*painter, option, badge, left);
    }
    paintYarn(*painter, QRectF(left, option.rect.center().y() - 5.5, kSwatchWidth, 12),
              index.data(ColourRole).value<QColor>(), index.data(PliesRole).toInt());
    left += kSwatchWidth + kMargin + 2;
    const QRect text(left, option.rect.top() + 4, option.rect.right() - left - 4, option.rect.height() - 8);
    painter->setFont(option.font);
    painter->setPen(ofState(option, option.palette.color(QPalette::Text)));
    painter->drawText(
        text, Qt::AlignLeft | Qt::AlignTop,
        option.fontMetrics.elidedText(index.data(TitleRole).toString(), Qt::ElideRight, text.width()));
    painter->setPen(ofState(option, accentsOf(option.palette).faintText));
    painter->drawText(
        text, Qt::AlignLeft | Qt::AlignBottom,
        option.fontMetrics.elidedText(index.data(DetailRole).toString(), Qt::ElideRight, text.width()));
    painter->restore();
}

QSize YarnDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    return {140, 2 * option.fontMetrics.height() + 9};
}

} // namespace knittsim::ui
